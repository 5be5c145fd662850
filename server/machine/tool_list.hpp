// The instructor's list of the tools that lie at the lab machine, and which of them is in the spindle (DEC-29).
#pragma once

#include <map>
#include <optional>

#include "geometry/path_item.hpp"

namespace cnclab::machine {

struct ListedTool {
  double radius_mm = 0, length_mm = 0;
  friend bool operator==(const ListedTool&, const ListedTool&) = default;
};

/// Why a student's T may not run on the lab machine: the block is refused before anything moves.
struct ToolFault {
  enum class Kind {
    not_listed,  ///< the instructor's list has no such tool
    radius_differs,
    length_differs,
  };
  Kind kind{};
  int number = 0;
  double found_mm = 0, listed_mm = 0;  ///< of the value that differs
  friend bool operator==(const ToolFault&, const ToolFault&) = default;
};

/// Value type, of the lab thread.
class ToolList {
 public:
  /// A student's R and L must agree with the list within this.
  static constexpr double kTolerance_mm = 0.01;

  /// number   1..99
  void put(int number, const ListedTool& tool) { tools_[number] = tool; }
  void remove(int number) { tools_.erase(number); }
  [[nodiscard]] const std::map<int, ListedTool>& tools() const { return tools_; }

  /// T00 calls no tool and is always right.
  [[nodiscard]] std::optional<ToolFault> fault_of(const geometry::ToolChange& called) const;

  /// Must the program halt like M00 for `Werkzeug Tnn einsetzen` before this T?
  [[nodiscard]] bool needs_change(const geometry::ToolChange& called) const;
  /// START after that halt, or the instructor's word: this tool is in the spindle now. 0: none, or unknown.
  void set_in_spindle(int number) { in_spindle_ = number; }
  [[nodiscard]] int in_spindle() const { return in_spindle_; }

 private:
  std::map<int, ListedTool> tools_;
  int in_spindle_ = 0;
};

}  // namespace cnclab::machine
