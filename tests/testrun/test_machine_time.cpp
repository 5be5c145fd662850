// Machine time against closed formulas of the ramp (DEC-20).
#include <gtest/gtest.h>

#include "machine/machine_data.hpp"
#include "testrun/machine_time.hpp"

namespace cnclab::testrun {
namespace {

geometry::PathItem line(double from_x, double to_x, double feed, std::uint64_t sequence = 1) {
  geometry::PathItem item;
  item.sequence = sequence;
  item.ends_block = true;
  item.what = geometry::Line{.from = {.x = from_x}, .to = {.x = to_x}, .feed_mm_per_min = feed};
  return item;
}

/// From rest to rest with jumps of F START/STOP at both ends.
double time_of(double way, double feed_mm_per_s, const motion::Limits& limits) {
  const double a = limits.acceleration_mm_per_s2, v0 = std::min(limits.start_stop_mm_per_s, feed_mm_per_s);
  const double ramps = (feed_mm_per_s * feed_mm_per_s - v0 * v0) / a;  // both
  return 2 * (feed_mm_per_s - v0) / a + (way - ramps) / feed_mm_per_s;
}

TEST(MachineTime, ALineTakesItsRampsAndItsWay) {
  const motion::Limits limits = machine::motion_limits({});
  for (const double feed : {100.0, 1000.0, 3000.0}) {
    MachineTime time({}, limits);
    time.take(line(0, 100, feed));
    time.finish();
    EXPECT_NEAR(time.seconds(), time_of(100, feed / 60, limits), 0.005) << feed;
  }
}

TEST(MachineTime, LinesInOneDirectionAreOne) {
  const motion::Limits limits = machine::motion_limits({});
  MachineTime time({}, limits);
  for (int part = 0; part < 5000; ++part)
    time.take(line(part * 0.02, part * 0.02 + 0.02, 1000, static_cast<std::uint64_t>(part) + 1));
  time.finish();
  EXPECT_NEAR(time.seconds(), time_of(100, 1000.0 / 60, limits), 0.02);
}

TEST(MachineTime, DwellsCount) {
  MachineTime time({}, machine::motion_limits({}));
  geometry::PathItem dwell;
  dwell.sequence = 1;
  dwell.ends_block = true;
  dwell.what = geometry::Dwell{.seconds = 2.5};
  time.take(dwell);
  time.finish();
  EXPECT_NEAR(time.seconds(), 2.5, 0.005);
}

}  // namespace
}  // namespace cnclab::testrun
