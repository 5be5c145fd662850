// Writing the table.
#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cnclab::lesson {

std::string table_of(const std::vector<ReportRow>& rows) {
  std::string table = fmt::format("{:>7}  {:<8} {:<41} {:>6} {:>9} {:>9} {:>9}\n", "station", "student", "program",
                                  "time s", "path mm", "dev. axis", "in space");
  for (const ReportRow& row : rows) {
    const Comparison& c = row.comparison;
    table += fmt::format("{:>7}  {:<8} {:<41} {:>6.2f} {:>9.3f} {:>9.4f} {:>9.4f}{}\n", row.station, row.student,
                         row.title, row.seconds, c.drawn_mm, c.largest_axis_mm, c.largest_space_mm,
                         c.is_as_drawn() ? "" : "  NOT AS DRAWN: " + c.fault);
  }
  return table;
}

int parts_as_drawn(const std::vector<ReportRow>& rows) {
  return static_cast<int>(
      std::ranges::count_if(rows, [](const ReportRow& row) { return row.comparison.is_as_drawn(); }));
}

}  // namespace cnclab::lesson
