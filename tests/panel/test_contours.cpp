// What START looks at before a compensated program moves, and when Input 1 counts (DEC-09, D-56, COMP, G-211).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

using testing::HasSubstr;

/// EX-080: the square with radius correction.
constexpr std::string_view kSquare =
    "P0000T001R+5000L+1000 P0001N001G68X+0Y+0Z+0N002G11F1000T01N003G01X+20000N004G42N005G01Y+30000N006G01X+30000"
    "N007G01Y+30000N008G01X-30000N009G01Y-30000N010G01Y-30000N011G40N012G01X-20000%";

/// A pocket whose last wall ends 3 mm before its first: no single corner shows it.
constexpr std::string_view kNarrowPocket =
    "P0000T001R+5000L+0 P0001N001G11F1000T01N002G42N003G01X+10000N004G01Y+50000N005G01X+60000N006G01Y-30000"
    "N007G01X-57000N008G40N009G01Y+10000%";

/// The contour behind N004 is reached only through the answer of Input 1.
constexpr std::string_view kContourBehindInput =
    "P0000T001R+5000L+0 P0001N001G11F1000T01N002G01X+5000N003G01X+5000N004G21P0001N010N005G42N006G01X+20000"
    "N007G01Y+30000N008G40N009G01X-20000N010G11M02%";

void start(Bench& bench) { bench.keys("AUTOMAT ENTER ENTER START"); }

TEST(Contours, ACompensatedProgramRunsToItsProgrammedEnd_EX080_MOD053) {
  Bench bench({.tape = std::string(kSquare)});
  start(bench);
  double most_x = 0;
  ASSERT_TRUE(bench.run_until([&] {
    most_x = std::max(most_x, bench.istwert(0));
    return !bench.control.is_running();
  })) << bench.picture();
  EXPECT_EQ(bench.snapshot().cause, machine::StopCause::program_end) << bench.picture();
  EXPECT_NEAR(most_x, 55, kStep_mm) << "EX-085: beside the side at X 50";
  EXPECT_NEAR(bench.istwert(0), 0, kStep_mm);
  EXPECT_NEAR(bench.istwert(1), 0, kStep_mm);
}

TEST(Contours, AContourThatCutsIntoItselfMovesNothing_DEC09) {
  Bench bench({.tape = std::string(kNarrowPocket)});
  start(bench);
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
  EXPECT_THAT(bench.monitor(15), HasSubstr("Korrektur nicht moeglich")) << bench.picture();
  EXPECT_THAT(bench.row(18), HasSubstr("N004")) << bench.picture();
  EXPECT_THAT(bench.row(18), HasSubstr("N007")) << bench.picture();
  EXPECT_EQ(bench.snapshot().steps, (std::array<std::int64_t, 4>{}));
}

TEST(Contours, WhileTheCheckIsUnderWayNothingMovesAndStopEndsIt_DEC09) {
  std::vector<std::function<void()>> jobs;
  Bench::Setup setup{.tape = std::string(kSquare)};
  setup.settings.long_work = [&jobs](std::function<void()> job) { jobs.push_back(std::move(job)); };
  Bench bench(setup);
  start(bench);
  bench.run_for(2000);
  EXPECT_TRUE(bench.control.is_running()) << bench.picture();
  EXPECT_EQ(bench.snapshot().steps, (std::array<std::int64_t, 4>{}));
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
  ASSERT_EQ(jobs.size(), 1u);
  jobs.front()();  // the answer comes too late and starts nothing
  bench.run_for(2000);
  EXPECT_FALSE(bench.control.is_running());
  EXPECT_EQ(bench.snapshot().steps, (std::array<std::int64_t, 4>{}));
}

