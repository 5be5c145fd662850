// How a benchmark prints a figure, and what it takes percentiles of.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace cnclab::bench {

/// `name value unit`, one line, as scripts read it.
inline void print_figure(std::string_view name, double value, std::string_view unit) {
  fmt::print("{} {:.6g} {}\n", name, value, unit);
}

/// The value below which `share` (0..1) of all lie; sorts.
[[nodiscard]] inline double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(share * last)];
}

/// The figures NAME_p50 and NAME_p99.
inline void print_percentiles(std::string_view name, std::vector<double>& values, std::string_view unit) {
  print_figure(fmt::format("{}_p50", name), percentile(values, 0.50), unit);
  print_figure(fmt::format("{}_p99", name), percentile(values, 0.99), unit);
}

}  // namespace cnclab::bench
