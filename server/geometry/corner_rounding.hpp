// The stage of G10: an arc instead of the corner between two lines.
#pragma once

#include <expected>
#include <optional>
#include <vector>

#include "geometry/path_item.hpp"
#include "geometry/path_stages.hpp"

namespace cnclab::geometry {

/// Holds back each G01 (G61) line, and the items of its block behind it, until the next block shows whether a G10
/// follows; with a G10, until the second line is known.
class CornerRounder {
 public:
  /// May the item be passed by this stage without being shown to it? Nothing is held and nothing will be.
  [[nodiscard]] bool is_indifferent_to(const PathItem& item) const {
    return queue_.empty() && !can_be_rounded(item) && !std::holds_alternative<CornerRounding>(item.what);
  }

  /// Takes the next item; `ready` is replaced by what leaves now.
  /// errors   rounding_without_lines, rounding_too_large, naming the block of the G10
  [[nodiscard]] std::expected<void, StageFault> push(const PathItem& item, std::vector<PathItem>& ready);
  [[nodiscard]] std::expected<void, StageFault> flush(std::vector<PathItem>& ready);

  [[nodiscard]] bool holds() const { return !queue_.empty(); }

 private:
  [[nodiscard]] static bool can_be_rounded(const PathItem& item) {
    const auto* line = std::get_if<Line>(&item.what);
    return line != nullptr && !line->is_rapid && !item.is_fourth_axis && line->from != line->to;
  }
  void release(std::vector<PathItem>& ready);
  [[nodiscard]] std::expected<void, StageFault> take_behind_order(const PathItem& item, std::vector<PathItem>& ready);
  [[nodiscard]] std::expected<void, StageFault> round(const PathItem& item, std::vector<PathItem>& ready);

  std::vector<PathItem> queue_;       ///< [0] is the line, then what came behind it
  std::optional<std::size_t> order_;  ///< index of the G10 in queue_
};

}  // namespace cnclab::geometry
