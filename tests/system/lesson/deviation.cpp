// Walking along a drawing with a trace.
#include "deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cnclab::lesson {

namespace {

constexpr double kTie_mm = 1e-7;    ///< nearer than this is equally near (rule 3)
constexpr double kChord_mm = 0.25;  ///< length is measured in chords: rounding to steps makes shorter ones too long

double largest_axis(const Point& a, const Point& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

struct Place {
  std::size_t element = 0;
  double way_mm = 0;  ///< within the element
};

struct Gap {
  double axis_mm = std::numeric_limits<double>::infinity();
  double space_mm = std::numeric_limits<double>::infinity();
};

double most_space_of(const Drawing& drawing, const Tolerance& tolerance) {
  return std::sqrt(drawing.moving_axes()) * tolerance.step_mm / 2 + tolerance.noise_mm;
}

class Marker {
 public:
  Marker(const Drawing& drawing, const Tolerance& tolerance)
      : drawing_(drawing),
        behind_mm_(4 * tolerance.step_mm),
        ahead_mm_(3 * tolerance.way_per_tick_mm + 4 * tolerance.step_mm),
        most_space_mm_(most_space_of(drawing, tolerance)) {
    double start = 0;
    for (const Element& element : drawing.elements()) {
      starts_.push_back(start);
      start += element.length_mm();
    }
  }

  [[nodiscard]] double reached_mm() const { return furthest_; }
  [[nodiscard]] std::size_t element() const { return place_.element; }

  /// Rules 1 to 3: moves on; returns the tick's deviation.
  Gap follow(const Point& p) {
    const double low = furthest_ - behind_mm_, high = furthest_ + ahead_mm_;
    Gap gap;
    bool is_settled = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      const Element& element = drawing_.elements()[i];
      const double from = low - starts_[i], to = high - starts_[i];
      if (to < 0 || from > element.length_mm()) continue;
      const double way = element.nearest(p, from, to);
      const double space = distance(p, element.at(way));
      gap.space_mm = std::min(gap.space_mm, space);
      gap.axis_mm = std::min(gap.axis_mm, axis_gap_on(element, p, from, to));
      const bool is_inside = way > std::max(from, 0.0) && way < std::min(to, element.length_mm());
      if (is_settled || space >= nearest - kTie_mm) continue;
      nearest = space;
      place_ = {i, way};
      is_settled = is_inside && space <= most_space_mm_;
    }
    furthest_ = std::max(furthest_, starts_[place_.element] + place_.way_mm);
    return gap;
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
  double behind_mm_, ahead_mm_, most_space_mm_;
  std::vector<double> starts_;
  Place place_;
  double furthest_ = 0;
};

std::string place_of(const TraceRow& row) {
  char text[160];
  std::snprintf(text, sizeof text, "at %.3f s, P%04d N%03d, X %.3f Y %.3f Z %.3f from the start", row.time_s,
                row.program, row.block, row.position[0], row.position[1], row.position[2]);
  return text;
}

/// Rule 4: the way from one tick to the next, rounding included.
bool is_jump(const TraceRow& before, const TraceRow& now, const Tolerance& tolerance) {
  const double most = tolerance.way_per_tick_mm + std::sqrt(3.0) * tolerance.step_mm;
  return distance(before.position, now.position) > most;
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
  Comparison result;
  result.drawn_mm = drawing.length_mm();
  if (trace.empty() || drawing.elements().empty()) {
    result.fault = "there is nothing to compare";
    return result;
  }
  const double most_axis = tolerance.step_mm / 2 + tolerance.noise_mm;
  const double most_space = most_space_of(drawing, tolerance);
  Marker marker(drawing, tolerance);
  Ruler ruler;
  const TraceRow at_start{};  // the tool stands at the drawing's first point
  const TraceRow* before = &at_start;
  for (const TraceRow& row : trace) {
    const Gap gap = marker.follow(row.position);
    result.largest_space_mm = std::max(result.largest_space_mm, gap.space_mm);
    result.largest_axis_mm = std::max(result.largest_axis_mm, gap.axis_mm);
    ruler.add(row.position, marker.element());
    if (result.fault.empty() && (gap.axis_mm > most_axis || gap.space_mm > most_space)) {
      result.fault = in_mm(gap.axis_mm) + " off in an axis, " + in_mm(gap.space_mm) + " in space, " + place_of(row);
    }
    if (result.fault.empty() && is_jump(*before, row, tolerance)) {
      result.fault = "a jump of " + in_mm(distance(before->position, row.position)) + " in one tick, " + place_of(row);
    }
    before = &row;
  }
  result.reached_mm = marker.reached_mm();
  result.measured_mm = ruler.length_mm();
  result.seconds = trace.back().time_s - trace.front().time_s;
  if (result.fault.empty() && expect == Expect::whole) {
    result.fault = end_fault(result, drawing, trace.back().position, tolerance);
  }
  return result;
}

double rested_s(const std::vector<TraceRow>& trace, const Point& at, const Tolerance& tolerance) {
  double rested = 0;
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const bool is_there = largest_axis(trace[i].position, at) <= tolerance.step_mm / 2 + tolerance.noise_mm;
    if (is_there && trace[i].position == trace[i - 1].position) rested += trace[i].time_s - trace[i - 1].time_s;
  }
  return rested;
}

}  // namespace cnclab::lesson
