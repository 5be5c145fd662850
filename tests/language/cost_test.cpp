// Memory that blocks cost: the manual's free-memory number before and after the five blocks of Bild 7.
#include <gtest/gtest.h>

#include "language/check_block.hpp"
#include "tape_block.hpp"

namespace cnclab::language {
namespace {

TEST(Cost, FiveBlocksOfBild7Leave16221_D_22_DEC_07) {
  int cost = 0;
  for (const std::string_view text :
       {"N001G00X+50000Y+50000Z+50000", "N002G04H0010", "N003G01X+25000Y+10000Z+4000F1000M03",
        "N004G02X+10000Y+0I+5000J+0", "N005G20P0001N001"})
    cost += cost_bytes(tape_block(text));
  EXPECT_EQ(cost, 69);
  EXPECT_EQ(empty_memory_bytes(16384), 16290);
  EXPECT_EQ(empty_memory_bytes(16384) - cost, 16221);
}

struct CostRow {
  std::string_view id, text;
  int bytes;
  std::uint16_t program = 1;
};

TEST(Cost, EveryKindOfWord_D_22_DEC_54_DEC_66) {
  constexpr CostRow kRows[] = {
      {"D-22 block alone", "N001G17", 4},
      {"D-22 mm word", "N001G12U+1", 4 + 4},
      {"D-22 F S T M", "N001G11F1000S1000T01M03", 4 + 2 + 2 + 1 + 1},
      {"D-22 H", "N001G04H0010", 4 + 2},
      {"D-22 P N W", "N001G22P0001N001W00", 4 + 2 + 2 + 1},
      {"D-22 #nn costs as the word", "N001G01X#01F#02", 4 + 4 + 2},
      {"D-22 V, cycle", "N001G81Z-1000V002H0000", 4 + 4 + 2 + 2},
      {"DEC-54 D and V", "N001G86R+1000D045W06Z-1000V002H0000", 4 + 4 + 2 + 1 + 4 + 2 + 2},
      {"D-22 operands", "N001\\01#01#02#03", 4 + 3},
      {"D-22 value", "N001\\00#01+500", 4 + 1 + 4},
      {"D-22 jump here", "N001\\53N001", 4 + 2},
      {"DEC-66 tool row", "T001R+5000L+1000", 4 + 8, kToolTable},
      {"DEC-66 tool row without L", "T001R+5000", 4 + 8, kToolTable},
  };
  for (const CostRow& row : kRows) EXPECT_EQ(cost_bytes(tape_block(row.text, row.program)), row.bytes) << row.id;
}

}  // namespace
}  // namespace cnclab::language
