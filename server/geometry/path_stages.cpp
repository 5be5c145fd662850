// The chain of stages.
//
// Rounding hands over whole items in `ready`; the offset appends to the caller's vector; axes are shifted there, in
// place. So an item is copied once for each stage that has to hold it, and once into the result.
#include "geometry/path_stages.hpp"

#include "geometry/axis_offset.hpp"
#include "geometry/contour_check.hpp"
#include "geometry/contour_offset.hpp"
#include "geometry/corner_rounding.hpp"

namespace cnclab::geometry {

namespace {

using Outcome = std::expected<void, StageFault>;

}  // namespace

struct PathStages::Impl {
  explicit Impl(const std::array<double, 3>& start_mm) : axes(start_mm), shift_mm(start_mm) {}

  Outcome push(const PathItem& item, std::vector<PathItem>& out, ContourCheck* check) {
    if (rounder.is_indifferent_to(item)) return offset(item, out, check);
    const Outcome rounded = rounder.push(item, ready);
    if (Outcome passed = offset_ready(out, check); !passed) return passed;
    return rounded;
  }

  Outcome flush(std::vector<PathItem>& out, ContourCheck* check) {
    const Outcome rounded = rounder.flush(ready);
    if (Outcome passed = offset_ready(out, check); !passed) return passed;
    if (!rounded) return rounded;
    const std::size_t before = out.size();
    const Outcome finished = contour.flush(out, check);
    if (Outcome shifted = shift_axes(out, before); !shifted) return shifted;
    return finished;
  }

  Outcome offset_ready(std::vector<PathItem>& out, ContourCheck* check) {
    for (const PathItem& item : ready)
      if (Outcome passed = offset(item, out, check); !passed) return passed;
    return {};
  }

  Outcome offset(const PathItem& item, std::vector<PathItem>& out, ContourCheck* check) {
    const std::size_t before = out.size();
    const Outcome followed = contour.push(item, out, check);
    if (Outcome shifted = shift_axes(out, before); !shifted) return shifted;
    return followed;
  }

  Outcome shift_axes(std::vector<PathItem>& out, std::size_t first) {
    for (std::size_t i = first; i < out.size(); ++i) {
      if (Outcome shifted = axes.rewrite(out[i]); !shifted) {
        out.resize(i);
        return shifted;
      }
      for (std::size_t axis = 0; axis < shift_mm.size(); ++axis) out[i].shift_mm[axis] += axes.shift_mm()[axis];
    }
    const Point& plane = contour.shift();
    const std::array<double, 3>& axis = axes.shift_mm();
    shift_mm = {plane.x + axis[0], plane.y + axis[1], plane.z + axis[2]};
    return {};
  }

  CornerRounder rounder;
  ContourOffset contour;
  AxisOffset axes;
  std::array<double, 3> shift_mm;
  std::vector<PathItem> ready;  ///< between rounding and offset, within one call
};

PathStages::PathStages(const std::array<double, 3>& shift_mm) : impl_(std::make_unique<Impl>(shift_mm)) {}
PathStages::PathStages(const PathStages& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
PathStages::PathStages(PathStages&&) noexcept = default;
PathStages& PathStages::operator=(const PathStages& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
PathStages& PathStages::operator=(PathStages&&) noexcept = default;
PathStages::~PathStages() = default;

Outcome PathStages::push(const PathItem& item, std::vector<PathItem>& out, ContourCheck* check) {
  Outcome pushed = impl_->push(item, out, check);
  if (!pushed && check != nullptr) check->end();
  return pushed;
}

Outcome PathStages::flush(std::vector<PathItem>& out, ContourCheck* check) {
  Outcome flushed = impl_->flush(out, check);
  if (!flushed && check != nullptr) check->end();
  return flushed;
}

bool PathStages::holds() const { return impl_->rounder.holds() || impl_->contour.holds(); }

const std::array<double, 3>& PathStages::shift_mm() const { return impl_->shift_mm; }

}  // namespace cnclab::geometry
