// The format of every word: its range, what stands just outside of it, and parameters in its place.
#include <gtest/gtest.h>

#include <algorithm>

#include "language/block_form.hpp"
#include "language/tape.hpp"
#include "tape_block.hpp"

namespace cnclab::language {
namespace {

struct RangeRow {
  std::string_view id;
  std::string_view before;  ///< tape text up to the number
  std::string_view least, most, below, above;
  std::string_view after = "";
};

constexpr RangeRow kRanges[] = {
    {"BLK-005 X", "N001G00X", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 Y", "N001G00Y", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 Z", "N001G00Z", "-9999.999", "9999.999", "-10000.0", "10000."},
    {"BLK-005 I", "N001G02I", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 J", "N001G02J", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 K", "N001G02K", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 U", "N001G12U", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 R", "N001G10R", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-005 Q", "N001G82Q", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"D-91 value of ↓00", "N001\\00#00", "-9999999", "+9999999", "-10000000", "+10000000"},
    {"BLK-006 N", "N001\\53N", "001", "999", "000", "1000"},
    {"BLK-009 F", "N001G11F", "0001", "9999", "0000", "10000"},
    {"BLK-010 S", "N001G11S", "0001", "9999", "0000", "10000"},
    {"BLK-011 T", "N001G11T", "01", "99", "00", "100"},
    {"BLK-012 M", "N001G11M", "00", "99", "-1", "100"},
    {"BLK-013 H", "N001G04H", "0000", "9999", "-1", "10000"},
    {"BLK-014 W", "N001G22P0001N001W", "00", "99", "-1", "100"},
    {"BLK-015 V", "N001G81V", "001", "999", "000", "1000"},
    {"DEC-54 D", "N001G86D", "000", "359", "-1", "360"},
    {"BLK-007 P", "N001G20P", "0000", "9999", "000", "10000", "N001"},
    {"BLK-016 #", "N001G00X", "#00", "#69", "#", "#70"},
    {"BLK-016 operand", "N001\\10#01#", "00", "69", "0", "70"},
};

TEST(WordFormat, TakesItsRangeAndNothingBeyond_BLK_005_to_016) {
  for (const RangeRow& row : kRanges) {
    SCOPED_TRACE(row.id);
    const auto with = [&](std::string_view number) {
      return read_block(std::string(row.before).append(number).append(row.after), 1);
    };
    for (const std::string_view number : {row.least, row.most}) EXPECT_TRUE(with(number).has_value()) << number;
    for (const std::string_view number : {row.below, row.above}) EXPECT_FALSE(with(number).has_value()) << number;
  }
}

TEST(WordFormat, AddressesOfAllForms_BLK_002_BLK_003) {
  std::string letters;
  for (const BlockForm& form : all_forms())
    for (const Address address : form.words)
      if (letters.find(letter(address)) == std::string::npos) letters += letter(address);
  std::ranges::sort(letters);
  EXPECT_EQ(letters, "#=DFHIJKLMNPQRSTUVWXYZ")
      << "E stands in no block, D in G86 alone (DEC-54); G and N begin a block";
  for (const BlockForm& form : all_forms()) {
    const bool has_angle = std::ranges::find(form.words, Address::D) != form.words.end();
    EXPECT_EQ(has_angle, form.function == (Function{Function::Kind::g, 86}));
  }
  for (const std::string_view text :
       {"N001G01E+1", "N001G01D001", "N001G00A+1", "N001G00O1", "N001G00B+1", "N001G01C1"})
    EXPECT_FALSE(read_block(text, 1).has_value()) << text;
}

TEST(WordFormat, CodesHaveTwoDigits_BLK_008) {
  for (const std::string_view text : {"N001G91", "N001\\53N001", "N001G00X+1"})
    EXPECT_TRUE(read_block(text, 1).has_value()) << text;
  for (const std::string_view text : {"N001G1X+1", "N001G091", "N001G100", "N001\\053N001", "N001G", "N001\\"})
    EXPECT_FALSE(read_block(text, 1).has_value()) << text;
}

TEST(WordFormat, EveryBlockContainsItsFunction_BLK_203) {
  for (const std::string_view text : {"N001X+1000", "N001F0500", "N001M03", "N001I+1J+1X+1Y+1"}) {
    const auto block = read_block(text, 1);
    ASSERT_FALSE(block.has_value()) << text << ": G00 to G03 are not modal";
    EXPECT_EQ(block.error().word, 'G') << text;
  }
}

TEST(WordFormat, ToolRow_D_50) {
  const Block row = tape_block("T099R+5000L-1000", kToolTable);
  EXPECT_EQ(row.number, 99);
  EXPECT_EQ(row.find(Address::R)->number, 5000);
  EXPECT_EQ(row.find(Address::L)->number, -1000);
  EXPECT_FALSE(read_block("T100R+5000L+1000", kToolTable).has_value());
  EXPECT_FALSE(read_block("T000R+5000L+1000", kToolTable).has_value());
  EXPECT_FALSE(read_block("T001R#01L+1000", kToolTable).has_value());
  EXPECT_FALSE(read_block("T001X+1", kToolTable).has_value());
}

struct NumberRow {
  std::string_view id, text;
  std::int64_t expected_um;
};

TEST(WordFormat, LengthsAreMicrometresOrMillimetresWithAPoint_D_101) {
  constexpr NumberRow kNumbers[] = {
      {"EX-050 integer", "N001G00X+12", 12},
      {"EX-050 sign", "N001G00X-1500000", -1'500'000},
      {"no sign", "N001G00X4150", 4150},
      {"leading zeros", "N001G00X+000000000000000004150", 4150},
      {"point", "N001G00X4.15", 4150},
      {"point, three decimals", "N001G00X-0.005", -5},
      {"point at the end", "N001G00X25.", 25'000},
      {"point at the start", "N001G00X.5", 500},
      {"minus zero", "N001G00X-0", 0},
      {"blanks inside are ignored", "N001G00X+1 2\r\n 3", 123},
  };
  for (const NumberRow& row : kNumbers)
    EXPECT_EQ(tape_block(row.text).find(Address::X)->number, row.expected_um) << row.id;
}

TEST(WordFormat, ParametersInAllWordsButMAndT_PAR_003_D_94) {
  struct Row {
    std::string_view text;
    bool is_allowed;
  };
  constexpr Row kParameters[] = {
      {"N001G01X#01Y#02Z#69", true},
      {"N001G02X#01Y#01I#01J#01", true},
      {"N001G02X#01Z#01I#01K#01", true},
      {"N001G12U#03", true},
      {"N001G10R#03", true},
      {"N001G04H#63", true},
      {"N001G11F#10S#11", true},
      {"N001G22P#01N#02W#03", true},
      {"N001G81Z#60Q#61V#62H#63", true},
      {"N001G86R#58D#59W#46", true},
      {"N001\\53N#05", true},
      {"N001G11T#01", false},
      {"N001G11M#01", false},
      {"N001\\00#00#01", false},
  };
  for (const Row& row : kParameters) EXPECT_EQ(read_block(row.text, 1).has_value(), row.is_allowed) << row.text;
}

}  // namespace
}  // namespace cnclab::language
