// Pictures as PDF files, one page of A4 for each.
#pragma once

#include <expected>
#include <span>
#include <string>

#include "drawing/picture.hpp"

namespace cnclab::drawing {

/// The whole file. Each picture fills its page within a margin of 10 mm, upright or across as it fits better. The fonts
/// are those that every reader has, in Windows Latin 1: a letter that is not in it becomes "?". The same pictures give
/// the same bytes.
///
/// errors   in English: no page at all, or what went wrong in the library (memory)
[[nodiscard]] std::expected<std::string, std::string> pdf_of(std::span<const Picture> pages);

}  // namespace cnclab::drawing
