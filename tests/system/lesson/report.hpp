// The lesson's closing table.
#pragma once

#include <string>
#include <vector>

#include "deviation.hpp"

namespace cnclab::lesson {

struct ReportRow {
  int station = 0;
  std::string student, title;
  double seconds = 0;  ///< machine time
  Comparison comparison;
};

/// Station, student, program, machine time, path length, largest deviation per axis and in space in mm.
[[nodiscard]] std::string table_of(const std::vector<ReportRow>& rows);

[[nodiscard]] int parts_as_drawn(const std::vector<ReportRow>& rows);

}  // namespace cnclab::lesson
