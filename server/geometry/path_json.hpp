// The printing twin of the item stream: path elements and events as JSON Lines (interfaces.md section 5).
#pragma once

#include <string>

#include "geometry/path_item.hpp"

namespace cnclab::geometry {

/// Appends a number in mm, degrees, mm/min or seconds: nine decimals, without trailing zeros, never "-0".
void append_number(std::string& text, double value);

/// Appends the item as one JSON object without line end.
///
/// returns  false, and appends nothing, for items that the format does not have: `Mark` and `SpindleDigits`
bool append_json(std::string& text, const PathItem& item);

}  // namespace cnclab::geometry
