// Nothing is lost between blocks, listing and tape, whichever way a program goes.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>

#include "language/listing.hpp"
#include "language/program_text.hpp"
#include "random_program.hpp"
#include "tape_text.hpp"

namespace cnclab::language {
namespace {

constexpr std::string_view kTime = "09:00:00 16/06/83";

class ListingRoundTrip : public testing::Test {
 protected:
  static void SetUpTestSuite() { setenv("RC_PARAMS", "seed=3300 max_success=300", 0); }
};

Tongue random_tongue() { return *rc::gen::element(Tongue::german, Tongue::english); }

void require_only(const Tape& tape, const Program& program) {
  for (const Error& error : tape.errors) RC_FAIL(explain(error, Tongue::english));
  RC_ASSERT(tape.programs.size() == 1U);
  RC_ASSERT(tape.programs[0].program == program);
}

TEST_F(ListingRoundTrip, ProgramsComeBackFromTheListing_EXT_005) {
  EXPECT_TRUE(rc::check([] {
    Program program = *random_program();
    for (Block& block : program.blocks) block.is_damaged = *rc::gen::inRange(0, 10) == 0;
    const std::string listing = write_listing(program, kTime, random_tongue());
    const Tape tape = read_listing(listing);
    require_only(tape, program);
    RC_ASSERT(write_listing(tape.programs[0].program, kTime, Tongue::german) ==
              write_listing(program, kTime, Tongue::german));
  }));
}

TEST_F(ListingRoundTrip, EitherFormIsKnownByItsContent) {
  EXPECT_TRUE(rc::check([] {
    const Program program = *random_program();
    require_only(read_programs_text(write_program(program), Reading::file), program);
    require_only(read_programs_text(write_listing(program, kTime, random_tongue()), Reading::file), program);
  }));
}

TEST_F(ListingRoundTrip, TapeToListingToTape_D_101_EXT_005) {
  EXPECT_TRUE(rc::check([] {
    const Program first = *random_program(), second = *random_program();
    RC_PRE(first.number != second.number);
    const std::string tape = write_program(first) + write_program(second);
    std::string listing;
    for (const ReadProgram& read : read_tape(tape, Reading::file).programs)
      listing += write_listing(read.program, kTime, Tongue::german);
    std::string again;
    for (const ReadProgram& read : read_listing(listing).programs) again += write_program(read.program);
    RC_ASSERT(again == tape);
  }));
}

TEST_F(ListingRoundTrip, AsTheManualPrintsIt_D_21) {
  EXPECT_TRUE(rc::check([] {
    const Program program = *random_program();
    std::string listing = write_listing(program, kTime, Tongue::german);
    // Commas for points between digits, backslashes for arrows, short empty words, CRLF.
    std::string printed;
    for (std::size_t i = 0; i < listing.size(); ++i) {
      const bool is_point = listing[i] == '.' && i + 1 < listing.size() && listing[i + 1] >= '0' &&
                            listing[i + 1] <= '9' && i > 0 && listing[i - 1] >= '0' && listing[i - 1] <= '9';
      if (is_point)
        printed += ',';
      else if (listing.compare(i, 9, ".....,...") == 0)
        printed += ".....", i += 8;
      else if (listing.compare(i, 3, "↓") == 0)
        printed += '\\', i += 2;
      else if (listing[i] == '\n')
        printed += "\r\n";
      else
        printed += listing[i];
    }
    require_only(read_listing(printed), program);
  }));
}

TEST_F(ListingRoundTrip, MachineDataComeBackFromTheTape_DEC_62) {
  EXPECT_TRUE(rc::check([] {
    const Program program = *random_program();
    std::vector<MachineDatum> data;
    for (const int number : *rc::gen::container<std::set<int>>(rc::gen::inRange(3, 100)))
      data.push_back(
          {.number = static_cast<std::uint16_t>(number), .value = *rc::gen::inRange<std::int64_t>(0, 10'000'000)});
    const std::string written = write_program(program) + write_machine_data(data) + "%\n";
    for (const Reading reading : {Reading::file, Reading::strict}) {
      const Tape tape = read_tape(written, reading);
      require_only(tape, program);
      RC_ASSERT(write_program(tape.programs[0].program) + write_machine_data(tape.machine_data) + "%\n" == written);
    }
  }));
}

TEST_F(ListingRoundTrip, AnyLinesAreReadWithoutHarm) {
  EXPECT_TRUE(rc::check([] {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::oneOf(
        rc::gen::string<std::string>(),
        rc::gen::element<std::string>("P0001\n", "P0000\n", "\nN001 ", "N002!G20 ", "G01 X+...1,000", " X.....#0",
                                      "↓01 ", "#01 = #02 + #03", "\nT001 R+", "(", ")", "\n%\n", "\\53 N004", "COPY ",
                                      "=", "P9981\n", "F1000 ", "....", ",")));
    std::string text;
    for (const std::string& piece : pieces) text += piece;
    const Tape first = read_listing(text);
    std::string written;
    for (const ReadProgram& read : first.programs) written += write_listing(read.program, kTime, Tongue::german);
    const Tape second = read_listing(written);
    RC_ASSERT(second.errors.empty());
    RC_ASSERT(programs_in(second) == programs_in(first));
  }));
}

}  // namespace
}  // namespace cnclab::language
