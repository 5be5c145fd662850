// What of modal state and offset a run leaves behind, whatever ends it, seen by the next run in every mode that moves
// (MOD-026, D-39, D-75; COMP-006, COMP-015, COMP-016).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bench.hpp"
#include "panel/run/offset_record.hpp"

namespace cnclab::panel {
namespace {

using machine::StopCause;
using Shift = std::array<double, 3>;

/// R 5, L 4; the way N005 begins when everything before it stands in its offset.
struct Compensation {
  std::string_view name;
  std::string_view orders;    ///< N003
  std::string_view entry;     ///< N004
  std::string_view long_way;  ///< N005
  int axis;                   ///< of the long way
  Shift shift;                ///< Istwert minus Sollwert on it
  std::string_view status;    ///< in the status line
};

constexpr Compensation kCompensations[] = {
    {"off", "G11F3000", "G01X+10000", "G01X+90000", 0, {}, "G40 G45"},
    {"left", "G41", "G01X+10000", "G01X+90000", 0, {0, 5, 0}, "G41 G45"},
    {"right", "G42", "G01X+10000", "G01X+90000", 0, {0, -5, 0}, "G42 G45"},
    {"plus", "G43", "G01X+10000", "G01X+90000", 0, {5, 0, 0}, "G43 G45"},
    {"minus", "G44", "G01X+10000", "G01X+90000", 0, {-5, 0, 0}, "G44 G45"},
    {"length", "G46", "G01Z+10000", "G01Z+90000", 2, {0, 0, 4}, "G40 G46"},
};

enum class End : std::uint8_t {
  program_end,
  stop_and_menu,
  error,
  limit_switch,
  machine_halt,
  power_off,
  restart_of_server,
  contour_refused
};

struct EndRow {
  std::string_view name;
  End how;
};

constexpr EndRow kEnds[] = {
    {"end of the program", End::program_end}, {"STOP and MENU", End::stop_and_menu},
    {"a block that is wrong", End::error},    {"limit switch", End::limit_switch},
    {"MASCHINE HALT", End::machine_halt},     {"drives without current", End::power_off},
    {"server anew", End::restart_of_server},  {"a contour that START refuses", End::contour_refused},
};

enum class Next : std::uint8_t { automat, hand_input, teach_in };

struct NextRow {
  std::string_view name;
  Next mode;
};

constexpr NextRow kNexts[] = {
    {"AUTOMAT", Next::automat}, {"HANDEINGABE", Next::hand_input}, {"TEACH IN", Next::teach_in}};

/// Off its switch an axis can be driven only back, and under G44 that way is 10 mm shorter.
double way_after(End end) { return end == End::limit_switch ? -20 : 1; }

/// Beside a way back lies the other side, and G43 and G44 move against it.
Shift shift_after(const Compensation& compensation, End end) {
  Shift shift = compensation.shift;
  if (end != End::limit_switch) return shift;
  for (const std::size_t axis : {0U, 1U}) shift[axis] = -shift[axis];
  return shift;
}

/// P0001 ends as the row says, P0002 goes on, P0003 leaves the offset with another one,
/// and into the arc of P0004 no tool fits.
std::string tape_of(const Compensation& compensation, End end) {
  const std::string axis = compensation.axis == 0 ? "X" : "Z";
  const std::string long_way = end == End::limit_switch ? "G01" + axis + "+400000" : std::string(compensation.long_way);
  const std::string last = end == End::error ? "N006G01" + axis + "+1000F9999" : "";
  const std::string way = way_after(end) < 0 ? "-20000" : "+1000";
  return "P0000T001R+5000L+4000P0001N001G91N002G11F3000T01N003" + std::string(compensation.orders) + "N004" +
         std::string(compensation.entry) + "N005" + long_way + last + "P0002N001G91N002G01" + axis + way +
         "P0003N001G91N002G40N003G45N004G01X" + way + "Y+0Z" + way +
         "P0004N001G91N002G41N003G01X+10000N004G01X+20000N005G03X+0Y+6000I+0J+3000N006G01X-20000%";
}

void start_program(Bench& bench, int number) {
  bench.keys("MENU AUTOMAT CLEAR");
  bench.type(std::to_string(number));
  bench.keys("ENTER ENTER START");
}

/// Who looks at contours for START.
struct Checker {
  bool takes_its_time = false;
  std::vector<std::function<void()>> waiting{};

