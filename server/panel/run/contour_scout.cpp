// Preflights from the beginning of one contour.
#include "panel/run/contour_scout.hpp"

#include <algorithm>
#include <utility>

namespace cnclab::panel {

ContourScout::ContourScout(LongWork long_work, program::PathSource at_contour)
    : long_work_(std::move(long_work)), at_contour_(std::move(at_contour)) {
  look();
}

void ContourScout::take_answer(bool input_1) {
  answers_.push_back(input_1);
  look();
}

void ContourScout::look() { preflight_.emplace(long_work_, at_contour_, answers_); }

bool ContourScout::has_looked() {
  if (!preflight_) return true;
  const std::optional<Preflight::Result> result = preflight_->result();
  if (!result) return false;
  preflight_.reset();
  sound_contours_ = result->sound_contours;
  fault_ = result->error;
  return true;
}

/// Behind an answer the block to blame may have been driven already: then the run ends where it is.
std::optional<language::Error> ContourScout::guard(std::vector<geometry::PathItem>& items) const {
  if (!fault_) return std::nullopt;
  const geometry::SourceBlock blamed{fault_->program, fault_->block};
  const auto first = answers_.empty() ? std::ranges::find(items, blamed, &geometry::PathItem::source) : items.begin();
  if (first == items.end() && answers_.empty()) return std::nullopt;
  items.erase(first, items.end());
  return fault_;
}

}  // namespace cnclab::panel
