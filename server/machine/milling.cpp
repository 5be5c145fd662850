// Joining points into ways, cutting them, and telling what must not happen.
#include "machine/milling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cnclab::machine {

namespace {

geometry::Point place_of(const ToolPoint& point) { return {point.mm[0], point.mm[1], point.mm[2], 0}; }

double distance(const ToolPoint& a, const ToolPoint& b) {
  return std::hypot(a.mm[0] - b.mm[0], a.mm[1] - b.mm[1], a.mm[2] - b.mm[2]);
}

bool is_alike(const ToolPoint& a, const ToolPoint& b) {
  return a.radius_mm == b.radius_mm && a.source == b.source && a.is_rapid == b.is_rapid && a.spindle_on == b.spindle_on;
}

}  // namespace

void Milling::begin(const ToolPoint& point) {
  const geometry::Point top_center{point.mm[0], point.mm[1], 0, 0};
  auto piece = Workpiece::make(fitted(spec_), top_center);
  piece_ = piece ? std::make_unique<Workpiece>(std::move(*piece)) : nullptr;
  events_.clear();
  events_left_off_ = 0;
  was_noted_ = {};
  has_place_ = false;
}

void Milling::note(MillingEvent::Kind kind, const ToolPoint& point) {
  const auto index = static_cast<std::size_t>(kind);
  if (was_noted_[index] && noted_[index] == point.source) return;
  was_noted_[index] = true;
  noted_[index] = point.source;
  if (events_.size() >= kMostEvents) {
    ++events_left_off_;
    return;
  }
  events_.push_back({kind, point.tick, point.source, point.mm});
}

void Milling::cut_to(const ToolPoint& point) {
  // A tool without a radius meets the middle of a cell wherever it stands: none is further away than half a diagonal.
  const double radius = std::max(point.radius_mm, piece_->cell_mm() * std::numbers::sqrt2 / 2 + 2 * kEdge_mm);
  const Cut cut = piece_->cut(place_of(cut_), place_of(point), radius, kEdge_mm);
  cut_ = point;
  if (cut.contact_mm < kTouch_mm) return;
  if (point.is_rapid) note(MillingEvent::Kind::rapid_in_material, point);
  if (!point.spindle_on) note(MillingEvent::Kind::spindle_off_in_material, point);
}

void Milling::flush() {
  if (piece_ && has_place_ && distance(cut_, newest_) > 0) cut_to(newest_);
}

void Milling::take(const ToolPoint& point) {
  if (point.begins_run) begin(point);
  if (!piece_) return;
  const bool is_joined = has_place_ && !point.after_gap && !point.begins_run;
  if (!is_joined) {
    flush();
    cut_ = newest_ = point;
    has_place_ = true;
    return;
  }
  if (!is_alike(newest_, point)) flush();
  newest_ = point;
  if (distance(cut_, point) >= piece_->cell_mm() / 2) cut_to(point);
}

}  // namespace cnclab::machine
