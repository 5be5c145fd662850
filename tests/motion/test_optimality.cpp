// Time-optimal within the rules, and at a constant cost per block.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "path_rig.hpp"
#include "reference_planner.hpp"
#include "seeded.hpp"

namespace cnclab::motion {
namespace {

/// One piece of a random path, in numbers that RapidCheck shrinks and prints.
struct Step {
  int kind = 0, turn_deg = 0, way_um = 1, rise_um = 0, feed = 600;
};

std::ostream& operator<<(std::ostream& out, const Step& step) {
  return out << "{kind " << step.kind << " turn " << step.turn_deg << " way " << step.way_um << " rise " << step.rise_um
             << " F" << step.feed << '}';
}

rc::Gen<int> number(int least, int most) { return rc::gen::resize(100, rc::gen::inRange(least, most + 1)); }

rc::Gen<int> decades(int least, int most) {
  return rc::gen::map(number(0, 1000), [least, most](int n) {
    return static_cast<int>(std::lround(least * std::pow(static_cast<double>(most) / least, n / 1000.0)));
  });
}

rc::Gen<Step> a_step() {
  return rc::gen::build<Step>(
      rc::gen::set(&Step::kind, number(0, 11)), rc::gen::set(&Step::turn_deg, number(-180, 180)),
      rc::gen::set(&Step::way_um, decades(1, 8000)),
      rc::gen::set(&Step::rise_um, rc::gen::map(number(-3000, 3000), [](int n) { return n / 3 * 2; })),
      rc::gen::set(&Step::feed, decades(100, 4000)));
}

class PathBuilder {
 public:
  void add(const Step& step);
  std::vector<geometry::PathItem> items;

 private:
  void line(double mm, double rise, double feed, bool rapid = false) {
    const geometry::Point to{at_.x + mm * std::cos(heading_), at_.y + mm * std::sin(heading_), at_.z + rise, 0};
    items.push_back(item_of(geometry::Line{at_, to, feed, rapid}));
    at_ = to;
  }
  void arc(double radius, double angle, double rise, double feed);

