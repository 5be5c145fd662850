// The chain of stages.
#include "geometry/path_stages.hpp"

namespace cnclab::geometry {

struct PathStages::Impl {
  std::array<double, 3> shift_mm{};
};

PathStages::PathStages(const std::array<double, 3>& shift_mm) : impl_(std::make_unique<Impl>(shift_mm)) {}
PathStages::PathStages(const PathStages& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
PathStages::PathStages(PathStages&&) noexcept = default;
PathStages& PathStages::operator=(const PathStages& other) {
  *impl_ = *other.impl_;
  return *this;
}
PathStages& PathStages::operator=(PathStages&&) noexcept = default;
PathStages::~PathStages() = default;

std::expected<void, StageFault> PathStages::push(const PathItem& item, std::vector<PathItem>& out) {
  out.push_back(item);
  return {};
}

std::expected<void, StageFault> PathStages::flush(std::vector<PathItem>& out) {
  static_cast<void>(out);
  return {};
}

bool PathStages::holds() const { return false; }

const std::array<double, 3>& PathStages::shift_mm() const { return impl_->shift_mm; }

}  // namespace cnclab::geometry
