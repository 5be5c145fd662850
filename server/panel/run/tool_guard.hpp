// The tools of a run: on a machine with a tool list none cuts that is not the listed one, and somebody puts it in first
// (DEC-29).
//
//   items ──▶ ToolGuard ──▶ items, with a halt before each T whose tool is not in the spindle
//                 └──────▶ error: the block calls a tool that is not listed, or with another radius or length
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/error.hpp"
#include "machine/tool_list.hpp"

namespace cnclab::panel {

class ToolGuard {
 public:
  /// list       nothing: every tool may run and none is asked for
  /// in_force   the tool that START found called; number 0: none. It is called anew before the first way of the path,
  ///            so that the machine cuts with it and the list is asked for it too
  ToolGuard(std::optional<machine::ToolList> list, const geometry::ToolChange& in_force)
      : list_(std::move(list)), in_force_(in_force) {}

  /// Takes the items in the order of the path and adds what the tools need.
  /// returns  the error of the first tool that may not run: the items of its block and all behind it are gone
  [[nodiscard]] std::optional<language::Error> guard(std::vector<geometry::PathItem>& items);

  /// The tool that is to be put in before the block (PathItem::sequence) goes on; 0: none.
  [[nodiscard]] int due(std::uint64_t sequence) const;
  void forget_before(std::uint64_t sequence) { due_.erase(due_.begin(), due_.lower_bound(sequence)); }

 private:
  /// Adds the call of a tool behind what it needs.
  [[nodiscard]] std::optional<language::Error> call(const geometry::PathItem& place, const geometry::ToolChange& tool,
                                                    std::vector<geometry::PathItem>& out);

  std::optional<machine::ToolList> list_;
  geometry::ToolChange in_force_;
  std::map<std::uint64_t, int> due_;
};

}  // namespace cnclab::panel
