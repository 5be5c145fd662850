// A bench for the stages: programs written as ways in a plane, and what comes out of them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "geometry/contour_check.hpp"
#include "geometry/path_math.hpp"
#include "geometry/path_stages.hpp"

namespace cnclab::geometry {

/// Readable failures.
inline void PrintTo(const Point& p, std::ostream* os) {
  *os << "(" << p.x << ", " << p.y << ", " << p.z << ", " << p.u << ")";
}

}  // namespace cnclab::geometry

namespace rig {

using namespace cnclab::geometry;

/// Block 1 switches the correction on, block 2 is the entry, block 3 the first of the contour.
inline constexpr std::size_t kEntryBlock = 2, kFirstBlock = 3;

inline constexpr std::array kPlanes{Plane::xy, Plane::xz, Plane::yz};

inline std::string name_of(Plane plane) { return plane == Plane::xy ? "XY" : plane == Plane::xz ? "XZ" : "YZ"; }

/// Items as the interpreter emits them: one block after the other, numbered from 1. Places are (first, second) in the
/// plane's own axes, so that one table serves all three planes.
class Part {
 public:
  explicit Part(Plane plane = Plane::xy) : plane_(plane) {}

  Part& from(double first, double second, double normal = 0) {
    at_ = place(first, second, normal);
    return *this;
  }
  Part& radius(OffsetSide side, double radius_mm) { return add(RadiusOffset{side, radius_mm, plane_}); }
  Part& left(double radius_mm) { return radius(OffsetSide::left, radius_mm); }
  Part& right(double radius_mm) { return radius(OffsetSide::right, radius_mm); }
  Part& off() { return radius(OffsetSide::off, 0); }
  Part& length(double length_mm) { return add(LengthOffset{length_mm, plane_}); }
  Part& rounding(double radius_mm) { return add(CornerRounding{radius_mm, plane_}); }
  Part& line(double first, double second) { return line(first, second, at_.*axes_of(plane_).normal); }
  Part& line(double first, double second, double normal) {
    const Point to = place(first, second, normal);
    add(Line{at_, to, feed_, is_rapid_});
    at_ = to;
    return *this;
  }
  Part& normal(double normal) { return line(at_.*axes_of(plane_).first, at_.*axes_of(plane_).second, normal); }
  /// An arc to a place about a centre, both absolute.
  Part& arc(Turn turn, double first, double second, double center_first, double center_second,
            std::optional<double> normal = {}) {
    const Point to = place(first, second, normal.value_or(at_.*axes_of(plane_).normal));
    add(Arc{at_, to, place(center_first, center_second, 0), turn, plane_, feed_});
    at_ = to;
    return *this;
  }
  Part& ccw(double first, double second, double center_first, double center_second) {
    return arc(Turn::counterclockwise, first, second, center_first, center_second);
  }
  Part& cw(double first, double second, double center_first, double center_second) {
    return arc(Turn::clockwise, first, second, center_first, center_second);
  }
  template <typename What>
  Part& add(const What& what) {
    PathItem item;
    item.sequence = items_.size() + 1;
    item.source = {1, static_cast<std::uint16_t>((item.sequence - 1) % 999 + 1)};
    item.ends_block = true;
    item.what = what;
    items_.push_back(item);
    return *this;
  }
  /// Words of the newest item: its axes, flags.
  Part& named(unsigned axes) {
    items_.back().named_axes = static_cast<std::uint8_t>(axes);
    return *this;
  }
  Part& feed(double feed_mm_per_min) {
    feed_ = feed_mm_per_min;
    return *this;
  }
  Part& rapid(bool is_rapid) {
    is_rapid_ = is_rapid;
    return *this;
  }
  PathItem& newest() { return items_.back(); }
  [[nodiscard]] const std::vector<PathItem>& items() const { return items_; }
  [[nodiscard]] Point at() const { return at_; }
  [[nodiscard]] Plane plane() const { return plane_; }
  [[nodiscard]] Point place(double first, double second, double normal) const {
    Point point;
    point.*axes_of(plane_).first = first;
    point.*axes_of(plane_).second = second;
    point.*axes_of(plane_).normal = normal;
    return point;
  }

