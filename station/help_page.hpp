// The page behind `?`: every key of the control and how it is pressed here, made from the keymap.
#pragma once

#include <string>
#include <vector>

#include "station/keymap.hpp"

namespace cnclab::station {

/// Lines of at most 80 columns.
[[nodiscard]] std::vector<std::string> help_lines(Language language);

/// The same table in Markdown, German and English beside each other: docs/keys.md.
[[nodiscard]] std::string key_table();

}  // namespace cnclab::station