  void take(const std::function<void()>& job) {
    if (takes_its_time) return waiting.push_back(job);
    job();
  }
};

void end_run(Bench& bench, Checker& checker, const Compensation& compensation, End how) {
  const auto is_under_way = [&] { return bench.istwert(compensation.axis) > 40; };
  switch (how) {
    case End::program_end:
    case End::error:
    case End::limit_switch:
      break;
    case End::contour_refused:  // by the check that START has given away, so that the run ends without having begun
      ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
      checker.takes_its_time = true;
      start_program(bench, 4);
      bench.run_for(100);
      ASSERT_TRUE(bench.control.is_running()) << bench.picture();
      for (const std::function<void()>& job : checker.waiting) job();
      checker.takes_its_time = false;
      break;
    case End::stop_and_menu:
    case End::restart_of_server:
      ASSERT_TRUE(bench.run_until(is_under_way)) << bench.picture();
      bench.keys("STOP");
      break;
    case End::machine_halt:
      ASSERT_TRUE(bench.run_until(is_under_way)) << bench.picture();
      bench.channel->stop(StopCause::machine_halt);
      break;
    case End::power_off:
      ASSERT_TRUE(bench.run_until(is_under_way)) << bench.picture();
      ASSERT_TRUE(bench.channel->command(machine::PowerOff{}));
      bench.run_for(100);
      ASSERT_TRUE(bench.channel->command(machine::PowerOn{}));
      break;
  }
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
}

Shift istwerte(const Bench& bench) { return {bench.istwert(0), bench.istwert(1), bench.istwert(2)}; }

void expect_near(const Shift& found, const Shift& expected, const Bench& bench) {
  for (std::size_t axis = 0; axis < found.size(); ++axis)
    EXPECT_NEAR(found[axis], expected[axis], 2 * kStep_mm) << "XYZ"[axis] << "\n" << bench.picture();
}

void jog_back(Bench& bench, int axis) {
  const double before = bench.istwert(axis);
  bench.keys("MENU TEACH_IN ENTER");
  bench.keys(axis == 0 ? "MINUS_X START" : "MINUS_Z START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(axis) < before - 1; })) << bench.picture();
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
}

/// One more way.
void go_on(Bench& bench, const Compensation& compensation, End end, Next mode) {
  switch (mode) {
    case Next::automat:
      start_program(bench, 2);
      break;
    case Next::hand_input:
    case Next::teach_in:  // what it has taught is not run; the next line is keyed in
      bench.keys(compensation.axis == 0 ? "MENU HANDEINGABE ENTER" : "MENU HANDEINGABE ENTER ENTER ENTER");
      bench.type(way_after(end) < 0 ? "-20" : "1");
      bench.keys("START");
      break;
  }
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
}

void check(const Compensation& compensation, End end, Next next) {
  Checker checker;
  Bench::Setup setup{.tape = tape_of(compensation, end)};
  setup.settings.long_work = [&checker](const std::function<void()>& job) { checker.take(job); };
  Bench first(setup), anew(setup);
  start_program(first, 1);
  end_run(first, checker, compensation, end);
  Bench& bench = end == End::restart_of_server ? anew : first;
  if (end == End::restart_of_server) anew.control.restore_state(first.control.save_state());
  bench.run_for(20);
  if (next == Next::teach_in) jog_back(bench, compensation.axis);

  Shift expected = istwerte(bench);
  const Shift before = compensation.shift, after = shift_after(compensation, end);
  for (std::size_t axis = 0; axis < expected.size(); ++axis) expected[axis] += after[axis] - before[axis];
  expected[static_cast<std::size_t>(compensation.axis)] += way_after(end);
  go_on(bench, compensation, end, next);
  expect_near(istwerte(bench), expected, bench);
  EXPECT_TRUE(bench.picture().contains(compensation.status)) << bench.picture();

  start_program(bench, 3);
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
  for (std::size_t axis = 0; axis < expected.size(); ++axis)
    expected[axis] += (axis == 1 ? 0 : way_after(end)) - after[axis];
  expect_near(istwerte(bench), expected, bench);
}

TEST(OffsetLeft, IsNeitherEnteredTwiceNorLostWhateverEndsTheRun_MOD026_COMP016) {
  for (const Compensation& compensation : kCompensations)
    for (const EndRow& end : kEnds)
      for (const NextRow& next : kNexts) {
        SCOPED_TRACE(std::string(compensation.name) + ", " + std::string(end.name) + ", " + std::string(next.name));
        check(compensation, end.how, next.mode);
        if (testing::Test::HasFatalFailure()) return;
      }
}

geometry::PathItem way(std::uint64_t sequence, const geometry::PathElement& element, const Shift& shift_mm) {
  geometry::PathItem item;
  item.sequence = sequence;
  item.shift_mm = shift_mm;
  std::visit([&item](const auto& what) { item.what = what; }, element);
  return item;
}

/// Along X beside its left side, about the corner at (30, 0) and down; entered from (0, 0), left for (40, -20).
std::vector<geometry::PathItem> beside_a_corner() {
  using geometry::Arc;
  using geometry::Line;
  return {
      way(1, Line{.from = {0, 0}, .to = {10, 5}}, {0, 5, 0}), way(2, Line{.from = {10, 5}, .to = {30, 5}}, {0, 5, 0}),
      way(3, Arc{.from = {30, 5}, .to = {35, 0}, .center = {30, 0}}, {5, 0, 0}),
      way(3, Line{.from = {35, 0}, .to = {35, -20}}, {5, 0, 0}), way(5, Line{.from = {35, -20}, .to = {40, -20}}, {})};
}

void expect_shift(const Shift& found, const Shift& expected) {
  for (std::size_t axis = 0; axis < found.size(); ++axis) EXPECT_NEAR(found[axis], expected[axis], 1e-9) << "XYZ"[axis];
}

TEST(OffsetRecord, KnowsTheOffsetAtEveryPlaceOfAWay_D39) {
  OffsetRecord record({});
  record.take(beside_a_corner());
  const double half = 5 * std::sqrt(0.5);
  expect_shift(record.within(1, {5, 2.5, 0, 0}), {0, 2.5, 0});
  expect_shift(record.within(2, {20, 5, 0, 0}), {0, 5, 0});
  expect_shift(record.within(2, {20, 6, 7, 0}), {0, 5, 0});  // driven off its way by a limit switch
  expect_shift(record.within(3, {30 + half, half, 0, 0}), {half, half, 0});
  expect_shift(record.within(3, {35, -10, 0, 0}), {5, 0, 0});
  expect_shift(record.within(5, {37.5, -20, 0, 0}), {2.5, 0, 0});
  expect_shift(record.within(4, {0, 0, 0, 0}), {5, 0, 0});  // a block without a way
}

TEST(OffsetRecord, KeepsWhatLiesBehindABlock) {
  OffsetRecord record({1, 2, 3});
  expect_shift(record.behind(7), {1, 2, 3});
  record = OffsetRecord({});
  record.take(beside_a_corner());
  for (const std::uint64_t forgotten : {0U, 2U, 3U}) {
    record.forget_before(forgotten);
    expect_shift(record.behind(2), {0, 5, 0});
    expect_shift(record.behind(3), {5, 0, 0});
    expect_shift(record.behind(4), {5, 0, 0});
    expect_shift(record.behind(5), {});
  }
}

}  // namespace
}  // namespace cnclab::panel
