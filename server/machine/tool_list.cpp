// Comparing a called tool with the list.
#include "machine/tool_list.hpp"

#include <cmath>

namespace cnclab::machine {

std::optional<ToolFault> ToolList::fault_of(const geometry::ToolChange& called) const {
  constexpr double kRounding_mm = 1e-9;  // 0.010 apart is within
  if (called.number == 0) return std::nullopt;
  const auto listed = tools_.find(called.number);
  if (listed == tools_.end()) return ToolFault{ToolFault::Kind::not_listed, called.number, 0, 0};
  const auto& [radius, length] = listed->second;
  const auto differs = [](double found, double wanted) {
    return !(std::abs(found - wanted) <= kTolerance_mm + kRounding_mm);
  };
  if (differs(called.radius_mm, radius)) {
    return ToolFault{ToolFault::Kind::radius_differs, called.number, called.radius_mm, radius};
  }
  if (differs(called.length_mm, length)) {
    return ToolFault{ToolFault::Kind::length_differs, called.number, called.length_mm, length};
  }
  return std::nullopt;
}

bool ToolList::needs_change(const geometry::ToolChange& called) const {
  return called.number != 0 && called.number != in_spindle_;
}

}  // namespace cnclab::machine
