// Nothing is lost on the way to the tape and back, and nothing that is right is refused.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>

#include "language/check_block.hpp"
#include "language/screen_form.hpp"
#include "language/tape.hpp"
#include "random_program.hpp"
#include "tape_block.hpp"
#include "tape_text.hpp"

namespace cnclab::language {
namespace {

/// The same cases at every run; RC_PARAMS in the environment chooses others.
class RoundTrip : public testing::Test {
 protected:
  static void SetUpTestSuite() { setenv("RC_PARAMS", "seed=3300 max_success=300", 0); }
};

TEST_F(RoundTrip, ProgramsComeBackFromTheTape_D_101) {
  EXPECT_TRUE(rc::check([] {
    const Program program = *random_program();
    for (const Reading reading : {Reading::file, Reading::strict}) {
      const Tape tape = read_tape(write_program(program) + "%", reading);
      RC_ASSERT(tape.errors.empty());
      RC_ASSERT(tape.programs.size() == 1U);
      RC_ASSERT(tape.programs[0].program == program);
    }
  }));
}

TEST_F(RoundTrip, SeveralProgramsNeedNoSeparator_EXT_050) {
  EXPECT_TRUE(rc::check([] {
    Program first = *random_program();
    Program second = *random_program();
    if (first.number == kToolTable) std::swap(first, second);
    RC_PRE(first.number != second.number);
    const Tape tape = read_tape(write_program(first) + write_program(second), Reading::file);
    RC_ASSERT(tape.errors.empty());
    RC_ASSERT(tape.programs.size() == 2U);
    RC_ASSERT(tape.programs[0].program == first);
    RC_ASSERT(tape.programs[1].program == second);
  }));
}

TEST_F(RoundTrip, BlocksComeBackFromTheirStoredForm_SYS_018) {
  EXPECT_TRUE(rc::check([] {
    const Program program = *random_program();
    for (const Block& block : program.blocks) {
      const auto read = read_block(write_block(block), program.number);
      RC_ASSERT(read.has_value());
      RC_ASSERT(*read == block);
    }
  }));
}

TEST_F(RoundTrip, RightProgramsPassTheChecksAndFitTheMonitor_D_45_SCR_008) {
  EXPECT_TRUE(rc::check([] {
    const Program program = *random_program();
    RC_ASSERT(check_program(program, {}, nullptr).empty());
    for (const Block& block : program.blocks)
      for (const Tongue tongue : {Tongue::german, Tongue::english})
        RC_ASSERT(columns_of(block_line(block, Plane::xy, tongue)) <= 64);
  }));
}

TEST_F(RoundTrip, EveryFunctionOnce_BLK_100_to_195) {
  EXPECT_TRUE(rc::check([] {
    for (const BlockForm& form : all_forms()) {
      const Block block = *random_block(form, 1);
      const std::uint16_t program = form.function.kind == Function::Kind::tool ? 0 : 1;
      const auto read = read_block(write_block(block), program);
      RC_ASSERT(read.has_value());
      RC_ASSERT(*read == block);
      RC_ASSERT(check_block(block, form.plane, {}, nullptr).has_value());
    }
  }));
}

TEST_F(RoundTrip, AnyBytesAreReadWithoutHarm) {
  EXPECT_TRUE(rc::check([] {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::oneOf(
        rc::gen::string<std::string>(),
        rc::gen::element<std::string>("P0001", "P0000", "N001", "N002G20", "G01X+1", "X#", "\\01#01", "T001R", "(", ")",
                                      "%", "\\53N004", std::string(6, '\0'), "P9981", "↓", "F1000", ".")));
    std::string text;
    for (const std::string& piece : pieces) text += piece;
    for (const Reading reading : {Reading::file, Reading::strict}) {
      const Tape first = read_tape(text, reading);
      std::string written;
      for (const ReadProgram& read : first.programs) written += write_program(read.program);
      const Tape second = read_tape(written, reading);
      RC_ASSERT(second.errors.empty());
      RC_ASSERT(programs_in(second) == programs_in(first));
    }
  }));
}

}  // namespace
}  // namespace cnclab::language
