// What a configuration file may be made of, looked at before its parser reads it.
#pragma once

#include <expected>
#include <string>
#include <string_view>

namespace cnclab {

/// A place that lab.toml cannot have.
struct UnfitText {
  int line;            ///< from 1
  std::string reason;  ///< what stands there and what to write
  bool operator==(const UnfitText&) const = default;
};

/// The same configuration in ASCII: comments left out, letters beyond ASCII in "quotes" written as \U00000000. The
/// parser (toml++ 3.3) leaves it undefined what becomes of such a letter anywhere else, so those are refused:
/// typographic quotation marks, for instance; so are NUL bytes, malformed UTF-8 and texts over several lines.
std::expected<std::string, UnfitText> ascii_configuration(std::string_view text);

}  // namespace cnclab