  geometry::Point at_;
  double heading_ = 0;
};

/// Tangential to what was before.
void PathBuilder::arc(double radius, double angle, double rise, double feed) {
  const double side = angle > 0 ? 1 : -1;
  const geometry::Point center{at_.x - side * radius * std::sin(heading_), at_.y + side * radius * std::cos(heading_)};
  heading_ += angle;
  const geometry::Point to{center.x + side * radius * std::sin(heading_), center.y - side * radius * std::cos(heading_),
                           at_.z + rise};
  const auto turn = angle > 0 ? geometry::Turn::counterclockwise : geometry::Turn::clockwise;
  items.push_back(item_of(geometry::Arc{at_, to, center, turn, geometry::Plane::xy, feed}));
  at_ = to;
}

void PathBuilder::add(const Step& step) {
  const double mm = step.way_um / 1000.0, angle = step.turn_deg * std::numbers::pi / 180, feed = step.feed;
  constexpr int kLinks = 25;
  switch (step.kind) {
    case 0:
    case 1:
      heading_ += angle;
      return line(mm, 0, feed);
    case 2:
      heading_ += angle / 50;
      return line(mm, 0, feed);
    case 3:
      return line(mm, step.rise_um / 1000.0, feed);
    case 4:
    case 5:
      if (step.turn_deg != 0) arc(mm, angle, 0, feed);
      return;
    case 6:
      if (step.turn_deg != 0) arc(mm, angle, step.rise_um / 1000.0, feed);
      return;
    case 7:
      for (int i = 0; i < kLinks; ++i) {
        heading_ += angle / kLinks;
        line(mm / kLinks, 0, feed);
      }
      return;
    case 8:
      return line(mm, 0, 3000, true);
    case 9:
      line(mm, 0, feed);
      items.back().exact_stop = true;
      return;
    case 10:
      items.push_back(item_of(geometry::Dwell{0.01}));
      return;
    default:
      items.push_back(item_of(geometry::Mark{}));
  }
}

RC_GTEST_PROP(Optimality, TakesTheTimeOfTheReferencePlannerWithin1PerMille, ()) {
  RC_PRE(kSeeded);
  const auto steps = *rc::gen::resize(20, rc::gen::container<std::vector<Step>>(a_step()));
  const int batch = *number(1, 40);
  Limits limits;
  limits.f_max_mm_per_s = *number(600, 4000) / 60.0;
  limits.acceleration_mm_per_s2 = *decades(10, 900);
  limits.start_stop_mm_per_s = *decades(10, 600) / 60.0;
  PathBuilder path;
  for (const Step& step : steps) path.add(step);
  path.items.push_back(item_of(geometry::End{}));
  PathRig rig(limits, 1e-4);
  for (std::size_t i = 0; i < path.items.size(); ++i) {
    rig.append_unplanned(path.items[i]);
    if (i % static_cast<std::size_t>(batch) == 0) rig.planner().plan();
  }
  rig.planner().plan();
  RC_ASSERT(rig.run_out());
  const ReferenceTime expected = reference_time(rig.segments(), limits);
  const double dwells =
      static_cast<double>(std::ranges::count_if(
          path.items, [](const auto& item) { return std::holds_alternative<geometry::Dwell>(item.what); })) *
      0.01;
  const double took = rig.time_s() + dwells;  // the rig passes a dwell at once
  RC_LOG() << "took " << took << " s, reference " << expected.seconds << " s, " << expected.rests << " rests\n";
  RC_ASSERT(took >= expected.seconds * 0.999 - 1e-9);
  RC_ASSERT(took - 2 * rig.tick_s() * (expected.rests + dwells * 100 + 1) <= expected.seconds * 1.001);
}

/// Revisions for `blocks` blocks that are consumed as they come.
std::uint64_t revised_for(int blocks) {
  constexpr std::size_t kAhead = 8192;
  SegmentQueue queue;
  Planner planner(queue, {});
  geometry::Point at{40, 0, 0, 0};
  for (int i = 1; i <= blocks; ++i) {
    const double radius = 40 + 3 * std::sin(i * 0.9);
    const geometry::Point to{radius * std::cos(i * 0.01), radius * std::sin(i * 0.01), std::sin(i * 0.1), 0};
    if (!planner.append(line(at, to, 1500))) return 0;
    if (i % 100 == 0) planner.plan();
    while (queue.waiting() > kAhead) queue.pop();
    at = to;
  }
  return planner.revised();
}

TEST(Optimality, AMillionBlocksCostTenTimesAHundredThousand) {
  const auto few = static_cast<double>(revised_for(100'000)), many = static_cast<double>(revised_for(1'000'000));
  EXPECT_NEAR(many / few, 10, 2);
  EXPECT_LE(many, 2e6) << "each is revised at most twice";
  EXPECT_GE(many, 1e6) << "each is looked at";
}

TEST(Optimality, FullFeedOnATangentialChainOfShortSegments) {
  for (const double link_mm : {1.0, 0.1, 0.01, 0.002}) {
    PathRig rig;
    std::vector<geometry::PathItem> items;
    const int links = static_cast<int>(40 / link_mm);
    for (int i = 0; i < links; ++i) items.push_back(line({i * link_mm, 0, 0, 0}, {(i + 1) * link_mm, 0, 0, 0}, 3000));
    items.push_back(item_of(geometry::End{}));
    rig.append(items);
    ASSERT_TRUE(rig.run_out());
    const ReferenceTime expected = reference_time(rig.segments(), rig.limits());
    EXPECT_NEAR(rig.time_s(), expected.seconds, expected.seconds * 1e-3 + 2 * rig.tick_s()) << link_mm;
    double fastest = 0;
    for (const auto& sample : rig.samples()) fastest = std::max(fastest, sample.speed);
    EXPECT_NEAR(fastest, 50, 1e-9) << link_mm;
  }
}

}  // namespace
}  // namespace cnclab::motion
