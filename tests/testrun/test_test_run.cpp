// What the graphic test run finds, draws and measures (SYS-011, SYS-012).
#include <gmock/gmock.h>
#include <malloc.h>

#include <chrono>
#include <string>

#include "drawing/path_picture.hpp"
#include "language/tape.hpp"
#include "testrun/test_run.hpp"

namespace cnclab::testrun {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = Finding::Kind;

TestOrder order_of(std::string_view tape) {
  TestOrder order;
  for (language::ReadProgram& read : language::read_tape(tape, language::Reading::file).programs) {
    if (order.start.program == 1 && read.program.number == 1) order.start.block = read.program.blocks.front().number;
    order.programs.put(std::move(read.program));
  }
  order.workpiece = drawing::standard_workpiece({});
  order.travel = travel_about({}, order.data);
  return order;
}

TestRun run(TestOrder order) {
  auto test = TestRun::begin(std::move(order));
  if (!test) throw std::runtime_error(language::explain(test.error(), language::Tongue::english));
  while (!test->has_ended()) test->advance(100);
  return std::move(*test);
}

std::vector<std::string> texts_of(const TestRun& test) {
  std::vector<std::string> texts;
  for (const Finding& finding : test.findings()) texts.push_back(explain(finding, language::Tongue::german));
  return texts;
}

constexpr std::string_view kTools = "P0000T001R+5000L+0";

std::string with_tools(std::string_view program) { return std::string(kTools) + std::string(program) + "%"; }

TEST(TestRun, ASoundProgramHasNoFindings) {
  const TestRun test =
      run(order_of(with_tools("P0001N001G11F1000S1000T01M03N002G00Z+5000N003G00X+20000"
                              "N004G01Z-10000N005G01X-40000N006G00Z+30000N007G11M05")));
  EXPECT_THAT(texts_of(test), IsEmpty());
  EXPECT_EQ(test.blocks(), 7u);
  EXPECT_DOUBLE_EQ(test.path_mm(), 5 + 20 + 10 + 40 + 30);
  EXPECT_EQ(test.progress(), 1);
  EXPECT_NEAR(test.stock().removed_mm3(), (40 * 10 + 78.54) * 5, 25);
}

TEST(TestRun, TheFourthAxisIsNoWayOfTheTool_SYS_016) {
  EXPECT_DOUBLE_EQ(run(order_of("P0001N001G11F1000N002G12U+5000N003G01X+3000%")).path_mm(), 3);
}

struct FindingRow {
  const char* name;
  std::string tape;
  std::vector<std::string> texts;
};
class Findings : public testing::TestWithParam<FindingRow> {};
INSTANTIATE_TEST_SUITE_P(
    SYS_011, Findings,
    testing::Values(
        FindingRow{"travel_exceeded",
                   with_tools("P0001N001G11F1000M03N002G01X+250000N003G01X+1N004G01Y+1000"),
                   {"P0001 N003: Endschalter: X soll auf +250.001, erlaubt ist -250.000 bis +250.000. Start oder Weg "
                    "ändern."}},
        FindingRow{"rapid_in_material",
                   with_tools("P0001N001G11F1000T01M03N002G00Z-1000N003G00X+10000N004G00Z+5000"),
                   {"P0001 N002: Eilgang im Material. Vorher höher fahren oder mit Vorschub (G01) fräsen.",
                    "P0001 N003: Eilgang im Material. Vorher höher fahren oder mit Vorschub (G01) fräsen."}},
        FindingRow{"spindle_off",
                   with_tools("P0001N001G11F1000T01N002G01Z-1000N003G11M03N004G01X+10000"),
                   {"P0001 N002: Fräser steht im Material. Vorher die Spindel einschalten (M03)."}},
        FindingRow{"no_tool_called",
                   with_tools("P0001N001G11F1000M03N002G01Z-1000"),
                   {"P0001 N002: Kein Werkzeug mit Radius gerufen, aber Material berührt. T in G11 programmieren, "
                    "P0000 ausfüllen."}},
        FindingRow{"tool_not_in_table",
                   with_tools("P0001N001G11F1000T07M03"),
                   {"P0001 N001: Werkzeug T07 fehlt in P0000: keine Korrektur. Zeile T007 eingeben."}},
        FindingRow{"endless_loop",
                   with_tools("P0001N001G11F1000N002G20P0001N001"),
                   {"P0001 N002: Programm endet nicht: nach der größten Satzzahl abgebrochen. Sprünge prüfen."}}),
    [](const auto& row) { return row.param.name; });

TEST_P(Findings, AreToldInWordsWithTheirBlock) {
  TestOrder order = order_of(GetParam().tape);
  order.most_blocks = 1000;
  EXPECT_EQ(texts_of(run(std::move(order))), GetParam().texts);
}

TEST(TestRun, AnEndlessProgramIsNeverAllDoneBeforeItsEnd) {
  TestOrder order = order_of(with_tools("P0001N001G11F1000N002G20P0001N001"));
  order.most_blocks = 100;
  auto test = TestRun::begin(std::move(order));
  ASSERT_TRUE(test);
  test->advance(50);
  EXPECT_EQ(test->block().block, 2);
  EXPECT_LT(test->progress(), 1);
  test->advance(100);
  EXPECT_EQ(test->progress(), 1);
}

TEST(TestRun, AFaultyFirstBlockIsTheOneShown) {
  const TestRun test = run(order_of(with_tools("P0001N005G01X+1000F9000")));
  EXPECT_EQ(test.block(), (geometry::SourceBlock{1, 5}));
}

TEST(TestRun, AnArcThatBulgesBeyondTheSwitchIsFound) {
  const TestRun test = run(order_of(with_tools("P0001N001G11F1000M03N002G01X+200000N003G02X+0Y-120000I+0J-60000")));
  ASSERT_EQ(test.findings().size(), 1u);
  EXPECT_EQ(test.findings()[0].kind, Kind::travel_exceeded);
  EXPECT_EQ(test.findings()[0].axis, 'X');
  EXPECT_EQ(test.findings()[0].block.block, 3);
  EXPECT_NEAR(test.findings()[0].found, 260, 0.05);
}

struct ErrorRow {
  const char* name;
  std::string tape;
  language::ErrorCode code;
  std::uint16_t block;
};
class Errors : public testing::TestWithParam<ErrorRow> {};
/// What stops the control stops the test run too.
INSTANTIATE_TEST_SUITE_P(
    SYS_011, Errors,
    testing::Values(
        ErrorRow{"feed_zero", with_tools("P0001N001G11T01M03N002G01X+1000"), language::ErrorCode::feed_missing, 2},
        ErrorRow{"feed_above_f_max", with_tools("P0001N001G01X+1000F9000"), language::ErrorCode::feed_above_limit, 1},
        ErrorRow{"program_missing", with_tools("P0001N001G20P0009N001"), language::ErrorCode::program_missing, 1},
        ErrorRow{"compensation",  // an inside arc smaller than the cutter
                 with_tools("P0001N001G11F1000T01M03N002G41N003G01X+20000N004G01X+20000N005G03X+0Y+4000I+0J+2000"
                            "N006G01X-20000N007G40N008G01X-20000"),
                 language::ErrorCode::inside_arc_too_small, 5}),
    [](const auto& row) { return row.param.name; });

TEST_P(Errors, EndTheRun) {
  const TestRun test = run(order_of(GetParam().tape));
  ASSERT_FALSE(test.findings().empty());
  const Finding& finding = test.findings().back();
  ASSERT_EQ(finding.kind, Kind::error) << explain(finding, language::Tongue::english);
  EXPECT_EQ(finding.error->code, GetParam().code) << explain(finding, language::Tongue::english);
  EXPECT_EQ(finding.block.block, GetParam().block);
  EXPECT_THAT(explain(finding, language::Tongue::german), HasSubstr("P0001 N00"));
}

/// A room that is entered from outside: the walls are known only at its end.
TEST(TestRun, AnEntryThroughAWallIsFound_COMP007) {
  const TestRun test =
      run(order_of(with_tools("P0001N001G11F1000T01M03N002G41N003G01Y+20000N004G01X+30000N005G01Y+40000N006G01X-60000"
                              "N007G01Y-40000N008G01X+30000N009G40N010G01Y+20000")));
  ASSERT_FALSE(test.findings().empty());
  EXPECT_EQ(explain(test.findings().front(), language::Tongue::german),
            "P0001 N003: Einfahren würde in P0001 N008 schneiden. Von der freien Seite anfahren.");
}

/// A bay behind an opening of 8 mm, and a cutter of 10 mm.
TEST(TestRun, AContourThatCutsIntoItselfIsFound_DEC_09) {
  const TestRun test = run(order_of(with_tools(
      "P0001N001G11F1000T01M03N002G42N003G01X+20000Y+20000N004G01X+60000N005G01Y+40000N006G01X-26000N007G01Y-5000"
      "N008G01X+16000N009G01Y-15000N010G01X-40000N011G01Y+15000N012G01X+16000N013G01Y+5000N014G01X-26000"
      "N015G01Y-40000N016G01Y-20000N017G40N018G01X-20000")));
  ASSERT_EQ(test.findings().empty(), false);
  for (const Finding& finding : test.findings()) {
    ASSERT_EQ(finding.kind, Kind::error) << explain(finding, language::Tongue::english);
    EXPECT_EQ(finding.error->code, language::ErrorCode::too_close) << explain(finding, language::Tongue::english);
  }
}

TEST(TestRun, WhatCannotBeStartedIsAnError) {
  TestOrder order = order_of(with_tools("P0001N001G11F1000"));
  order.start.program = 5;
  EXPECT_EQ(TestRun::begin(std::move(order)).error().code, language::ErrorCode::program_missing);
}

/// EX-080: the compensated square; contour and path lie apart, lengths as EX-092 says.
TEST(TestRun, DrawsContourAndPath_EX_080) {
  const TestRun test = run(order_of(
      "P0000T001R+5000L+1000P0001N001G68X+0Y+0Z+0N002G11F1000T01N003G01X+20000N004G42N005G01Y+30000N006G01X+30000"
      "N007G01Y+30000N008G01X-30000N009G01Y-30000N010G01Y-30000N011G40N012G01X-20000%"));
  EXPECT_NEAR(test.path_mm(), 233.561945, 1e-5);
  const drawing::Scene scene = test.scene();
  EXPECT_FALSE(scene.traces.contour.empty());
  float highest = 0;
  for (const drawing::Stroke& stroke : scene.traces.path)
    for (const drawing::Spot& spot : stroke.spots) highest = std::max(highest, spot.y);
  EXPECT_FLOAT_EQ(highest, 65);
  EXPECT_NEAR(test.stock().height_mm(35, 25), -1, 1e-5);  // L +1.000: the tip hangs 1 mm below (COMP-016)
  EXPECT_NEAR(test.stock().height_mm(35, 35), 0, 1e-5);   // the square itself stands
}

TEST(TestRun, WhatTakesTooLongIsBrokenOff) {
  TestOrder order = order_of(with_tools("P0001N001G04H9000N002G20P0001N001"));  // 15 minutes each
  order.most_machine_s = 7200;
  EXPECT_THAT(texts_of(run(std::move(order))), ElementsAre(HasSubstr("Programm dauert über 2 Stunden")));
}

TEST(TestRun, PortionsGiveTheSameAsOneGo) {
  const std::string tape = with_tools(
      "P0001N001G11F1000T01M03N002G01Z-1000N003G22P0002N001W03N004G01X+10000"
      "P0002N001G01X+5000N002G01Y+5000");
  const TestRun whole = run(order_of(tape));
  auto portions = TestRun::begin(order_of(tape));
  ASSERT_TRUE(portions.has_value());
  std::vector<double> progress;
  while (!portions->has_ended()) {
    portions->advance(1);
    progress.push_back(portions->progress());
  }
  EXPECT_EQ(portions->blocks(), whole.blocks());
  EXPECT_DOUBLE_EQ(portions->path_mm(), whole.path_mm());
  EXPECT_DOUBLE_EQ(portions->machine_time_s(), whole.machine_time_s());
  EXPECT_DOUBLE_EQ(portions->stock().removed_mm3(), whole.stock().removed_mm3());
  EXPECT_TRUE(std::ranges::is_sorted(progress));
}

TEST(TestRun, BehindALimitSwitchItGoesOnWhereAsked) {
  TestOrder order = order_of(with_tools("P0001N001G11F1000M03N002G01X+300000N003G01X-300000"));
  order.ends_at_travel = false;
  const TestRun test = run(std::move(order));
  EXPECT_EQ(test.findings().size(), 1u);
  EXPECT_DOUBLE_EQ(test.path_mm(), 600);
}

/// 1000 blocks that mill the whole 120 × 80 × 30 block in layers.
std::string thousand_blocks() {
  std::string text = std::string(kTools) + "P0001N001G11F3000T01M03N002G00X-55000Y-35000Z+2000N003G01Z-3000";
  for (int block = 4; block <= 999; ++block) {
    const int step = block % 4;
    const std::string number = std::to_string(block);
    text += "N" + std::string(3 - number.size(), '0') + number;
    text += step == 0 ? "G01X+110000" : step == 1 ? "G01Y+1000Z-50" : step == 2 ? "G01X-110000" : "G02X+0Y+0I+3000J+0";
  }
  return text + "%";
}

TEST(TestRun, AThousandBlocksStayWithinFourMegabytes) {
  const auto before = mallinfo2();
  TestOrder order = order_of(thousand_blocks());
  order.travel = {TravelRange{-1e6, 1e6}, TravelRange{-1e6, 1e6}, TravelRange{-1e6, 1e6}};
  const TestRun test = run(std::move(order));
  const auto after = mallinfo2();
  EXPECT_EQ(test.blocks(), 999u);
  EXPECT_LT(after.uordblks + after.hblkhd - before.uordblks - before.hblkhd, 4U << 20U);
}

TEST(TestRun, ALongProgramKeepsWithinFourMegabytesToo) {
  TestOrder order = order_of(with_tools("P0001N001G11F3000T01M03N002G01Z-1000N003G02X+0Y+0I+20000J+0N004G20P0001N003"));
  order.most_blocks = 2000;
  const auto before = mallinfo2();
  const TestRun test = run(std::move(order));
  const auto after = mallinfo2();
  EXPECT_TRUE(test.is_picture_cut());
  EXPECT_EQ(test.findings().size(), 1u);
  EXPECT_LT(after.uordblks + after.hblkhd - before.uordblks - before.hblkhd, 4U << 20U);
}

/// A wall of six blocks, then a pocket whose mouth is 8 mm wide, between N010 and N014: too narrow for 10 mm.
constexpr std::string_view kLongContour =
    "P0001N001G11F3000T01M03N002G41N003G01X-50000N004G01X+10000N005G01X+10000N006G01X+10000N007G01X+10000N008G01X+10000"
    "N009G01X+10000N010G01X+40000N011G01Y+20000N012G01X-30000N013G01Y-12000N014G01X-10000N015G40N016G01Y+20000";

TEST(TestRun, AContourTooLongToBeKeptIsCheckedInPartsAndThatIsTold_DEC09) {
  TestOrder order = order_of(with_tools(kLongContour));
  order.longest_contour = 8;  // N002 to N009, then N010 to N014
  const TestRun test = run(std::move(order));
  EXPECT_THAT(texts_of(test), Contains("P0001 N009: Kontur hat mehr als 8 Sätze: ab hier nur in Teilen geprüft. START "
                                       "prüft sie ganz."));
  EXPECT_THAT(texts_of(test), Contains(HasSubstr("P0001 N010: Werkzeug würde in P0001 N014 schneiden")));
}

TEST(TestRun, AContourThatIsKeptWholeIsNotToldInParts_DEC09) {
  const TestRun test = run(order_of(with_tools(kLongContour)));
  EXPECT_THAT(texts_of(test), Each(testing::Not(HasSubstr("in Teilen"))));
}

/// As above, but under compensation: the contour is kept beside the path, and looked at as a whole.
TEST(TestRun, ALongCompensatedContourKeepsWithinFourMegabytesAtEveryMoment) {
  TestOrder order =
      order_of(with_tools("P0001N001G11F3000T01M03N002G41N003G01X-30000N004G02X+0Y+0I+30000J+0N005G20P0001N004"));
  order.most_blocks = 6000;
  order.travel = {TravelRange{-1e6, 1e6}, TravelRange{-1e6, 1e6}, TravelRange{-1e6, 1e6}};
  const auto used = [] {
    const auto heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
  };
  const std::size_t before = used();
  auto test = TestRun::begin(std::move(order));
  ASSERT_TRUE(test);
  std::size_t most = 0;
  while (!test->has_ended()) {
    test->advance(20);
    most = std::max(most, used() - before);
  }
  EXPECT_TRUE(test->is_picture_cut());
  EXPECT_GT(test->scene().traces.contour.size(), 0U);
  EXPECT_EQ(test->findings().back().kind, Kind::endless_loop);
  EXPECT_LT(most, 4U << 20U);
}

}  // namespace
}  // namespace cnclab::testrun
