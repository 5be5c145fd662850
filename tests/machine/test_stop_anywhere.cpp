// STOP in every kind of motion and wait: rest on the path, START goes on exactly there; the potentiometer acts at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "channel_rig.hpp"
#include "path_oracle.hpp"

namespace cnclab::machine {
namespace {

struct StopAnywhereRow {
  const char* name;
  std::vector<geometry::PathItem> items;
};

std::vector<geometry::PathItem> chain() {
  Items items;
  for (int i = 1; i <= 400; ++i) items.line_to({i * 0.05, 0.5 * std::sin(i * 0.02), 0, 0}, 1800);
  return items.add(geometry::End{});
}

/// As G85 runs it: outward in a meander, down, back with rapids.
std::vector<geometry::PathItem> cycle() {
  using geometry::Line;
  Items items;
  items.add(Line{{}, {0, 0, -2, 0}, 600, false});
  geometry::Point at{0, 0, -2, 0};
  for (int pass = 0; pass < 3; ++pass) {
    const geometry::Point across{pass % 2 == 0 ? 8.0 : 0.0, at.y, -2, 0};
    const geometry::Point up{across.x, at.y + 1.5, -2, 0};
    items.add(Line{at, across, 1500, false}).add(Line{across, up, 1500, false});
    at = up;
  }
  items.add(Line{at, {at.x, at.y, 3, 0}, 3000, true}).add(Line{{at.x, at.y, 3, 0}, {0, 0, 3, 0}, 3000, true});
  return items.add(geometry::End{});
}

std::vector<StopAnywhereRow> kinds() {
  using namespace geometry;
  const Point origin;
  std::vector<StopAnywhereRow> rows;
  rows.push_back({"line", Items().line_to({12, 7, -3, 0}, 2000).add(End{})});
  rows.push_back({"rapid", Items().add(Line{origin, {20, 10, 0, 0}, 3000, true}).add(End{})});
  rows.push_back(
      {"arc",
       Items().add(Arc{origin, {8, 8, 0, 0}, {0, 8, 0, 0}, Turn::counterclockwise, Plane::xy, 1500}).add(End{})});
  rows.push_back(
      {"full circle", Items().add(Arc{origin, origin, {-4, 0, 0, 0}, Turn::clockwise, Plane::xy, 1500}).add(End{})});
  rows.push_back(
      {"helix", Items().add(Arc{origin, {0, 0, -5, 0}, {0, 6, 0, 0}, Turn::clockwise, Plane::xy, 1500}).add(End{})});
  rows.push_back(
      {"arc in XZ", Items().add(Arc{origin, {5, 0, 5, 0}, {0, 0, 5, 0}, Turn::clockwise, Plane::xz, 1200}).add(End{})});
  rows.push_back({"fourth axis", Items().line_to({0, 0, 0, 15}, 1500).add(End{})});
  rows.push_back({"dwell", Items().line_to({1, 0, 0, 0}).add(Dwell{0.4}).line_to({2, 0, 0, 0}).add(End{})});
  rows.push_back({"chain of short lines", chain()});
  rows.push_back({"cycle", cycle()});
  auto exact = static_cast<std::vector<PathItem>>(Items().line_to({4, 0, 0, 0}).line_to({4, 4, 0, 0}).add(End{}));
  exact[0].exact_stop = exact[1].exact_stop = true;
  rows.push_back({"exact stop with creeping", exact});
  return rows;
}

class StopAnywhere : public testing::TestWithParam<StopAnywhereRow> {};

/// Ticks of the whole run when nobody interferes.
int undisturbed_ticks(const std::vector<geometry::PathItem>& items) {
  ChannelRig rig;
  rig.run(items);
  int ticks = 1;
  for (; rig.channel.snapshot().started; ++ticks) rig.tick();
  return ticks;
}

TEST_P(StopAnywhere, D39RestsOnThePathAndGoesOnExactlyThere) {
  const auto& items = GetParam().items;
  const PathOracle path(items, {});
  const int whole = undisturbed_ticks(items);
  for (int stop_at = 1; stop_at < whole; stop_at += 1 + whole / 25) {
    ChannelRig rig;
    rig.run(items);
    rig.tick(stop_at);
    rig.channel.stop(StopCause::operator_stop);
    rig.tick();
    ASSERT_TRUE(rig.tick_to_rest(2000));
    const Snapshot rest = rig.channel.snapshot();
    if (rest.cause == StopCause::program_end) continue;
    EXPECT_EQ(rest.cause, StopCause::operator_stop);
    const std::size_t index = rest.sequence == 0 ? 0 : rest.sequence - 1;
    if (path.is_motion(index)) {
      const geometry::Point at{rest.path_mm[0], rest.path_mm[1], rest.path_mm[2], rest.path_mm[3]};
      // A full turn's end looks like its start: asked from both.
      const double distance =
          std::min(path.place(index, at, 0).distance_mm, path.place(index, at, path.length_mm(index)).distance_mm);
      EXPECT_LT(distance, 1e-9) << "stopped at tick " << stop_at;
    }
    EXPECT_EQ(rig.tick(77).path_mm, rest.path_mm) << "rests";
    rig.go();
    EXPECT_GE(rig.tick().sequence, rest.sequence);
    ASSERT_TRUE(rig.tick_to_rest());
    EXPECT_EQ(rig.channel.snapshot().cause, StopCause::program_end);
    const auto& end = path.end(items.size() - 1);
    EXPECT_EQ(rig.channel.snapshot().path_mm, (std::array{end.x, end.y, end.z, end.u})) << stop_at;
  }
}

/// Two equal runs, one with a potentiometer that is turned after a while: do their speeds differ within 50 ms, in the
/// right direction? `is_free` tells whether the other one could have changed: it did not brake anyhow.
bool acts_within_50_ms(const std::vector<geometry::PathItem>& items, int change_at, double from, double to,
                       bool& is_free) {
  ChannelRig turned, kept;
  for (ChannelRig* rig : {&turned, &kept}) {
    rig->channel.set_override(from);
    rig->run(items);
    rig->tick(change_at);
  }
  const double start = kept.channel.snapshot().speed_mm_per_min;
  turned.channel.set_override(to);
  is_free = start > to * 3000;
  for (int tick = 0; tick < 50; ++tick) {
    const double other = turned.tick().speed_mm_per_min, same = kept.tick().speed_mm_per_min;
    if (to > from ? other > same : other < same) return true;
    is_free = is_free && same >= start;
  }
  return false;
}

TEST_P(StopAnywhere, DEC40PotentiometerActsWithinFiftyMillisecondsInBothDirections) {
  const auto& items = GetParam().items;
  const int whole = undisturbed_ticks(items);
  int up = 0, down = 0;
  for (int change_at = 1; change_at < whole; change_at += 1 + whole / 25) {
    bool is_free = false;
    if (acts_within_50_ms(items, change_at, 1, 0.05, is_free)) {
      ++down;
    } else {
      EXPECT_FALSE(is_free) << "turned down at tick " << change_at;
    }
    up += acts_within_50_ms(items, change_at, 0.05, 1, is_free) ? 1 : 0;
  }
  EXPECT_GT(down, 5);
  EXPECT_GT(up, 5);
}

std::string name_of(const testing::TestParamInfo<StopAnywhereRow>& row) {
  std::string name = row.param.name;
  std::ranges::replace_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, StopAnywhere, testing::ValuesIn(kinds()), name_of);

TEST(StopInWaits, D39WaitForAnInputIsKeptThroughStop) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Wait{1, 2}).line_to({1, 0, 0, 0}).add(geometry::End{});
  rig.run(items);
  rig.tick(10);
  rig.channel.stop(StopCause::operator_stop);
  EXPECT_EQ(rig.tick().state, MotionState::standstill);
  rig.go();
  EXPECT_EQ(rig.tick(5).state, MotionState::halted) << "waits again";
  rig.machine.simulated.set_input(1, 2, true);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::program_end);
}

TEST(StopInWaits, DEC40PotentiometerActsOnHandMotionAndReferenceRuns) {
  for (const bool by_hand : {true, false}) {
    ChannelRig rig;
    const bool taken =
        by_hand ? rig.channel.command(Jog{kLease, {1, 0, 0}}) : rig.channel.command(RunReference{kLease, {1, 0, 0}});
    ASSERT_TRUE(taken);
    const double fast = rig.tick(1000).speed_mm_per_min;
    rig.channel.set_override(0.5);
    EXPECT_LT(rig.tick().speed_mm_per_min, fast) << by_hand;
    const double slow = rig.tick(1000).speed_mm_per_min;
    EXPECT_NEAR(slow, fast / 2, 1e-6) << by_hand;
    rig.channel.set_override(0.8);
    EXPECT_GT(rig.tick().speed_mm_per_min, slow) << by_hand;
  }
}

}  // namespace
}  // namespace cnclab::machine
