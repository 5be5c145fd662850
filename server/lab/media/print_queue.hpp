// The lab's printer: a queue of CUPS ([printer] queue).
#pragma once

#include <chrono>
#include <expected>
#include <string>

namespace cnclab::lab {

inline constexpr std::chrono::seconds kPrinterPatience{20};

/// Hands a PDF file to `lp -d QUEUE -t TITLE` and waits until it has taken it: for a thread that may wait. A program
/// that takes longer is ended.
/// errors   what `lp` said, one line; or why it could not be run
[[nodiscard]] std::expected<void, std::string> print_pages(const std::string& queue, const std::string& title,
                                                           const std::string& pdf,
                                                           std::chrono::milliseconds patience = kPrinterPatience);

}  // namespace cnclab::lab
