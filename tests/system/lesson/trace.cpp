// Reading a trace.
#include "trace.hpp"

#include <array>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace cnclab::lesson {

namespace {

constexpr std::string_view kHeader = "t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block";
constexpr std::size_t kColumns = 9;

std::expected<std::array<double, kColumns>, std::string> numbers_of(const std::string& line) {
  std::array<double, kColumns> numbers{};
  const char* rest = line.c_str();
  for (std::size_t i = 0; i < kColumns; ++i) {
    char* end = nullptr;
    numbers[i] = std::strtod(rest, &end);
    if (end == rest) return std::unexpected("column " + std::to_string(i + 1) + " is no number");
    const bool is_last = i + 1 == kColumns;
    if (*end != (is_last ? '\0' : ',')) return std::unexpected("wrong number of columns");
    rest = end + 1;
  }
  return numbers;
}

}  // namespace

std::expected<std::vector<TraceRow>, std::string> read_trace(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  const auto next = [&] {
    if (!std::getline(lines, line)) return false;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  };
  if (!next() || line != kHeader) return std::unexpected("line 1: the header is `" + line + "`");
  std::vector<TraceRow> trace;
  for (int number = 2; next(); ++number) {
    const auto numbers = numbers_of(line);
    if (!numbers) return std::unexpected("line " + std::to_string(number) + ": " + numbers.error());
    const auto& n = *numbers;
    trace.push_back({n[0], {n[1], n[2], n[3]}, n[5], static_cast<int>(n[7]), static_cast<int>(n[8])});
  }
  if (trace.empty()) return std::unexpected("the trace has no row");
  return trace;
}

std::vector<TraceRow> seen_from(std::vector<TraceRow> trace, const Point& origin) {
  for (TraceRow& row : trace) {
    for (std::size_t i = 0; i < 3; ++i) row.position[i] -= origin[i];
  }
  return trace;
}

}  // namespace cnclab::lesson