 private:
  Plane plane_;
  Point at_;
  double feed_ = 1000;
  bool is_rapid_ = false;
  std::vector<PathItem> items_;
};

/// What came out of a whole part, and the fault that ended it.
struct Outcome {
  std::vector<PathItem> items;
  std::optional<StageFault> fault;
  std::array<double, 3> shift_mm{};
  std::vector<StageFault> gouges;
};

inline Outcome run(const Part& part, const std::array<double, 3>& shift_mm = {}) {
  Outcome outcome;
  PathStages stages(shift_mm);
  ContourCheck check;
  const auto keep = [&](const std::expected<void, StageFault>& result) {
    if (!result) outcome.fault = result.error();
    return result.has_value();
  };
  bool goes_on = true;
  for (const PathItem& item : part.items()) {
    goes_on = keep(stages.push(item, outcome.items, &check));
    if (!goes_on) break;
  }
  if (goes_on && keep(stages.flush(outcome.items, &check))) {
    EXPECT_FALSE(stages.holds());
  }
  outcome.shift_mm = stages.shift_mm();
  outcome.gouges = check.findings();
  return outcome;
}

/// One way in the plane: where it ends, and how.
struct Way {
  int block = 0;
  char form = 'L';  ///< L line, R counterclockwise arc, A clockwise arc
  double first = 0, second = 0, normal = 0;
  double length = 0;
};

inline std::vector<Way> ways_of(const std::vector<PathItem>& items, Plane plane) {
  std::vector<Way> ways;
  const PlaneAxes& axes = axes_of(plane);
  const auto note = [&](const PathItem& item, char form, const Point& to, double length) {
    ways.push_back({item.source.block, form, to.*axes.first, to.*axes.second, to.*axes.normal, length});
  };
  for (const PathItem& item : items) {
    if (const auto* line = std::get_if<Line>(&item.what)) note(item, 'L', line->to, length_of(*line));
    if (const auto* arc = std::get_if<Arc>(&item.what))
      note(item, arc->turn == Turn::clockwise ? 'A' : 'R', arc->to, length_of(*arc));
  }
  return ways;
}

inline void expect_ways(const std::vector<Way>& found, const std::vector<Way>& expected, const std::string& name,
                        double tolerance_mm = 1e-9) {
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string where = name + ", way " + std::to_string(i + 1);
    EXPECT_EQ(found[i].block, expected[i].block) << where;
    EXPECT_EQ(found[i].form, expected[i].form) << where;
    EXPECT_NEAR(found[i].first, expected[i].first, tolerance_mm) << where;
    EXPECT_NEAR(found[i].second, expected[i].second, tolerance_mm) << where;
    EXPECT_NEAR(found[i].normal, expected[i].normal, tolerance_mm) << where;
    if (expected[i].length > 0) {
      EXPECT_NEAR(found[i].length, expected[i].length, 1e-6) << where;
    }
  }
}

/// The invariants of `PathStages` that hold for every stream: joined, in order, no orders left, every block ended.
inline void expect_sound(const Outcome& outcome, const std::string& name) {
  std::optional<Point> at;
  std::uint64_t sequence = 0;
  const auto joined = [&](const Point& from, const Point& to) {
    if (at) {
      const double gap = std::hypot(std::hypot(from.x - at->x, from.y - at->y), from.z - at->z);
      EXPECT_LE(gap, 1e-6) << name;
    }
    at = to;
  };
  for (const PathItem& item : outcome.items) {
    EXPECT_GE(item.sequence, sequence) << name;
    sequence = item.sequence;
    if (const auto* line = std::get_if<Line>(&item.what)) {
      EXPECT_NE(line->from, line->to) << name << ": a line without way";
      joined(line->from, line->to);
    }
    if (const auto* arc = std::get_if<Arc>(&item.what)) joined(arc->from, arc->to);
    EXPECT_FALSE(std::holds_alternative<RadiusOffset>(item.what)) << name;
    EXPECT_FALSE(std::holds_alternative<LengthOffset>(item.what)) << name;
    EXPECT_FALSE(std::holds_alternative<CornerRounding>(item.what)) << name;
  }
}

}  // namespace rig
