// The ROM programs against the listings: CYC-205 to CYC-327, rom-programs P9983 to P9986; who may see and change them.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "language/check_block.hpp"
#include "program/check_programs.hpp"
#include "program/reachable.hpp"
#include "program/rom_programs.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::IsEmpty;

struct Listed {
  std::string_view id, block;
};

constexpr Listed kCommon[] = {
    {"CYC-205", R"(N005\00#00+0)"},     {"CYC-206", R"(N006\00#54-500)"},   {"CYC-207", R"(N007\10#55#64)"},
    {"CYC-208", R"(N008\10#56#65)"},    {"CYC-209", R"(N009\10#57#66)"},    {"CYC-213", R"(N013\13#62#62)"},
    {"CYC-220", R"(N020\01#50#60#54)"}, {"CYC-221", R"(N021\01#51#61#54)"}, {"CYC-222", R"(N022\02#52#62#54)"},
    {"CYC-223", R"(N023G91)"},          {"CYC-224", R"(N024\13#54#54)"},    {"CYC-230", R"(N030\10#47#67)"},
    {"CYC-231", R"(N031\01#47#47#67)"}, {"CYC-232", R"(N032\02#58#58#47)"}, {"CYC-233", R"(N033\51N040)"},
    {"CYC-234", R"(N034\00#58+0)"},     {"CYC-240", R"(N040\02#59#59#47)"}, {"CYC-241", R"(N041\51N050)"},
    {"CYC-242", R"(N042\00#59+0)"},     {"CYC-250", R"(N050\00#53+800)"},   {"CYC-251", R"(N051\03#53#53#47)"},
    {"CYC-260", R"(N060\03#48#58#54)"}, {"CYC-261", R"(N061\03#49#59#54)"}, {"CYC-262", R"(N062\13#48#48)"},
    {"CYC-263", R"(N063\13#49#49)"},
};

constexpr Listed kDrilling[] = {
    {"CYC-300", R"(N100\02#60#60#61)"}, {"CYC-301", R"(N101G00Z#52)"},      {"CYC-302", R"(N102\50N120)"},
    {"CYC-303", R"(N103\51N120)"},      {"CYC-304", R"(N104G01Z#51)"},      {"CYC-305", R"(N105G90)"},
    {"CYC-306", R"(N106G00Z#57)"},      {"CYC-307", R"(N107G91)"},          {"CYC-308", R"(N108\01#52#52#61)"},
    {"CYC-309", R"(N109\53N100)"},      {"CYC-320", R"(N120\01#60#60#51)"}, {"CYC-321", R"(N121G01Z#60)"},
    {"CYC-322", R"(N122G04H#63)"},      {"CYC-323", R"(N123G90)"},          {"CYC-324", R"(N124G45)"},
    {"CYC-325", R"(N125G00Z#57)"},      {"CYC-326", R"(N126G91)"},
};

constexpr std::string_view kThread = R"(N100G11M03 )"
                                     R"(N101G00Z#52 )"
                                     R"(N102G01Z#50 )"
                                     R"(N103G11M05 )"
                                     R"(N104G04H#63 )"
                                     R"(N105G11M04 )"
                                     R"(N106G90 )"
                                     R"(N107G01Z#57 )"
                                     R"(N108G11M05 )"
                                     R"(N109G91 )";

constexpr std::string_view kSlot = R"(N100G00X#48Y#49 )"
                                   R"(N101\02#60#60#61 )"
                                   R"(N102G00Z#52 )"
                                   R"(N103\50N120 )"
                                   R"(N104\51N120 )"
                                   R"(N105G01Z#51 )"
                                   R"(N106G01X#58Y#59 )"
                                   R"(N107G90 )"
                                   R"(N108G00Z#57 )"
                                   R"(N109G91 )"
                                   R"(N110\01#52#52#61 )"
                                   R"(N111\13#58#58 )"
                                   R"(N112\13#59#59 )"
                                   R"(N113\53N101 )"
                                   R"(N120\01#60#60#51 )"
                                   R"(N121G01Z#60 )"
                                   R"(N122G01X#58Y#59 )"
                                   R"(N123G90 )"
                                   R"(N124G00Z#57 )"
                                   R"(N125G00X#55Y#56 )"
                                   R"(N126G91 )";

