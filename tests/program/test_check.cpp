// What `check` finds before a program runs: block by block, and by executing it on paper.
#include <gmock/gmock.h>

#include "program/check_programs.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(CheckPrograms, FindsEveryFaultOfEveryProgram) {
  const ProgramSet programs = programs_of(
      "P0001N001G00N002G20P0007N001N003G22P0002N009W00N004G01X+600000\nP0002N001G11F4000N002G81Z+"
      "5000V002H0010N003G17%");
  std::string found;
  for (const language::Error& error : check_blocks(programs, Settings{}))
    found += language::place_of(error) + " " + std::to_string(static_cast<int>(error.code)) + "\n";
  const auto line = [](const char* place, ErrorCode code) {
    return std::string(place) + " " + std::to_string(static_cast<int>(code)) + "\n";
  };
  EXPECT_EQ(found, line("P0001 N001", ErrorCode::word_missing) + line("P0001 N002", ErrorCode::program_missing) +
                       line("P0001 N003", ErrorCode::block_missing) + line("P0001 N004", ErrorCode::word_out_of_range) +
                       line("P0002 N001", ErrorCode::feed_above_limit) +
                       line("P0002 N002", ErrorCode::cycle_value_wrong));
}

TEST(CheckPrograms, DryRunFindsWhatOnlyExecutionShows) {
  const auto dry = [](std::string_view text) { return dry_run(programs_of(text), wide_settings(), {}, 100'000); };
  EXPECT_EQ(dry("P0001N001G01X+1000%").at(0).code, ErrorCode::feed_missing);
  EXPECT_THAT(dry("P0001N001G01X+1000F0100N002G20P0001N001%"), IsEmpty()) << "a loop is no fault";
}

/// Places of all errors of a dry run from P0001 N001.
std::vector<std::string> faults_of(std::string_view text, std::uint64_t most_blocks = 100'000) {
  const ProgramSet programs = programs_of(text);
  std::vector<std::string> places;
  for (const language::Error& error : dry_run(programs, wide_settings(), {}, most_blocks))
    places.push_back(language::place_of(error));
  return places;
}

struct DryRow {
  const char* name;
  const char* text;
  std::vector<std::string> faults;
};

class DryRuns : public testing::TestWithParam<DryRow> {};

TEST_P(DryRuns, FindAllFaultsOnce) { EXPECT_EQ(faults_of(GetParam().text), GetParam().faults); }

using Faults = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(
    , DryRuns,
    testing::Values(
        DryRow{"two_wrong_circles",
               "P0001N001G11F0500N002G02X+9000Y+0I+5000J+0N003G01X+1N004G05X+9000Y+0R+1000N005G17%",
               Faults{"P0001 N002", "P0001 N004"}},
        DryRow{"a_missing_F_is_said_once", "P0001N001G01X+1000N002G01X+1000N003G02X+9000Y+0I+5000J+0%",
               Faults{"P0001 N001", "P0001 N003"}},
        DryRow{"an_F_above_F_MAX_is_said_once", "P0001N001G11F9999N002G01X+1000N003G01X+1000T05M03%",
               Faults{"P0001 N001"}},
        DryRow{"the_F_of_a_faulty_block_counts", "P0001N001G05X+9000Y+0R+1000F0500N002G01X+1000%",
               Faults{"P0001 N001"}},
        DryRow{"what_follows_begins_at_its_target",
               "P0001N001G90N002G01X+10000N003G02X+20000Y+0I+5000J+0N004G02X+0Y+0I+5000J+0%",
               Faults{"P0001 N002", "P0001 N004"}},
        DryRow{"a_faulty_block_in_a_loop_once", "P0001N001G11F0500N002G05X+9000Y+0R+1000N003G20P0001N002%",
               Faults{"P0001 N002"}},
        DryRow{"a_call_that_leads_nowhere_is_passed_over", "P0001N001G22P0007N001W00N002G01X+1000%",
               Faults{"P0001 N001", "P0001 N002"}},
        DryRow{"behind_a_jump_that_leads_nowhere_is_nothing", "P0001N001G20P0007N001N002G01X+1000%",
               Faults{"P0001 N001"}},
        DryRow{"a_call_of_itself", "P0001N001G22P0001N001W00N002G01X+1000%", Faults{"P0001 N001", "P0001 N002"}},
        DryRow{"G21_with_the_input", "P0001N001G21P0001N004N002G17N003G11M02N004G01X+1000%", Faults{"P0001 N004"}},
        DryRow{"G21_without_the_input", "P0001N001G21P0001N004N002G01X+1000N003G11M02N004G17%", Faults{"P0001 N002"}},
        DryRow{"G21_both_ways", "P0001N001G21P0001N004N002G01X+1000N003G11M02N004G01X+1000%",
               Faults{"P0001 N002", "P0001 N004"}},
        DryRow{"G23_with_the_input", "P0001N001G23P0002N001W00N002G17\nP0002N001G17N002G01X+1000%",
               Faults{"P0002 N002"}},
        DryRow{"G23_target_that_only_a_parameter_names", "P0001N001G23P#00N001W00N002G17%", Faults{"P0001 N001"}},
        DryRow{"a_loop_that_waits_for_the_input",
               "P0001N001G21P0001N003N002G20P0001N001N003G21P0001N005N004G20P0001N003N005G01X+1000%",
               Faults{"P0001 N005"}},
        DryRow{"G68_under_compensation", "P0001N001G41N002G68X+0N003G19%", Faults{"P0001 N002", "P0001 N003"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(DryRunLimit, CountsTheBlocksOfAllPaths) {
  EXPECT_THAT(faults_of("P0001N001G17N002G17N003G01X+1000%", 2), IsEmpty());
  EXPECT_THAT(faults_of("P0001N001G17N002G17N003G01X+1000%", 3), ElementsAre("P0001 N003"));
}

TEST(CheckPrograms, TargetsOfG20ToG23_DEC64) {
  for (const char* words : {"G20P9981N001", "G21P9989N001", "G22P9985N001W00", "G23P9986N001W00"}) {
    const auto errors = check_blocks(programs_of(std::string("P0001N001") + words + "%"), wide_settings());
    ASSERT_EQ(errors.size(), 1u) << words;
    EXPECT_EQ(errors[0].code, ErrorCode::reserved_for_cycles) << words;
  }
  EXPECT_THAT(check_blocks(programs_of("P0001N001G20P9980N999\nP9980N999G21P9999N001\nP9999N001G17%"), {}), IsEmpty());
}

TEST(CheckPrograms, StartProgramsAreThoseThatNobodyCalls) {
  const ProgramSet programs =
      programs_of("P0000T001R+1L+1\nP0001N001G22P0002N001W00\nP0002N001G17\nP0003N001G20P0003N001\nP0004N001G17%");
  EXPECT_EQ(start_programs(programs), (std::vector<std::uint16_t>{1, 3, 4}));
  EXPECT_THAT(start_programs(programs_of("P0005N001G20P0006N001\nP0006N001G20P0005N001%")), ElementsAre(5));
  EXPECT_THAT(start_programs(programs_of("P0005N001G20P0006N001\nP0006N001G20P0005N001\nP0009N001G17%")),
              ElementsAre(5, 9));
  EXPECT_THAT(start_programs(programs_of("P0003N001G22P0006N001W00\nP0005N001G20P0006N001\nP0006N001G20P0005N001%")),
              ElementsAre(3))
      << "the ring is come to from P0003";
}

struct ContourRow {
  const char* name;
  const char* contour;  ///< from N003, behind the call of a tool of radius 5
  std::vector<std::pair<std::uint16_t, ErrorCode>> faults;
};

TEST(DryRunContours, ThatCannotBeFollowed_DEC09_D71) {
  const std::vector<ContourRow> rows{
      {"a square from outside", "N003G42N004G01X+20000N005G01X+30000N006G01Y+30000N007G40N008G01X+9000", {}},
      {"a pocket whose last wall ends 3 mm before its first",
       "N003G42N004G01X+10000N005G01Y+50000N006G01X+60000N007G01Y-30000N008G01X-57000N009G40N010G01Y+10000",
       {{5, ErrorCode::too_close}, {8, ErrorCode::too_close}, {10, ErrorCode::exit_too_close}}},
      {"a room entered and left through its walls",
       "N003G41N004G01Y+20000N005G01X+30000N006G01Y+40000N007G01X-60000N008G01Y-40000N009G01X+30000N010G40N011G01Y-"
       "9000",
       {{4, ErrorCode::entry_too_close}, {11, ErrorCode::exit_too_close}}},
      {"a room entered from its middle",
       "N003G41N004G01Y-20000N005G01X+30000N006G01Y+40000N007G01X-60000N008G01Y-40000N009G01X+30000N010G40N011G01Y+"
       "20000",
       {}},
      {"an arc smaller than the tool",
       "N003G41N004G01X+10000N005G01X+20000N006G03X+0Y+6000I+0J+3000N007G01X-20000N008G40N009G01X-9000",
       {{6, ErrorCode::inside_arc_too_small}}},
      {"a step shorter than the tool",
       "N003G41N004G01X+10000N005G01X+20000N006G01Y+2000N007G01X-20000N008G40N009G01X-9000",
       {{6, ErrorCode::runs_backwards}}},
      {"entered on an arc",
       "N003G41N004G02X+10000Y+0I+5000J+0N005G01X+9000N006G40N007G01X+9000",
       {{4, ErrorCode::arc_at_entry_or_exit}}},
      {"two contours, a fault in each",
       "N003G41N004G01X+10000N005G01X+20000N006G03X+0Y+6000I+0J+3000N007G01X-20000N008G40N009G01X-9000"
       "N010G41N011G01X+10000N012G01X+20000N013G03X+0Y+6000I+0J+3000N014G01X-20000N015G40N016G01X-9000",
       {{6, ErrorCode::inside_arc_too_small}, {13, ErrorCode::inside_arc_too_small}}},
  };
  for (const ContourRow& row : rows) {
    SCOPED_TRACE(row.name);
    const std::string tape = std::string("P0000T001R+5000L+0\nP0001N001G11F1000T01N002G17") + row.contour + "%";
    std::vector<std::pair<std::uint16_t, ErrorCode>> found;
    for (const language::Error& error : dry_run(programs_of(tape), wide_settings(), {}, 100'000))
      found.emplace_back(error.block, error.code);
    EXPECT_EQ(found, row.faults);
  }
}

struct MeasureRow {
  const char* name;
  std::string contour;
  std::string_view sentence;
};

TEST(DryRunContours, DEC_01_DEC_09_SentencesNameWhatWasMeasured) {
  const std::vector<MeasureRow> rows{
      {"an arc smaller than the tool",
       "N003G41N004G01X+10000N005G01X+20000N006G03X+0Y+6000I+0J+3000N007G01X-20000N008G40N009G01X-9000",
       "R 3.000: Innenbogen zu klein für das Werkzeug, richtig: R >= 5.000. Kleineres nehmen."},
      {"a step shorter than the tool",
       "N003G41N004G01X+10000N005G01X+20000N006G01Y+2000N007G01X-20000N008G40N009G01X-9000",
       "Weg 2.000 mm: zu kurz für das Werkzeug, liefe rückwärts, richtig: >= 5.000 mm. Kontur ändern."},
      {"a way that G44 shortens by more than it is", "N003G44N004G01X+3000",
       "Weg 3.000 mm: zu kurz für das Werkzeug, liefe rückwärts, richtig: >= 5.000 mm. Kontur ändern."},
      {"a corner with too large a rounding", "N003G01X+6000N004G10R+8000N005G01Y+20000",
       "Gerade 6.000 mm: zu kurz für die Rundung, richtig: >= 8.000 mm. R verkleinern."},
  };
  for (const MeasureRow& row : rows) {
    SCOPED_TRACE(row.name);
    const std::string tape = "P0000T001R+5000L+0\nP0001N001G11F1000T01N002G17" + row.contour + "%";
    const auto errors = dry_run(programs_of(tape), wide_settings(), {}, 100'000);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(language::message_of(errors.front(), language::Tongue::german), row.sentence);
  }
}

}  // namespace
}  // namespace cnclab::program
