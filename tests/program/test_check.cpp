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
      "P0001N001G00N002G20P0007N001N003G22P0002N009W00N004G01X+600000\nP0002N001G11F4000N002G81Z-"
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
                       line("P0002 N002", ErrorCode::not_in_this_version));
}

TEST(CheckPrograms, DryRunFindsWhatOnlyExecutionShows) {
  const auto dry = [](std::string_view text) { return dry_run(programs_of(text), wide_settings(), {}, 100'000); };
  EXPECT_EQ(dry("P0001N001G01X+1000%").at(0).code, ErrorCode::feed_missing);
  EXPECT_THAT(dry("P0001N001G01X+1000F0100N002G20P0001N001%"), IsEmpty()) << "a loop is no fault";
}

TEST(CheckPrograms, StartProgramsAreThoseThatNobodyCalls) {
  const ProgramSet programs =
      programs_of("P0000T001R+1L+1\nP0001N001G22P0002N001W00\nP0002N001G17\nP0003N001G20P0003N001\nP0004N001G17%");
  EXPECT_EQ(start_programs(programs), (std::vector<std::uint16_t>{1, 3, 4}));
  EXPECT_EQ(start_programs(programs_of("P0005N001G20P0006N001\nP0006N001G20P0005N001%")),
            (std::vector<std::uint16_t>{5}));
}

}  // namespace
}  // namespace cnclab::program
