// Walking along a drawing with a trace.
#include "deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cnclab::lesson {

namespace {

constexpr double kTie_mm = 1e-7;     ///< nearer than this is equally near (rule 3)
constexpr double kChord_mm = 0.25;   ///< length is measured in chords: rounding to steps makes shorter ones too long

double largest_axis(const Point& a, const Point& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

struct Place {
  std::size_t element = 0;
  double way_mm = 0;  ///< within the element
};

class Marker {
 public:
  Marker(const Drawing& drawing, const Tolerance& tolerance)
      : drawing_(drawing),
        behind_mm_(4 * tolerance.step_mm),
        ahead_mm_(tolerance.way_per_tick_mm + 4 * tolerance.step_mm) {
    double start = 0;
    for (const Element& element : drawing.elements()) {
      starts_.push_back(start);
      start += element.length_mm();
    }
  }

  [[nodiscard]] double reached_mm() const { return reached_; }
  [[nodiscard]] std::size_t element() const { return place_.element; }

  /// Rule 1: moves to the nearest point; returns the distance in space.
  double follow(const Point& p) {
    double best_gap = std::numeric_limits<double>::infinity();
    const double low = reached_ - behind_mm_, high = reached_ + ahead_mm_;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      const Element& element = drawing_.elements()[i];
      if (starts_[i] > high || starts_[i] + element.length_mm() < low) continue;
      const double way = element.nearest(p, low - starts_[i], high - starts_[i]);
      const double gap = distance(p, element.at(way));
      if (gap < best_gap - kTie_mm) {
        best_gap = gap;
        place_ = {i, way};
      }
    }
    reached_ = starts_[place_.element] + place_.way_mm;
    return best_gap;
  }

  /// Rule 2: the smallest deviation of the worst axis at one point near the marker.
  [[nodiscard]] double axis_gap(const Point& p) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      const double low = reached_ - starts_[i] - behind_mm_, high = reached_ - starts_[i] + behind_mm_;
      if (high < 0 || low > drawing_.elements()[i].length_mm()) continue;
      best = std::min(best, axis_gap_on(drawing_.elements()[i], p, low, high));
    }
    return best;
  }

 private:
  /// On a piece this short every curve is as good as straight, so the worst axis' deviation has one lowest place.
  static double axis_gap_on(const Element& element, const Point& p, double low, double high) {
    low = std::clamp(low, 0.0, element.length_mm());
    high = std::clamp(high, 0.0, element.length_mm());
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings && high - low > 1e-9; ++i) {
      const double third = (high - low) / 3;
      if (largest_axis(p, element.at(low + third)) <= largest_axis(p, element.at(high - third))) {
        high -= third;
      } else {
        low += third;
      }
    }
    return largest_axis(p, element.at((low + high) / 2));
  }

  const Drawing& drawing_;
  double behind_mm_, ahead_mm_;
  std::vector<double> starts_;
  Place place_;
  double reached_ = 0;
};

std::string place_of(const TraceRow& row) {
  char text[160];
  std::snprintf(text, sizeof text, "at %.3f s, P%04d N%03d, X %.3f Y %.3f Z %.3f from the start", row.time_s,
                row.program, row.block, row.position[0], row.position[1], row.position[2]);
  return text;
}

std::string in_mm(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4f mm", value);
  return text;
}

/// Adds up chords along the trace, a new one at least at each corner of the drawing.
class Ruler {
 public:
  void add(const Point& p, std::size_t element) {
    if (element != element_ && distance(from_, last_) > 0) close_chord();
    element_ = element;
    last_ = p;
    if (distance(from_, last_) >= kChord_mm) close_chord();
  }
  [[nodiscard]] double length_mm() const { return length_ + distance(from_, last_); }

 private:
  void close_chord() {
    length_ += distance(from_, last_);
    from_ = last_;
  }
  Point from_{}, last_{};
  std::size_t element_ = 0;
  double length_ = 0;
};

std::string end_fault(const Comparison& result, const Drawing& drawing, const Point& last, const Tolerance& tolerance) {
  const double slack = tolerance.step_mm + tolerance.noise_mm;
  if (result.reached_mm < result.drawn_mm - 2 * slack) {
    return "the part is not complete: " + in_mm(result.reached_mm) + " of " + in_mm(result.drawn_mm);
  }
  if (largest_axis(last, drawing.end()) > slack / 2 + tolerance.noise_mm) {
    return "the last tick is " + in_mm(largest_axis(last, drawing.end())) + " away from the drawing's end";
  }
  // Each corner may be cut by the chord of one tick.
  const double corners = tolerance.way_per_tick_mm * static_cast<double>(drawing.elements().size());
  if (std::abs(result.measured_mm - result.drawn_mm) > tolerance.length_share * result.drawn_mm + corners) {
    return "the way measured along the trace is " + in_mm(result.measured_mm) + ", drawn are " + in_mm(result.drawn_mm);
  }
  return {};
}

}  // namespace

Comparison compare(const Drawing& drawing, const std::vector<TraceRow>& trace, const Tolerance& tolerance,
                   Expect expect) {
  Comparison result{.drawn_mm = drawing.length_mm()};
  if (trace.empty() || drawing.elements().empty()) {
    result.fault = "there is nothing to compare";
    return result;
  }
  const double most_axis = tolerance.step_mm / 2 + tolerance.noise_mm;
  const double most_space = std::sqrt(drawing.moving_axes()) * tolerance.step_mm / 2 + tolerance.noise_mm;
  Marker marker(drawing, tolerance);
  Ruler ruler;
  for (const TraceRow& row : trace) {
    const double space = marker.follow(row.position);
    const double axis = marker.axis_gap(row.position);
    result.largest_space_mm = std::max(result.largest_space_mm, space);
    result.largest_axis_mm = std::max(result.largest_axis_mm, axis);
    ruler.add(row.position, marker.element());
    if (result.fault.empty() && (axis > most_axis || space > most_space)) {
      result.fault = in_mm(axis) + " off in an axis, " + in_mm(space) + " in space, " + place_of(row);
    }
  }
  result.reached_mm = marker.reached_mm();
  result.measured_mm = ruler.length_mm();
  result.seconds = trace.back().time_s - trace.front().time_s;
  if (result.fault.empty() && expect == Expect::whole) {
    result.fault = end_fault(result, drawing, trace.back().position, tolerance);
  }
  return result;
}

}  // namespace cnclab::lesson
