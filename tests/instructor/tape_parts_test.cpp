// A long tape cut into pieces that the wire may carry, and whole again (INS-003).
#include "instructor/tape_parts.hpp"

#include <gtest/gtest.h>

#include "shared/frame.hpp"
#include "station/utf8.hpp"

namespace cnclab::instructor {
namespace {

TEST(TapeParts, INS_003_a_long_tape_goes_in_small_pieces_and_is_whole_at_the_end) {
  for (const std::size_t blanks : {0U, 1U, 2U}) {  // letters of three bytes lie across every border in turn
    std::string tape(blanks, ' ');
    for (int i = 0; i < 5000; ++i) tape += "→";
    v1::InstructorRequest request;
    request.mutable_program_send()->set_tape(tape);
    request.mutable_program_send()->set_all(true);
    std::string whole;
    while (const auto part = take_part(request)) {
      EXPECT_TRUE(part->program_send().more());
      EXPECT_FALSE(part->program_send().all());
      EXPECT_LE(part->program_send().tape().size(), kLargestChunk);
      EXPECT_FALSE(station::line_not_utf8(part->program_send().tape()));
      whole += part->program_send().tape();
    }
    EXPECT_LE(request.program_send().tape().size(), kLargestChunk);
    EXPECT_FALSE(request.program_send().more());
    EXPECT_TRUE(request.program_send().all());
    EXPECT_EQ(whole + request.program_send().tape(), tape);
  }
}

TEST(TapeParts, what_is_short_goes_at_once) {
  v1::InstructorRequest request;
  request.mutable_program_send()->set_tape(std::string(kLargestChunk, 'N'));
  EXPECT_FALSE(take_part(request));
  request.mutable_import()->set_csv(std::string(2 * kLargestChunk, 'a'));
  EXPECT_FALSE(take_part(request));
}

}  // namespace
}  // namespace cnclab::instructor