TEST(Contours, TheCheckMayTakeItsTime_DEC09) {
  std::vector<std::function<void()>> jobs;
  Bench::Setup setup{.tape = std::string(kSquare)};
  setup.settings.long_work = [&jobs](std::function<void()> job) { jobs.push_back(std::move(job)); };
  Bench bench(setup);
  start(bench);
  bench.run_for(500);
  ASSERT_EQ(jobs.size(), 1u);
  jobs.front()();
  ASSERT_TRUE(bench.run_until([&] { return !bench.control.is_running(); })) << bench.picture();
  EXPECT_EQ(bench.snapshot().cause, machine::StopCause::program_end) << bench.picture();
}

TEST(Contours, OnTheLabMachineNoneIsFollowedUnchecked_DEC09) {
  for (const bool is_lab_machine : {false, true}) {
    SCOPED_TRACE(is_lab_machine ? "lab machine" : "training machine");
    Bench bench({.tape = std::string(kContourBehindInput), .is_lab_machine = is_lab_machine});
    start(bench);
    ASSERT_TRUE(bench.run_until([&] { return !bench.control.is_running(); })) << bench.picture();
    if (is_lab_machine) {
      EXPECT_THAT(bench.row(18), HasSubstr("N005")) << bench.picture();
      EXPECT_THAT(bench.row(18), HasSubstr("Input 1")) << bench.picture();
      EXPECT_NEAR(bench.istwert(0), 10, kStep_mm) << "everything before the contour was done";
    } else {
      EXPECT_EQ(bench.snapshot().cause, machine::StopCause::program_end) << bench.picture();
    }
  }
}

/// As kNarrowPocket, but behind the answer of Input 1: N004 to N010.
constexpr std::string_view kNarrowPocketBehindInput =
    "P0000T001R+5000L+0 P0001N001G11F1000T01N002G01Z+1000N003G01Z+1000N004G21P0001N020N005G42N006G01X+10000"
    "N007G01Y+50000N008G01X+60000N009G01Y-30000N010G01X-57000N011G40N012G01Y+10000N020G11M02%";

TEST(Contours, OneThatStartCouldNotReachIsCheckedWhenTheRunComesToIt_DEC09) {
  Bench bench({.tape = std::string(kNarrowPocketBehindInput)});
  start(bench);
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
  EXPECT_THAT(bench.monitor(15), HasSubstr("Korrektur nicht moeglich")) << bench.picture();
  EXPECT_THAT(bench.row(18), HasSubstr("P0001 N007: Werkzeug würde in P0001 N010 schneiden")) << bench.picture();
  EXPECT_NEAR(bench.istwert(2), 2, kStep_mm) << "what lies before the contour was done";
  EXPECT_NEAR(bench.istwert(0), 15, kStep_mm) << "the entry is right";
  EXPECT_NEAR(bench.istwert(1), 0, kStep_mm) << "N007 is not";
}

TEST(Contours, TheRunWaitsForTheCheckOfOneThatStartCouldNotReach_DEC09) {
  std::vector<std::function<void()>> jobs;
  Bench::Setup setup{.tape = std::string(kContourBehindInput)};
  setup.settings.long_work = [&jobs](std::function<void()> job) { jobs.push_back(std::move(job)); };
  Bench bench(setup);
  start(bench);
  ASSERT_EQ(jobs.size(), 1u);
  jobs.front()();
  ASSERT_TRUE(bench.run_until([&] { return jobs.size() == 2; })) << bench.picture();
  bench.run_for(5000);
  EXPECT_TRUE(bench.control.is_running());
  EXPECT_NEAR(bench.istwert(0), 10, kStep_mm) << "it stands before the contour";
  jobs.back()();
  ASSERT_TRUE(bench.run_until([&] { return !bench.control.is_running(); })) << bench.picture();
  EXPECT_EQ(bench.snapshot().cause, machine::StopCause::program_end) << bench.picture();
}