constexpr std::string_view kPocket = R"(N100\01#48#48#55 )"
                                     R"(N101\01#49#49#56 )"
                                     R"(N102G90 )"
                                     R"(N103G00X#48Y#49 )"
                                     R"(N104G91 )"
                                     R"(N105\02#60#60#61 )"
                                     R"(N106G00Z#52 )"
                                     R"(N107\50N111 )"
                                     R"(N108\51N111 )"
                                     R"(N109G01Z#51 )"
                                     R"(N110\53N113 )"
                                     R"(N111\01#50#60#51 )"
                                     R"(N112G01Z#50 )"
                                     R"(N113G01X#58 )"
                                     R"(N114G01Y#59 )"
                                     R"(N115\13#58#58 )"
                                     R"(N116\13#59#59 )"
                                     R"(N117G01X#58 )"
                                     R"(N118G01Y#59 )"
                                     R"(N119\13#58#58 )"
                                     R"(N120\13#59#59 )"
                                     R"(N121\02#46#58#54 )"
                                     R"(N122\02#46#46#54 )"
                                     R"(N123\50N150 )"
                                     R"(N124\52N150 )"
                                     R"(N125\02#47#59#54 )"
                                     R"(N126\02#47#47#54 )"
                                     R"(N127\50N150 )"
                                     R"(N128\52N150 )"
                                     R"(N129G01X#54Y#54 )"
                                     R"(N130G01X#46 )"
                                     R"(N131\13#46#46 )"
                                     R"(N132\02#47#47#53 )"
                                     R"(N133\51N140 )"
                                     R"(N134\01#47#47#53 )"
                                     R"(N135G01Y#47 )"
                                     R"(N136G01X#46 )"
                                     R"(N137\53N150 )"
                                     R"(N140G01Y#53 )"
                                     R"(N141\53N130 )"
                                     R"(N150G90 )"
                                     R"(N151G00Z#57 )"
                                     R"(N152G91 )"
                                     R"(N153\01#52#52#61 )"
                                     R"(N154\01#60#60#00 )"
                                     R"(N155\52N102 )"
                                     R"(N156G90 )"
                                     R"(N157G00X#55Y#56 )"
                                     R"(N158G91 )";

constexpr std::string_view kHoleCircle = R"(N100\00#53+360000 )"
                                         R"(N101\04#53#53#46 )"
                                         R"(N102\17#47#59 )"
                                         R"(N103\03#47#47#58 )"
                                         R"(N104\01#47#47#55 )"
                                         R"(N105\16#48#59 )"
                                         R"(N106\03#48#48#58 )"
                                         R"(N107\01#48#48#56 )"
                                         R"(N108G90 )"
                                         R"(N109G00X#47Y#48 )"
                                         R"(N110G91 )"
                                         R"(N111\01#60#50#54 )"
                                         R"(N112\01#52#62#54 )"
                                         R"(N120\02#60#60#61 )"
                                         R"(N121G00Z#52 )"
                                         R"(N122\50N130 )"
                                         R"(N123\51N130 )"
                                         R"(N124G01Z#51 )"
                                         R"(N125G90 )"
                                         R"(N126G00Z#57 )"
                                         R"(N127G91 )"
                                         R"(N128\01#52#52#61 )"
                                         R"(N129\53N120 )"
                                         R"(N130\01#60#60#51 )"
                                         R"(N131G01Z#60 )"
                                         R"(N132G04H#63 )"
                                         R"(N133G90 )"
                                         R"(N134G00Z#57 )"
                                         R"(N135G91 )"
                                         R"(N140\01#59#59#53 )"
                                         R"(N141\12#46#46 )"
                                         R"(N142\51N102 )"
                                         R"(N143G90 )"
                                         R"(N144G00X#55Y#56 )"
                                         R"(N145G91 )";

