// What a configuration file may be made of, looked at before its parser reads it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cnclab {

/// A place that lab.toml cannot have.
struct UnfitText {
  int line;            ///< from 1
  std::string reason;  ///< what stands there and what to write
  bool operator==(const UnfitText&) const = default;
};

/// The first place with a NUL byte, a letter beyond ASCII outside of comments and quotes (a typographic quotation mark, for instance), or a
/// text over several lines. The parser takes for granted that there is none of these, or says it in its own terms.
std::optional<UnfitText> unfit_text(std::string_view text);

}  // namespace cnclab
