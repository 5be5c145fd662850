// Screens on the wire: what changed between two screens as a ScreenUpdate, and its application.
#pragma once

#include <expected>
#include <string>

#include "shared/screen.hpp"

namespace cnclab::v1 {
class ScreenUpdate;
}

namespace cnclab {

/// Fills `update.rows` with the rows of `newer` that differ from `acknowledged`.
void write_rows(const Screen& acknowledged, const Screen& newer, v1::ScreenUpdate& update);

/// Applies an update; errors: a row outside the screen, spans that do not fill 80 columns, an unknown attribute.
[[nodiscard]] std::expected<Screen, std::string> apply_rows(const Screen& base, const v1::ScreenUpdate& update);

}  // namespace cnclab
