// Compensation as the interpreter sees it: orders to the stages, data of the tool, what excludes what.
#include <gmock/gmock.h>

#include "item_names.hpp"
#include "program/path_source.hpp"
#include "program/rebuild_modal.hpp"

namespace cnclab::program {
namespace {

using geometry::Line;
using geometry::Point;
using language::ErrorCode;
using testing::ElementsAre;

constexpr std::string_view kTools = "P0000T001R+5000L+1000T002R+2500L-500\n";

RunResult run_with_tools(std::string_view text, Start start = {}) {
  return run_text(std::string(kTools) + std::string(text), 1000, std::move(start));
}

using Names = std::vector<std::string>;

struct OrderRow {
  const char* name;
  const char* text;
  Names items;
};

class Orders : public testing::TestWithParam<OrderRow> {};

TEST_P(Orders, CarryTheToolOfTheirCall) {
  const RunResult run = run_with_tools(GetParam().text);
  EXPECT_FALSE(run.error) << language::explain(run.error.value_or(language::Error{}), language::Tongue::english);
  EXPECT_EQ(names_of(run), GetParam().items);
}

INSTANTIATE_TEST_SUITE_P(
    , Orders,
    testing::Values(
        OrderRow{"G410_left", "P0001N001G11T01N002G41%", Names{"tool 1 R5 L1", "radius left 5 xy", "end"}},
        OrderRow{"G410_right", "P0001N001G11T02N002G42%", Names{"tool 2 R2.5 L-0.5", "radius right 2.5 xy", "end"}},
        OrderRow{"G430_plus", "P0001N001G11T01N002G43%", Names{"tool 1 R5 L1", "radius plus 5 xy", "end"}},
        OrderRow{"G431_minus", "P0001N001G11T01N002G44%", Names{"tool 1 R5 L1", "radius minus 5 xy", "end"}},
        OrderRow{"G460_length", "P0001N001G11T02N002G46%", Names{"tool 2 R2.5 L-0.5", "length -0.5 xy", "end"}},
        OrderRow{"COMP001_in_the_active_plane", "P0001N001G11T01N002G18N003G41N004G46%",
                 Names{"tool 1 R5 L1", "mark", "radius left 5 xz", "length 1 xz", "end"}},
        OrderRow{"COMP003_no_tool_no_message", "P0001N001G41N002G46%", Names{"radius left 0 xy", "length 0 xy", "end"}},
        OrderRow{"D74_tool_without_a_row", "P0001N001G11T09N002G42%",
                 Names{"tool 9 R0 L0", "radius right 0 xy", "end"}},
        OrderRow{"D74_another_tool_acts_at_the_next_call", "P0001N001G11T01N002G41N003G11T02N004G90N005G41%",
                 Names{"tool 1 R5 L1", "radius left 5 xy", "tool 2 R2.5 L-0.5", "mark", "radius left 2.5 xy", "end"}},
        OrderRow{"G400_off", "P0001N001G11T01N002G42N003G40%",
                 Names{"tool 1 R5 L1", "radius right 5 xy", "radius off 0 xy", "end"}},
        OrderRow{"G450_off", "P0001N001G11T01N002G46N003G45%",
                 Names{"tool 1 R5 L1", "length 1 xy", "length 0 xy", "end"}},
        OrderRow{"G40_and_G45_with_nothing_to_cancel", "P0001N001G40N002G45N003G17%", Names{"mark", "mark", "end"}},
        OrderRow{"COMP002_both_at_once", "P0001N001G11T01N002G46N003G42N004G40N005G45%",
                 Names{"tool 1 R5 L1", "length 1 xy", "radius right 5 xy", "radius off 0 xy", "length 0 xy", "end"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(CompensationState, IsThatOfTheStatusLine_BLK202) {
  const RunResult run = run_with_tools("P0001N001G11T01N002G41N003G42N004G43N005G44N006G46N007G40N008G45%");
  ASSERT_FALSE(run.error);
  std::vector<RadiusCompensation> radius;
  std::vector<bool> length;
  for (const ExecutedBlock& block : run.blocks) {
    radius.push_back(block.modal.radius);
    length.push_back(block.modal.length_compensation);
  }
  using enum RadiusCompensation;
  EXPECT_THAT(radius, ElementsAre(off, left, right, plus, minus, minus, off, off));
  EXPECT_THAT(length, ElementsAre(false, false, false, false, false, true, true, false));
}

TEST(CompensationWays, CarryTheirNamedAxes_COMP015) {
  const RunResult run =
      run_with_tools("P0001N001G01X+1000F0500N002G00Y+1000Z+1000N003G02X+1000Y+0I+500J+0N004G01X+1Y+0Z+1N005G12U+5%");
  ASSERT_FALSE(run.error);
  std::vector<int> named;
  for (const geometry::PathItem& item : run.items) named.push_back(item.named_axes);
  EXPECT_THAT(named, ElementsAre(1, 6, 3, 7, 0, 0)) << "the fourth axis and the end name none";
}

/// Which blocks are a line: "N5" …
Names lines_of(const RunResult& run) {
  EXPECT_FALSE(run.error) << language::explain(run.error.value_or(language::Error{}), language::Tongue::english);
  Names names;
  for (const geometry::PathItem& item : run.items)
    if (const Line* line = std::get_if<Line>(&item.what))
      names.push_back("N" + std::to_string(item.source.block) + (line->from == line->to ? " stays" : ""));
  return names;
}

TEST(CompensationWays, OfNothingEnterAndLeave_D72) {
  EXPECT_THAT(lines_of(run_with_tools("P0001N001G01X+0F0500N002G00Y+0Z+0%")), ElementsAre());
  EXPECT_THAT(
      lines_of(run_with_tools("P0001N001G11T01N002G43N003G00X+5N004G00X+0N005G40N006G00Y+0N007G00X+0N008G00X+0%")),
      ElementsAre("N3", "N4 stays", "N6 stays", "N7 stays"))
      << "with N7 the axis is where the program says, and N8 is nothing again";
  EXPECT_THAT(lines_of(run_with_tools("P0001N001G11T01F0100N002G46N003G01Z+0N004G45N005G01X+0N006G01Z+0N007G01Z+0%")),
              ElementsAre("N3 stays", "N5 stays", "N6 stays"));
  EXPECT_THAT(lines_of(run_with_tools("P0001N001G11T01F0100N002G41N003G01M08N004G01X+1000N005G40N006G01Y+0N007G01Y+1"
                                      "N008G01Y+0%")),
              ElementsAre("N4", "N6 stays", "N7"))
      << "a block without axes is no way; the contour is left with the next way in the plane";
}

TEST(CompensationWays, StayNoElementWithoutATool_COMP003) {
  EXPECT_THAT(lines_of(run_with_tools("P0001N001G43N002G00X+1N003G40N004G00X+0%")), ElementsAre("N2"));
}

TEST(CompensationPosition, IsTheProgrammedOne_COMP020) {
  const RunResult run = run_with_tools("P0001N001G11T01F0500N002G42N003G01X+20000N004G01Y+3000N005G90N006G01X#65Y#64%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{3000, 20'000, 0}));
  EXPECT_EQ(all_of<Line>(run).back().to, (Point{3, 20, 0}));
}

/// The path of the tool's centre of a program's ways.
std::string path_of(std::string_view text) {
  auto source = PathSource::begin(programs_of(std::string(kTools) + std::string(text)), wide_settings(), {});
  if (!source) return "no source";
  RunResult run;
  while (!source->ended())
    if (!source->step(run.items)) return "fault";
  std::string path;
  for (const geometry::PathItem& item : run.items) {
    if (!std::holds_alternative<Line>(item.what) && !std::holds_alternative<geometry::Arc>(item.what)) continue;
    geometry::PathItem way = item;
    way.source = {};  // the blocks have other numbers
    geometry::append_json(path, way);
  }
  return path;
}

TEST(CompensationPath, DoesNotDependOnHowItsDimensionsAreGiven_COMP008_G911) {
  for (const std::string side : {"G41", "G42", "G43", "G44"}) {
    const std::string head = "P0001N001G11T01F0500N002" + side;
    const std::string chained = path_of(head +
                                        "N003G01X+20000N004G01X+30000N006G01Y+30000N008G01X-30000N009G40"
                                        "N010G01X-20000%");
    EXPECT_NE(chained, "fault") << side;
    EXPECT_EQ(path_of(head + "N003G01X+20000N004G01X+30000N005G90N006G01Y+30000N007G91N008G01X-30000N009G40"
                             "N010G01X-20000%"),
              chained)
        << side;
    EXPECT_EQ(path_of(head + "N003G90N004G01X+20000N005G01X+50000N006G91N007G01Y+30000N008G90N009G01X+20000N010G40"
                             "N011G01X+0%"),
              chained)
        << side;
  }
}

TEST(CompensationStart, SollwertIsIstwertWithoutWhatIsLeft_D75) {
  Start start;
  start.position = {15, 27.5, -3, 4};
  start.compensation_mm = {-5, 2.5, 0};
  const RunResult run = run_text("P0001N001G01X+1000F0500N002G90N003G01Y#65Z+0%", 9, start);
  ASSERT_FALSE(run.error);
  const auto lines = all_of<Line>(run);
  EXPECT_EQ(lines.at(0).from, (Point{20, 25, -3, 4}));
  EXPECT_EQ(lines.at(0).to, (Point{21, 25, -3, 4}));
  EXPECT_EQ(lines.at(1).to, (Point{21, 25, 0, 4}));
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{21'000, 25'000, 0}));
}

TEST(CompensationStart, WaysOfNothingLeaveWhatIsLeft_D75) {
  Start start;
  start.compensation_mm = {5, 0, 0};
  EXPECT_THAT(lines_of(run_text("P0001N001G00Z+0N002G00Y+0N003G00X+0%", 9, start)),
              ElementsAre("N1 stays", "N2 stays"));
}

TEST(CompensationStart, TellsTheStagesWhichPlaneIsToBeLeft_D75) {
  Start start;
  start.compensation_mm = {5, 0, 0};
  start.modal.plane = geometry::Plane::xz;
  EXPECT_THAT(names_of(run_text("P0001N001G00Z+0N002G00X+0%", 9, start)),
              ElementsAre("radius off 0 xz", "rapid", "end"));
  start.modal.plane = geometry::Plane::yz;
  EXPECT_THAT(names_of(run_text("P0001N001G00Z+0N002G00X+0N003G00X+0%", 9, start)),
              ElementsAre("rapid", "rapid", "end"))
      << "a length is left with its own axis";
}

TEST(CompensationStart, TellsTheStagesWhatIsInForce_D75) {
  Start start;
  start.modal.radius = RadiusCompensation::left;
  start.modal.length_compensation = true;
  start.modal.tool = 2;
  start.modal.tool_radius = {5000};
  start.modal.tool_length = {1000};
  const RunResult run = run_with_tools("P0001N001G01X+1000F0500N002G01X+1000%", start);
  EXPECT_THAT(names_of(run), ElementsAre("radius left 5 xy", "length 1 xy", "line", "line", "end"))
      << "with the tool of the call, not with the present one (D-74)";
  EXPECT_EQ(run.items[1].sequence, 1u);
  EXPECT_FALSE(run.items[1].ends_block);
}

TEST(CompensationStart, InTheMiddleIsThatOfTheBlocksBefore_DEC26) {
  const ProgramSet programs =
      programs_of(std::string(kTools) + "P0001N001G11T01N002G42N003G11T02N004G46N005G17N006G40N007G45N008G43N009G17%");
  const auto modal = [&](std::uint16_t block) { return rebuild_modal(programs, *programs.find(1), block, {}).value(); };
  EXPECT_EQ(modal(5).radius, RadiusCompensation::right);
  EXPECT_EQ(modal(5).tool_radius.value, 5000);
  EXPECT_TRUE(modal(5).length_compensation);
  EXPECT_EQ(modal(5).tool_length.value, -500);
  EXPECT_EQ(modal(8).tool_radius.value, 0);
  EXPECT_EQ(modal(8).tool_length.value, 0);
  EXPECT_FALSE(modal(8).length_compensation);
  EXPECT_EQ(modal(9).radius, RadiusCompensation::plus);
  EXPECT_EQ(modal(9).tool_radius.value, 2500);
}

struct OffsetErrorRow {
  const char* name;
  const char* text;
  ErrorCode code;
  int block;
};

class CompensationErrors : public testing::TestWithParam<OffsetErrorRow> {};

TEST_P(CompensationErrors, NameTheBlock) {
  const RunResult run = run_with_tools(GetParam().text);
  ASSERT_EQ(run.code(), GetParam().code);
  EXPECT_EQ(run.error->block, GetParam().block);
}

INSTANTIATE_TEST_SUITE_P(
    , CompensationErrors,
    testing::Values(
        OffsetErrorRow{"D69_plane_under_G41", "P0001N001G41N002G18%", ErrorCode::plane_locked, 2},
        OffsetErrorRow{"D69_plane_under_G42", "P0001N001G42N002G19%", ErrorCode::plane_locked, 2},
        OffsetErrorRow{"D69_plane_under_G43", "P0001N001G43N002G19%", ErrorCode::plane_locked, 2},
        OffsetErrorRow{"D69_plane_under_G44", "P0001N001G44N002G19%", ErrorCode::plane_locked, 2},
        OffsetErrorRow{"D69_plane_under_G46", "P0001N001G46N002G18%", ErrorCode::plane_locked, 2},
        OffsetErrorRow{"D69_back_to_G17", "P0001N001G18N002G46N003G17%", ErrorCode::plane_locked, 3},
        OffsetErrorRow{"D64_G68_under_G41", "P0001N001G41N002G68X+0%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G68_under_G42", "P0001N001G42N002G68X+0%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G68_under_G43", "P0001N001G43N002G68X+0%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G68_under_G44", "P0001N001G44N002G68X+0%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G68_under_G46", "P0001N001G46N002G68X+0%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G69_under_G41", "P0001N001G41N002G69X+0%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G69_under_G46", "P0001N001G46N002G69Z-1000%", ErrorCode::compensation_impossible, 2},
        OffsetErrorRow{"D64_G68_before_the_contour_is_left",
                       "P0001N001G11T01F0100N002G41N003G01X+1000N004G40N005G68X+0%", ErrorCode::offset_not_left, 5},
        OffsetErrorRow{"D64_G68_before_an_axis_is_left",
                       "P0001N001G11T01F0100N002G43N003G01X+1000Y+1000N004G40N005G01X+1000N006G68X+0%",
                       ErrorCode::offset_not_left, 6},
        OffsetErrorRow{"D64_G69_before_the_length_is_left",
                       "P0001N001G11T01F0100N002G46N003G01Z-1000N004G45N005G69X-1000%", ErrorCode::offset_not_left, 5},
        OffsetErrorRow{"D64_G68_before_the_plane_that_was_left",
                       "P0001N001G11T01F0100N002G41N003G01X+1000N004G40N005G18N006G01Z+1N007G68X+0%",
                       ErrorCode::offset_not_left, 7},
        OffsetErrorRow{"D64_G68_after_G43_stood_still",
                       "P0001N001G11T01F0100N002G43N003G01X+1000N004G01X+0N005G40N006G68X+0%",
                       ErrorCode::offset_not_left, 6},
        OffsetErrorRow{"D68_G75_under_G41", "P0001N001G41N002G75X+1000%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"D68_G75_under_G42", "P0001N001G42N002G75X+1000%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"D68_G75_under_G43", "P0001N001G43N002G75X+1000%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"D68_G75_under_G44", "P0001N001G44N002G75X+1000%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"D68_G75_under_G46", "P0001N001G46N002G75X+1000%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"COMP018_G41_under_G75", "P0001N001G75X-1000N002G41%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"COMP018_G44_under_G75", "P0001N001G75X-1000N002G44%", ErrorCode::scale_not_allowed, 2},
        OffsetErrorRow{"COMP018_G46_under_G75", "P0001N001G75X-1000N002G46%", ErrorCode::scale_not_allowed, 2}),
    [](const auto& row) { return std::string(row.param.name); });

struct AllowedRow {
  const char* name;
  const char* text;
};

class CompensationAllows : public testing::TestWithParam<AllowedRow> {};

TEST_P(CompensationAllows, WhatDoesNotDisturbIt) {
  const RunResult run = run_with_tools(GetParam().text);
  EXPECT_FALSE(run.error) << language::explain(run.error.value_or(language::Error{}), language::Tongue::english);
}

INSTANTIATE_TEST_SUITE_P(
    , CompensationAllows,
    testing::Values(AllowedRow{"D69_the_plane_that_is_active_anyway", "P0001N001G41N002G17N003G46N004G17%"},
                    AllowedRow{"D69_plane_after_G40_and_G45", "P0001N001G41N002G46N003G40N004G45N005G18%"},
                    AllowedRow{"COMP008_G90_and_G91_under_G41", "P0001N001G41N002G90N003G91%"},
                    AllowedRow{"COMP018_G41_after_G74", "P0001N001G75X-1000N002G74N003G41%"},
                    AllowedRow{"COMP018_G40_and_G45_under_G75", "P0001N001G75X-1000N002G40N003G45%"},
                    AllowedRow{"D68_G75_after_G40", "P0001N001G41N002G40N003G75X+2000%"},
                    AllowedRow{"D64_G68_after_the_contour_is_left",
                               "P0001N001G11T01F0100N002G41N003G01X+1000N004G40N005G01Y+1000N006G68X+0N007G69X-1000%"},
                    AllowedRow{"D64_G68_after_each_axis_is_left",
                               "P0001N001G11T01F0100N002G43N003G01X+1000Y+1000N004G40N005G01X+1000Y+0N006G68X+0%"},
                    AllowedRow{"D64_G68_after_a_way_of_nothing_has_left",
                               "P0001N001G11T01F0100N002G41N003G01X+1000N004G40N005G01Y+0N006G68X+0%"},
                    AllowedRow{"D64_G68_after_the_length_is_left",
                               "P0001N001G11T01F0100N002G46N003G01Z-1000N004G45N005G00Z+0N006G68X+0%"},
                    AllowedRow{"D64_G68_after_G41_that_never_moved", "P0001N001G11T01N002G41N003G40N004G68X+0%"},
                    AllowedRow{"D62_fourth_axis_under_G41",
                               "P0001N001G11T01F0100N002G41N003G12U+1000N004G40N005G68X+0%"}),
    [](const auto& row) { return std::string(row.param.name); });

/// A table that came by tape may hold it (DEC-13): the radius is asked for where it acts.
TEST(NegativeRadius, StopsTheBlockThatTakesIt_D50_DEC56) {
  const std::string table = "P0000T001R-5000L+0\nP0001N001G11F0500T01N002";
  for (const std::string block :
       {"G41", "G42", "G43", "G44", "G84X+20000Y+0Z-1000Q-1000V001H0000", "G85X+20000Y+20000Z-1000Q-1000V001H0000"}) {
    SCOPED_TRACE(block);
    const RunResult run = run_text(table + block + "%");
    ASSERT_EQ(run.code(), ErrorCode::word_out_of_range);
    EXPECT_EQ(run.error->block, 2);
    EXPECT_EQ(run.error->word, 'T');
    EXPECT_THAT(run.error->detail, testing::HasSubstr("-5.000"));
    EXPECT_EQ(run.error->expected, "R >= 0");
  }
  EXPECT_FALSE(run_text(table + "G46N003G01Z-1000%").error) << "the length needs no radius";
  Start inside;
  inside.modal.radius = RadiusCompensation::left;
  inside.modal.tool_radius = {-5000};
  EXPECT_EQ(run_text("P0001N001G01X+1000F0500%", 9, inside).code(), ErrorCode::word_out_of_range)
      << "found in force by a start in the middle";
}

TEST(OffsetNotLeft, NamesTheAxesThatAreToBeDriven_D64) {
  const auto expected = [](const std::string& blocks) {
    const RunResult run = run_with_tools("P0001N001G11T01F0100" + blocks);
    return run.code() == ErrorCode::offset_not_left ? run.error->expected : "another error";
  };
  EXPECT_EQ(expected("N002G46N003G01Z-1000N004G45N005G68X+0%"), "G01 Z");
  EXPECT_EQ(expected("N002G41N003G01X+1000N004G40N005G68Z+0%"), "G01 X Y");
  EXPECT_EQ(expected("N002G43N003G01Y+1000N004G40N005G68Z+0%"), "G01 Y");
}

}  // namespace
}  // namespace cnclab::program
