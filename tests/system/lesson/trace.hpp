// The trace of a run as the instructor's `run trace` writes it: one row for each tick.
#pragma once

#include <expected>
#include <string>
#include <vector>

#include "drawing.hpp"

namespace cnclab::lesson {

struct TraceRow {
  double time_s = 0;
  Point position{};  ///< X, Y, Z in mm
  double feed_mm_per_min = 0;
  int program = 0, block = 0;
};

/// Reads `t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block` (interfaces, section 5).
///
/// errors   the line and what is wrong with it: another header, a missing column, no number, no row at all
[[nodiscard]] std::expected<std::vector<TraceRow>, std::string> read_trace(const std::string& csv);

/// The same points seen from `origin`.
[[nodiscard]] std::vector<TraceRow> seen_from(std::vector<TraceRow> trace, const Point& origin);

}  // namespace cnclab::lesson