std::vector<std::string> blocks_of(std::uint16_t number) {
  std::vector<std::string> blocks;
  const language::Program* program = rom_program(number);
  if (program == nullptr) return blocks;
  for (const language::Block& block : program->blocks) blocks.push_back(language::write_block(block));
  return blocks;
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

constexpr std::string_view kLastOfHoleCircle = "N024";  // N030 to N063 are absent there (DEC-54)

/// The common part and the cycle's own, as listed.
std::vector<std::string> listed(std::uint16_t number) {
  std::vector<std::string> blocks;
  for (const Listed& row : kCommon)
    if (number != 9986 || row.block.substr(0, 4) <= kLastOfHoleCircle) blocks.emplace_back(row.block);
  if (number <= 9982)
    for (const Listed& row : kDrilling) blocks.emplace_back(row.block);
  constexpr std::string_view kOwn[] = {kThread, kSlot, kPocket, kHoleCircle};
  if (number >= 9983)
    for (std::string& block : words_of(kOwn[number - 9983])) blocks.push_back(std::move(block));
  return blocks;
}

TEST(RomPrograms, AreTheListedOnes) {
  for (std::uint16_t number = 9981; number <= 9986; ++number) EXPECT_EQ(blocks_of(number), listed(number)) << number;
}

bool has_block(std::uint16_t number, std::string_view block) {
  const std::vector<std::string> blocks = blocks_of(number);
  return std::ranges::find(blocks, block) != blocks.end();
}

/// One failure per requirement: which block of the manual's listing is missing.
TEST(RomPrograms, HaveEveryBlockOfTheManual_CYC205_to_CYC326) {
  for (const std::span<const Listed> part : {std::span<const Listed>(kCommon), std::span<const Listed>(kDrilling)})
    for (const Listed& row : part) EXPECT_TRUE(has_block(9982, row.block)) << row.id;
  EXPECT_EQ(rom_program(9982)->blocks.back().number, 126);  // CYC-327: the end follows
  EXPECT_FALSE(rom_program(9982)->find(25));                // CYC-225: the gap is empty
}

TEST(RomPrograms, SixOfNineNumbersAreTaken_DEC64) {
  EXPECT_EQ(rom_program(9980), nullptr);
  for (const int number : {9987, 9988, 9989, 9990, 0, 1})
    EXPECT_EQ(rom_program(static_cast<std::uint16_t>(number)), nullptr) << number;
  EXPECT_EQ(rom_program(9985), rom_program(9985));  // read once
}

TEST(RomPrograms, BelongToTheirFunctions_CYC002) {
  using language::Function;
  for (std::uint8_t code = 81; code <= 86; ++code) {
    const language::Program* program = rom_program_of({Function::Kind::g, code});
    ASSERT_NE(program, nullptr) << int{code};
    EXPECT_EQ(program->number, 9900 + code);
  }
  EXPECT_EQ(rom_program_of({Function::Kind::g, 80}), nullptr);
  EXPECT_EQ(rom_program_of({Function::Kind::g, 87}), nullptr);
  EXPECT_EQ(rom_program_of({Function::Kind::parametric, 81}), nullptr);
}

/// With other numbers the ROM's text is an ordinary tape, without errors and with the same blocks.
TEST(RomPrograms, TextIsAnOrdinaryTape) {
  std::string text(rom_text());
  for (std::size_t place = text.find("\nP998"); place != std::string::npos; place = text.find("\nP998", place + 1))
    text[place + 4] = '0';
  const language::Tape tape = language::read_tape(text, language::Reading::file);
  EXPECT_THAT(tape.errors, IsEmpty());
  ASSERT_EQ(tape.programs.size(), 6u);
  for (const language::ReadProgram& read : tape.programs)
    EXPECT_EQ(read.program.blocks, rom_program(static_cast<std::uint16_t>(read.program.number + 80))->blocks);
}

TEST(RomPrograms, AreCompleteForTheControl) {
  for (std::uint16_t number = 9981; number <= 9986; ++number)
    EXPECT_THAT(language::check_program(*rom_program(number), {}, nullptr), IsEmpty()) << number;
}

TEST(RomPrograms, AreWhatEverySetShows_DEC06) {
  ProgramSet programs;
  programs.put({.number = 9981, .blocks = {{.number = 1, .function = {language::Function::Kind::g, 17}}}});
  EXPECT_EQ(programs.find(9981), rom_program(9981));
  EXPECT_EQ(programs.find(9987), nullptr);
  const language::Tape tape = language::read_tape("P9981N001G17N002G18%", language::Reading::file);
  EXPECT_THAT(tape.programs, IsEmpty());
  EXPECT_EQ(tape.notices.size(), 1u);
}

TEST(RomPrograms, AreReachedThroughTheirCycles) {
  const ProgramSet programs = programs_of("P0001N001G81Z-5000V002H0000N002G17%");
  std::vector<int> seen;
  walk_reachable(programs, 1, 1, [&](geometry::SourceBlock source, const language::Block&) {
    seen.push_back(source.program);
    return true;
  });
  EXPECT_EQ(std::ranges::count(seen, 1), 2);
  EXPECT_EQ(std::ranges::count(seen, 9981), std::ssize(rom_program(9981)->blocks));
}

/// What `check` says about a program, by block number.
std::vector<std::pair<int, ErrorCode>> faults_of(std::string_view text) {
  std::vector<std::pair<int, ErrorCode>> faults;
  for (const language::Error& error : check_blocks(programs_of(text), wide_settings()))
    faults.emplace_back(error.block, error.code);
  return faults;
}

TEST(CheckCycles, FindsWrongValuesAndNothingElse_D89) {
  using Faults = std::vector<std::pair<int, ErrorCode>>;
  EXPECT_EQ(faults_of("P0001N001G81Z-5000V002H0000N002G82Z-5000Q-1000V002H0005N003G83Z-5000V002H0010"
                      "N004G84X+40000Y+0Z-5000Q-2000V002N005G85X+40000Y+30000Z-5000Q-2000V002"
                      "N006G86R+25000D000W04Z-5000V002H0000N007G82Z#01Q#02V#03H#04N008\\51N#05%"),
            Faults{});
  constexpr auto kWrong = ErrorCode::cycle_value_wrong;
  EXPECT_EQ(faults_of("P0001N001G81Z+5000V002H0000N002G82Z-5000Q+0V002H0005N003G84X+40000Y+10000Z-5000Q-2000V002"
                      "N004G85X+0Y+30000Z-5000Q-2000V002N005G86R+25000D000W00Z-5000V002H0000%"),
            (Faults{{1, kWrong}, {2, kWrong}, {3, kWrong}, {4, kWrong}, {5, kWrong}}));
  EXPECT_EQ(
      faults_of("P0001N001\\00#64+0N002\\53N099N003G20P9982N001%"),
      (Faults{
          {1, ErrorCode::parameter_read_only}, {2, ErrorCode::block_missing}, {3, ErrorCode::reserved_for_cycles}}));
}

TEST(CheckCycles, DryRunFindsWhatTheCutterDecides_D85) {
  const ProgramSet programs = programs_of("P0000T001R+20000L+0\nP0001N001G11F0100T01N002G85X+40000Y+90000Z-5Q-5V001%");
  const std::vector<language::Error> errors = dry_run(programs, wide_settings(), {}, 100);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors.front().code, ErrorCode::cycle_value_wrong);
  EXPECT_EQ(language::place_of(errors.front()), "P0001 N002");
}

}  // namespace
}  // namespace cnclab::program
