// Text from files and command lines is UTF-8 or refused: the wire carries nothing else.
#pragma once

#include <optional>
#include <string_view>

#include "station/language.hpp"

namespace cnclab::station {

/// The first line, from 1, that is not UTF-8; nothing where all are.
[[nodiscard]] std::optional<int> line_not_utf8(std::string_view text);

/// What is wrong with such a text and what to do, to stand behind its name.
inline constexpr Text kNotUtf8{"kein UTF-8 (vielleicht Latin-1): bitte als UTF-8 speichern",
                               "not UTF-8 (Latin-1, perhaps): please save it as UTF-8"};

inline constexpr Text kNotUtf8Typed{"das Terminal schickt kein UTF-8: bitte auf UTF-8 stellen",
                                    "the terminal does not send UTF-8: please set it to UTF-8"};

}  // namespace cnclab::station