/// A question in the middle of the contour: N007 is driven when it is asked, and only its answer leads to N010.
TEST(Contours, OneWithAQuestionInsideIsLookedAtAgainWithEachAnswer_DEC09) {
  constexpr std::string_view kQuestionInside =
      "P0000T001R+5000L+0 P0001N001G11F1000T01N002G42N003G01X+10000N004G01Y+50000N005G01X+60000N006G01Y-30000"
      "N007G21P0001N020N008G01X-57000N009G40N010G01Y+10000N011G11M02N020G01Y-60000N021G40N022G01X+20000N023G11M02%";
  for (const bool jumps : {false, true}) {
    SCOPED_TRACE(jumps ? "to the sound end" : "into the wall");
    Bench bench({.tape = std::string(kQuestionInside)});
    bench.machine.set_input(0, 0, jumps);
    bench.run_for(20);
    start(bench);
    ASSERT_TRUE(bench.run_until([&] { return !bench.control.is_running(); })) << bench.picture();
    if (jumps)
      EXPECT_EQ(bench.snapshot().cause, machine::StopCause::program_end) << bench.picture();
    else
      EXPECT_THAT(bench.row(18), HasSubstr("P0001 N004: Werkzeug würde in P0001 N008 schneiden")) << bench.picture();
    EXPECT_GT(bench.istwert(1), jumps ? -70 : 20) << "the contour was driven up to the question";
  }
}

/// Inside a room, from outside: neither machine moves.
TEST(Contours, OneThatIsEnteredThroughAWallMovesNothing_COMP007) {
  constexpr std::string_view kRoom =
      "P0000T001R+5000L+0 P0001N001G11F1000T01N002G41N003G01Y+20000N004G01X+30000N005G01Y+40000N006G01X-60000"
      "N007G01Y-40000N008G01X+30000N009G40N010G01Y+20000N011G11M02%";
  for (const bool is_lab_machine : {false, true}) {
    SCOPED_TRACE(is_lab_machine ? "lab machine" : "training machine");
    Bench bench({.tape = std::string(kRoom), .is_lab_machine = is_lab_machine});
    start(bench);
    ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
    EXPECT_THAT(bench.monitor(15), HasSubstr("Korrektur nicht moeglich")) << bench.picture();
    EXPECT_THAT(bench.row(18), HasSubstr("P0001 N003: Einfahren würde in P0001 N008 schneiden")) << bench.picture();
    EXPECT_EQ(bench.snapshot().steps, (std::array<std::int64_t, 4>{}));
  }
}

/// The two-block rule: G21 is the fourth block, so the start of the second decides.
constexpr std::string_view kJumpOnInput =
    "P0001N001G11F1000N002G01X+10000N003G01Y+10000N004G21P0001N010N005G01X-10000N006G11M02N010G01Z+5000%";

TEST(Input1, CountsAsItWasTwoBlocksBefore_G211_D56) {
  struct Row {
    const char* name;
    std::uint64_t at_block;  ///< Input 1 becomes active when this block is under way
    bool jumps;
  };
  constexpr Row kRows[] = {
      {"before START", 0, true}, {"in the second block before", 2, false}, {"in the block before", 3, false}};
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    Bench bench({.tape = std::string(kJumpOnInput)});
    const auto activate = [&] { bench.machine.set_input(0, 0, true); };
    if (row.at_block == 0) activate();
    bench.run_for(20);  // the machine reports its inputs tick by tick
    start(bench);
    bool is_active = row.at_block == 0;
    ASSERT_TRUE(bench.run_until([&] {
      const machine::Snapshot now = bench.snapshot();
      const double way = now.istwert_mm[0] + now.istwert_mm[1];
      if (!is_active && now.sequence == row.at_block && way > 0.5) {
        activate();
        is_active = true;
      }
      return !bench.control.is_running();
    })) << bench.picture();
    EXPECT_TRUE(is_active);
    EXPECT_NEAR(bench.istwert(0), row.jumps ? 10 : 0, kStep_mm) << bench.picture();
    EXPECT_NEAR(bench.istwert(2), row.jumps ? 5 : 0, kStep_mm) << bench.picture();
  }
}

}  // namespace
}  // namespace cnclab::panel
