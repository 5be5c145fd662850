// A screen on paper (SYS-013, D-108): as text, and as a page that looks like the monitor.
#pragma once

#include <string>

#include "panel/media.hpp"
#include "shared/screen.hpp"

namespace cnclab::lab {

/// The files "NAME.txt" and "NAME.pdf", to be printed. Takes some milliseconds: for long work.
///
/// title   of the page, any text: who sat where, and when
[[nodiscard]] panel::PutFiles hardcopy_of(const Screen& screen, const std::string& title, const std::string& name);

/// "BILD-20261122-101500", local time.
[[nodiscard]] std::string hardcopy_name(std::int64_t unix_ms);

}  // namespace cnclab::lab
