// Completeness and limits of a block before it is stored: words needed (D-45), machine data (D-46), M (D-51), cycles.
#include "language/check_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tape_block.hpp"

namespace cnclab::language {
namespace {

constexpr EntryLimits kLimits{.x = {500'000}, .y = {400'000}, .z = {300'000}, .f_max = 3000, .s_max = 2500};

struct CheckRow {
  std::string_view id, text;
  std::optional<ErrorCode> fault;
  char word = 0;
  std::string_view expected = "";
  std::uint16_t program = 1;
};

void check_rows(std::span<const CheckRow> rows, const Vocabulary& vocabulary, const EntryLimits* limits) {
  for (const CheckRow& row : rows) {
    SCOPED_TRACE(row.id);
    const auto checked = check_block(tape_block(row.text, row.program), Plane::xy, vocabulary, limits);
    ASSERT_EQ(checked.has_value(), !row.fault.has_value());
    if (checked) continue;
    EXPECT_EQ(checked.error().code, *row.fault);
    EXPECT_EQ(checked.error().word, row.word);
    EXPECT_EQ(checked.error().block, 1);
    if (!row.expected.empty()) {
      EXPECT_EQ(checked.error().expected, row.expected);
    }
  }
}

constexpr auto kMissing = ErrorCode::word_missing;
constexpr auto kRange = ErrorCode::word_out_of_range;
constexpr auto kCycle = ErrorCode::cycle_value_wrong;

TEST(CheckBlock, NeededWords_D_45_EDIT_014) {
  constexpr CheckRow kRows[] = {
      {"BLK-100 no axis", "N001G00", kMissing, 'X'},
      {"BLK-100 one axis", "N001G00Z+1", {}},
      {"BLK-101 no word", "N001G01", kMissing, 'X'},
      {"BLK-101 one word", "N001G01M03", {}},
      {"BLK-102 all", "N001G02X+1Y+1I+1J+1", {}},
      {"BLK-102 all, XZ", "N001G02X+1Z+1I+1K+1", {}},
      {"BLK-102 J missing", "N001G02X+1Y+1I+1", kMissing, 'J'},
      {"BLK-102 first missing word", "N001G02Y+1J+1", kMissing, 'X'},
      {"BLK-103 K missing, YZ", "N001G03Y+1Z+1J+1", kMissing, 'K'},
      {"BLK-104 H missing", "N001G04", kMissing, 'H'},
      {"BLK-105 R missing", "N001G05X+1Y+1", kMissing, 'R'},
      {"BLK-105 axes and R", "N001G05X+1Y+1R+1", {}},
      {"BLK-105 XZ", "N001G05X+1R+1Z+1F0100", {}},
      {"BLK-106 Y missing", "N001G06X+1R+1F0100", kMissing, 'Y'},
      {"BLK-107 Z missing", "N001G07X+1Y+1I+1J+1", kMissing, 'Z'},
      {"BLK-107 all five", "N001G07X+1Y+1I+1J+1Z+1", {}},
      {"BLK-110 R missing", "N001G10", kMissing, 'R'},
      {"BLK-111 no word", "N001G11", kMissing, 'F'},
      {"BLK-112 U missing", "N001G12", kMissing, 'U'},
      {"BLK-117 nothing needed", "N001G17", {}},
      {"BLK-122 W missing", "N001G22P0001N001", kMissing, 'W'},
      {"BLK-168 no axis", "N001G68", kMissing, 'X'},
      {"BLK-175 F alone", "N001G75F0100", kMissing, 'X'},
      {"BLK-175 one axis", "N001G75Y-1000", {}},
      {"CYC-081 G81", "N001G81Z-1V001H0000", {}},
      {"CYC-081 G81 V missing", "N001G81Z-1H0000", kMissing, 'V'},
      {"CYC-081 G81 H missing", "N001G81Z-1V001", kMissing, 'H'},
      {"CYC-082 G82 Q missing", "N001G82Z-1V001H0000", kMissing, 'Q'},
      {"CYC-084 G84 X missing", "N001G84Y+1Z-1Q-1V001", kMissing, 'X'},
      {"CYC-085 G85 without H", "N001G85X+9Y+9Z-1Q-1V001", {}},
      {"DEC-54 G86 without Q", "N001G86R+1D000W06Z-1V001H0000", {}},
      {"DEC-54 G86 D missing", "N001G86R+1W06Z-1V001H0000", kMissing, 'D'},
      {"D-50 empty tool row", "T001", kMissing, 'R', "", kToolTable},
      {"D-50 radius alone", "T001R+1", {}, 0, "", kToolTable},
  };
  check_rows(kRows, {}, nullptr);
}

/// Every form with all its words, and the letters that it cannot do without.
struct NeedRow {
  std::string_view id, text, needed;
};

TEST(CheckBlock, EveryFormNeedsTheseWordsAndNoOthers_D_45_DEC_54) {
  constexpr NeedRow kRows[] = {
      {"BLK-102 G17", "N001G02X+1Y+1I+1J+1", "XYIJ"},
      {"BLK-102 G18", "N001G02X+1Z+1I+1K+1", "XZIK"},
      {"BLK-102 G19", "N001G02Y+1Z+1J+1K+1", "YZJK"},
      {"BLK-103", "N001G03X+1Y+1I+1J+1", "XYIJ"},
      {"BLK-104", "N001G04H0010", "H"},
      {"BLK-105 G17", "N001G05X+1Y+1R+1F0100S0100T01M03", "XYR"},
      {"BLK-105 G18", "N001G05X+1R-1Z+1F0100S0100T01M03", "XRZ"},
      {"BLK-105 G19", "N001G05R+1Y+1Z+1F0100S0100T01M03", "RYZ"},
      {"BLK-106", "N001G06X+1Y+1R+1F0100S0100T01M03", "XYR"},
      {"BLK-107", "N001G07X+1Y+1I+1J+1Z+1", "XYIJZ"},
      {"BLK-108", "N001G08X+1Y+1I+1J+1Z+1", "XYIJZ"},
      {"BLK-110", "N001G10R+1", "R"},
      {"BLK-112", "N001G12U+1", "U"},
      {"BLK-161 G62", "N001G62X+1Y+1I+1J+1", "XYIJ"},
      {"BLK-161 G63", "N001G63X+1Y+1I+1J+1", "XYIJ"},
      {"BLK-161 G64", "N001G64H0010", "H"},
      {"BLK-161 G65", "N001G65X+1Y+1R+1F0100S0100T01M03", "XYR"},
      {"BLK-161 G66", "N001G66X+1Y+1R+1F0100S0100T01M03", "XYR"},
      {"CYC-081 G81", "N001G81X+1Y+1Z-1Q-1V001H0000", "ZVH"},
      {"CYC-082 G82", "N001G82X+1Y+1Z-1Q-1V001H0000", "ZQVH"},
      {"CYC-083 G83", "N001G83X+1Y+1Z-1Q-1V001H0000", "ZVH"},
      {"CYC-084 G84", "N001G84X+1Y+0Z-1Q-1V001H0000", "XYZQV"},
      {"CYC-085 G85", "N001G85X+1Y+1Z-1Q-1V001H0000", "XYZQV"},
      {"DEC-54 G86", "N001G86R+1D000W06Z-1Q-1V001H0000", "RDWZVH"},
  };
  for (const NeedRow& row : kRows) {
    SCOPED_TRACE(row.id);
    const Block whole = tape_block(row.text);
    EXPECT_TRUE(check_block(whole, plane_of_words(whole, Plane::xy), {}, nullptr).has_value());
    for (std::size_t i = 0; i < whole.words.size(); ++i) {
      Block block = whole;
      const char without = letter(whole.words[i].address);
      block.words.erase(block.words.begin() + static_cast<std::ptrdiff_t>(i));
      const auto checked = check_block(block, plane_of_words(whole, Plane::xy), {}, nullptr);
      ASSERT_EQ(checked.has_value(), !row.needed.contains(without)) << without;
      if (checked) continue;
      EXPECT_EQ(checked.error().code, kMissing) << without;
      EXPECT_EQ(checked.error().word, without);
    }
  }
}

TEST(CheckBlock, OneOfSeveralWordsIsEnough_D_45) {
  constexpr NeedRow kRows[] = {
      {"BLK-100", "N001G00X+1Y+1Z+1", "XYZ"},         {"BLK-101", "N001G01X+1Y+1Z+1F0100S0100T01M03", "XYZFSTM"},
      {"BLK-111", "N001G11F0100S0100T01M03", "FSTM"}, {"BLK-161 G61", "N001G61X+1Y+1Z+1F0100S0100T01M03", "XYZFSTM"},
      {"BLK-168", "N001G68X+1Y+1Z+1", "XYZ"},         {"BLK-169", "N001G69X+1Y+1Z+1", "XYZ"},
      {"BLK-175", "N001G75X+1Y+1Z+1F0100", "XYZ"},
  };
  for (const NeedRow& row : kRows) {
    SCOPED_TRACE(row.id);
    const Block whole = tape_block(row.text);
    for (const Word& word : whole.words) {
      const Block block{.number = 1, .function = whole.function, .words = {word}};
      EXPECT_EQ(check_block(block, Plane::xy, {}, nullptr).has_value(), row.needed.contains(letter(word.address)))
          << letter(word.address);
    }
    const Block none{.number = 1, .function = whole.function};
    EXPECT_EQ(check_block(none, Plane::xy, {}, nullptr).error().word, letter(whole.words.front().address));
  }
}

TEST(CheckBlock, WordsNeedNotStandInTheOrderOfTheForm) {
  Block block = tape_block("N001G01X+500001Y+1F3001M03");
  std::ranges::reverse(block.words);
  EXPECT_TRUE(check_block(block, Plane::xy, {}, nullptr).has_value());
  EXPECT_EQ(check_block(block, Plane::xy, {}, &kLimits).error().word, 'X') << "the first in the form's order";
}

TEST(CheckBlock, OperandsThatAreMissing_BLK_195) {
  const Block two_of_three{
      .number = 1,
      .function = {Function::Kind::parametric, 1},
      .words = {{.address = Address::operand, .number = 1}, {.address = Address::operand, .number = 2}}};
  const auto checked = check_block(two_of_three, Plane::xy, {}, nullptr);
  ASSERT_FALSE(checked.has_value());
  EXPECT_EQ(checked.error().code, kMissing);
  EXPECT_EQ(checked.error().word, '#');
  EXPECT_TRUE(check_block(tape_block("N001\\01#01#02#03"), Plane::xy, {}, nullptr).has_value());
}

TEST(CheckBlock, ValuesAboveTheMachineData_D_46_EDIT_015_016) {
  constexpr CheckRow kRows[] = {
      {"MD 03 X at the limit", "N001G00X-500000", {}},
      {"MD 03 X above", "N001G00X-500001", kRange, 'X', "-500.000..500.000"},
      {"MD 03 I above", "N001G02X+1Y+1I+500001J+1", kRange, 'I'},
      {"MD 04 Y above", "N001G00Y+400001", kRange, 'Y', "-400.000..400.000"},
      {"MD 04 J above", "N001G02X+1Y+1I+1J-400001", kRange, 'J'},
      {"MD 05 Z above", "N001G00Z+300001", kRange, 'Z'},
      {"MD 05 K above", "N001G02X+1Z+1I+1K+300001", kRange, 'K'},
      {"MD 05 Q above", "N001G82Z-1Q-300001V001H0000", kRange, 'Q'},
      {"EDIT-016 F at F MAX", "N001G01F3000", {}},
      {"EDIT-016 F above F MAX", "N001G01F3001", kRange, 'F', "0001..3000"},
      {"EDIT-016 S above S MAX", "N001G11S2501", kRange, 'S', "0001..2500"},
      {"MD 03 I at the limit", "N001G02X+1Y+1I-500000J+1", {}},
      {"MD 03 to 05 in a helix", "N001G07X+1Y+1I+1J+1Z-300001", kRange, 'Z', "-300.000..300.000"},
      {"MD 03 in a cycle", "N001G85X+500001Y+9Z-1Q-1V001", kRange, 'X'},
      {"MD 05 in a cycle", "N001G81Z-300001V001H0000", kRange, 'Z'},
      {"MD 03 in G68", "N001G68X-500001", kRange, 'X'},
      {"MD 03 in G69", "N001G69X-500001", kRange, 'X'},
      {"D-46 R and L of a tool by their formats", "T001R+9999999L-9999999", {}, 0, "", kToolTable},
      {"D-46 R of G05 by its format", "N001G05X+1Y+1R-9999999", {}},
      {"D-46 R of G86 by its format", "N001G86R+9999999D000W06Z-1V001H0000", {}},
      {"D-46 U by its format", "N001G12U+9999999", {}},
      {"D-46 R by its format", "N001G10R+9999999", {}},
      {"D-46 G75 factors", "N001G75X+9999999Y-9999999Z+9999999", {}},
      {"D-46 F of G75", "N001G75X+1000F3001", kRange, 'F'},
      {"D-46 a parameter is checked at execution", "N001G01X#01F#02", {}},
      {"word order decides: X before F", "N001G01X+500001F3001", kRange, 'X'},
  };
  check_rows(kRows, {}, &kLimits);
}

TEST(CheckBlock, TransferredBlocksAreCheckedForFormOnly_DEC_13_EX_050) {
  EXPECT_TRUE(check_block(tape_block("N001G00X+12Y-1500000Z+4150"), Plane::xy, {}, nullptr).has_value());
  EXPECT_FALSE(check_block(tape_block("N001G00X+12Y-1500000Z+4150"), Plane::xy, {}, &kLimits).has_value());
}

TEST(CheckBlock, ValuesThatNoMachineTakes_D_50_D_51_D_93) {
  constexpr CheckRow kRows[] = {
      {"D-51 M06", "N001G01M06", ErrorCode::m_unknown, 'M'},
      {"D-51 M99", "N001G11M99", ErrorCode::m_unknown, 'M'},
      {"M-024", "N001G11M24", {}},
      {"BLK-013 G04 H0000", "N001G04H0000", kRange, 'H', "0001..9999"},
      {"BLK-013 G64 H0000", "N001G64H0000", kRange, 'H'},
      {"D-51 M99 in G05", "N001G05X+1Y+1R+1M99", ErrorCode::m_unknown, 'M'},
      {"BLK-110 radius 0", "N001G10R+0", kRange, 'R', "0.001..9999.999"},
      {"BLK-110 radius below 0", "N001G10R-1000", kRange, 'R'},
      {"BLK-110 radius by a parameter", "N001G10R#01", {}},
      {"D-66 radius below 0 is the longer arc", "N001G06X+1Y+1R-1000", {}},
      {"DEC-64 G20 to a cycle", "N001G20P9981N001", ErrorCode::reserved_for_cycles, 'P'},
      {"DEC-64 G23 to a cycle", "N001G23P9989N001W00", ErrorCode::reserved_for_cycles, 'P'},
      {"DEC-64 G22 beside the cycles", "N001G22P9980N001W00", {}},
      {"DEC-64 G21 beside the cycles", "N001G21P9990N001", {}},
      {"DEC-64 target by a parameter", "N001G20P#01N#02", {}},
      {"D-50 tool length below 0", "T001R+0L-1", {}, 0, "", kToolTable},
      {"D-50 tool radius below 0", "T001R-1L+1", kRange, 'R', "0.000..9999.999", kToolTable},
      {"D-93 #64 as target", "N001\\10#64#01", ErrorCode::parameter_read_only, '#'},
      {"D-93 #68 as target", "N001\\00#68+1", ErrorCode::parameter_read_only, '#'},
      {"D-93 #64 of a sum", "N001\\01#64#01#02", ErrorCode::parameter_read_only, '#'},
      {"D-93 #67 of INC", "N001\\11#67#01", ErrorCode::parameter_read_only, '#'},
      {"D-93 #64 to #68 as operands", "N001\\01#01#64#68", {}},
      {"D-93 #69 as target", "N001\\10#69#64", {}},
      {"D-93 #63 as target", "N001\\10#63#68", {}},
  };
  check_rows(kRows, {}, nullptr);
}

TEST(CheckBlock, CycleValues_D_89_CYC_011_ROM_03) {
  constexpr CheckRow kRows[] = {
      {"D-89 Z 0", "N001G81Z+0V001H0000", kCycle, 'Z'},
      {"D-89 Z above", "N001G83Z+1V001H0000", kCycle, 'Z'},
      {"D-89 Q 0 in G82", "N001G82Z-2Q+0V001H0000", kCycle, 'Q'},
      {"CYC-006 Q ignored in G81", "N001G81Z-2Q+5V001H0000", {}},
      {"D-89 Q above in G86", "N001G86R+1D000W06Z-1Q+1V001H0000", kCycle, 'Q'},
      {"D-89 Z 0 in G82", "N001G82Z+0Q-1V001H0000", kCycle, 'Z'},
      {"D-89 Z 0 in G84", "N001G84X+9Y+0Z+0Q-1V001", kCycle, 'Z'},
      {"D-89 Z above in G85", "N001G85X+9Y+9Z+1Q-1V001", kCycle, 'Z'},
      {"D-89 Z 0 in G86", "N001G86R+1D000W06Z+0V001H0000", kCycle, 'Z'},
      {"D-89 Q 0 in G84", "N001G84X+9Y+0Z-1Q+0V001", kCycle, 'Q'},
      {"D-89 Q above in G85", "N001G85X+9Y+9Z-1Q+1V001", kCycle, 'Q'},
      {"CYC-006 Q ignored in G83", "N001G83Z-2Q+5V001H0000", {}},
      {"DEC-53 H0000 in a cycle", "N001G81Z-2V001H0000", {}},
      {"ROM-03 G86 R below 0", "N001G86R-1D000W06Z-1V001H0000", kCycle, 'R'},
      {"ROM-03 G86 R 0", "N001G86R+0D000W06Z-1V001H0000", kCycle, 'R'},
      {"ROM-03 G86 W 00", "N001G86R+1D000W00Z-1V001H0000", kCycle, 'W'},
      {"DEC-53 G84 along X", "N001G84X+40000Y+0Z-1Q-1V001", {}},
      {"DEC-53 G84 along Y", "N001G84X+0Y+40000Z-1Q-1V001", {}},
      {"DEC-53 G84 both", "N001G84X+40000Y+40000Z-1Q-1V001", kCycle, 'Y'},
      {"DEC-53 G84 none", "N001G84X+0Y+0Z-1Q-1V001", kCycle, 'Y'},
      {"DEC-53 G84 Y below 0", "N001G84X+0Y-1Z-1Q-1V001", kCycle, 'Y'},
      {"DEC-53 G84 one by a parameter", "N001G84X+5Y#01Z-1Q-1V001", {}},
      {"DEC-53 G84 below 0", "N001G84X-1Y+0Z-1Q-1V001", kCycle, 'X'},
      {"CYC-090 G85 X 0", "N001G85X+0Y+1Z-1Q-1V001", kCycle, 'X'},
      {"CYC-090 G85 Y below 0", "N001G85X+1Y-1Z-1Q-1V001", kCycle, 'Y'},
      {"D-89 by a parameter at execution", "N001G82Z#01Q#02V#03H#04", {}},
  };
  check_rows(kRows, {}, nullptr);
}

TEST(CheckBlock, FunctionsThatTheControlDoesNotHave_EDIT_011_MODEL_DEC_03) {
  constexpr CheckRow kReduced[] = {
      {"MODEL-002 G02", "N001G02X+1Y+1I+1J+1", ErrorCode::function_unknown, 'G'},
      {"MODEL-006 ↓00", "N001\\00#01+1", ErrorCode::function_unknown, 'G'},
      {"MODEL-006 #nn in a word", "N001G01X#01", ErrorCode::word_not_allowed, 'X'},
      {"MODEL-001 G01", "N001G01X+1", {}},
  };
  check_rows(kReduced, {.model = Model::cnc3250}, nullptr);
  constexpr CheckRow kUnplanned[] = {
      {"DEC-03 G81 switched off", "N001G81Z-1V001H0000", ErrorCode::function_unknown, 'G'},
      {"DEC-03 SQRT switched off", "N001\\15#01#02", ErrorCode::function_unknown, 'G'},
      {"DEC-03 G02 stays", "N001G02X+1Y+1I+1J+1", {}},
  };
  check_rows(kUnplanned, {.planned_functions = false}, nullptr);
}

TEST(CheckBlock, WordsOfAnotherFunctionOrTwice) {
  const Block foreign{.number = 1,
                      .function = {Function::Kind::g, 0},
                      .words = {{.address = Address::X, .number = 1}, {.address = Address::F, .number = 1}}};
  const Block twice{.number = 1,
                    .function = {Function::Kind::g, 0},
                    .words = {{.address = Address::X, .number = 1}, {.address = Address::X, .number = 1}}};
  EXPECT_EQ(check_block(foreign, Plane::xy, {}, nullptr).error().code, ErrorCode::word_not_allowed);
  EXPECT_EQ(check_block(foreign, Plane::xy, {}, nullptr).error().word, 'F');
  EXPECT_EQ(check_block(twice, Plane::xy, {}, nullptr).error().code, ErrorCode::word_not_allowed);
}

TEST(CheckProgram, AllFaultsWithTheirPlace_D_54) {
  const Tape tape = read_tape("P0007N001G04N002G18N003G02X+1N004G01M03N005G11M07", Reading::file);
  ASSERT_EQ(tape.programs.size(), 1U);
  const std::vector<Error> errors = check_program(tape.programs[0].program, {}, nullptr);
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0], (Error{.code = kMissing, .program = 7, .block = 1, .word = 'H'}));
  EXPECT_EQ(errors[1], (Error{.code = kMissing, .program = 7, .block = 3, .word = 'Z'}));  // G18 chose X Z I K
  EXPECT_EQ(errors[2], (Error{.code = ErrorCode::m_unknown, .program = 7, .block = 5, .word = 'M', .detail = "07"}));
}

TEST(Program, FindsBlocksByNumber_EDIT_032) {
  const Tape tape = read_tape("P0001N005G17N010G18N999G19", Reading::file);
  ASSERT_EQ(tape.programs.size(), 1U);
  const Program& program = tape.programs[0].program;
  EXPECT_EQ(program.find(5), 0U);
  EXPECT_EQ(program.find(999), 2U);
  for (const std::uint16_t missing : std::initializer_list<std::uint16_t>{1, 6, 11, 998})
    EXPECT_EQ(program.find(missing), std::nullopt);
}

}  // namespace
}  // namespace cnclab::language
