// Zeros in machine steps.
#include "machine/zero_book.hpp"

namespace cnclab::machine {

void ZeroBook::keep(std::int64_t student, const Snapshot& now) {
  zeros_.erase(student);
  if (!now.is_referenced) return;
  Zero zero;
  zero.references_lost = now.references_lost;
  for (std::size_t i = 0; i < 3; ++i) {
    zero.steps[i] = static_cast<double>(now.steps[i]) - now.istwert_mm[i] * per_mm_[i];
  }
  zeros_.emplace(student, zero);
}

std::optional<std::array<double, 3>> ZeroBook::istwert(std::int64_t student, const Snapshot& now) const {
  if (!now.is_referenced) return std::nullopt;
  const auto kept = zeros_.find(student);
  const bool is_own = kept != zeros_.end() && kept->second.references_lost == now.references_lost;
  std::array<double, 3> mm{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double zero_steps = is_own ? kept->second.steps[i] : static_cast<double>(now.reference_steps[i]);
    mm[i] = (static_cast<double>(now.steps[i]) - zero_steps) / per_mm_[i];
  }
  return mm;
}

void ZeroBook::set_steps_per_mm(const std::array<double, 3>& steps_per_mm) {
  per_mm_ = steps_per_mm;
  zeros_.clear();
}

}  // namespace cnclab::machine
