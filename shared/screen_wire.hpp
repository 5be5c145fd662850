// Screens on the wire: what changed between two screens as a ScreenUpdate, and its application.
#pragma once

#include <cstdint>
#include <expected>
#include <string>

#include "shared/screen.hpp"

namespace cnclab::v1 {
class ScreenUpdate;
}

namespace cnclab {

/// How a changed row travels: with all its cells, or from the first that differs to the last (Hello.takes_parts).
enum class RowForm : std::uint8_t { whole, changed_part };

/// Fills `update.rows` with the rows of `newer` that differ from `acknowledged`.
void write_rows(const Screen& acknowledged, const Screen& newer, v1::ScreenUpdate& update,
                RowForm form = RowForm::whole);

/// Applies an update; errors: a row outside the screen, spans that do not fill 80 columns (or, in a part, none or too
/// many cells), an unknown attribute.
[[nodiscard]] std::expected<Screen, std::string> apply_rows(const Screen& base, const v1::ScreenUpdate& update);

}  // namespace cnclab
