// Keying in one word, digit by digit (D-14, DEC-12, BLK-005 to BLK-016), and the memory's arithmetic (D-22).
#include <gtest/gtest.h>

#include <ostream>
#include <string_view>

#include "bench.hpp"
#include "panel/modes/entry_line.hpp"

namespace cnclab::panel {
namespace {

using language::Address;

struct WordCase {
  std::string_view name;
  Address address;
  std::string_view typed;  ///< digits, '.', '-' sign, 'C' clear, '#' the key ↓, '>' marker leaves and comes back
  std::string_view shown;
};

std::ostream& operator<<(std::ostream& stream, const WordCase& row) { return stream << row.name; }

constexpr WordCase kWords[] = {
    {"SCR-012 empty", Address::X, "", "X.....,..."},
    {"D-14 digits are whole millimetres", Address::X, "50", "X+..50.000"},
    {"D-14 decimals after the point", Address::X, "12.34", "X+..12.340"},
    {"D-14 at most three decimals", Address::X, "1.23456", "X+...1.234"},
    {"D-14 at most four whole digits", Address::X, "123456", "X+1234.000"},
    {"D-14 a second point is ignored", Address::X, "1.2.3", "X+...1.230"},
    {"D-14 point first", Address::Y, ".5", "Y+...0.500"},
    {"D-14 sign toggles", Address::X, "5-", "X-...5.000"},
    {"D-14 sign twice", Address::X, "5--", "X+...5.000"},
    {"D-14 sign first", Address::X, "-5", "X-...5.000"},
    {"sign without a number", Address::X, "-", "X-....,..."},
    {"sign before zero", Address::X, "-0", "X-...0.000"},
    {"EDIT-029 C empties", Address::X, "12.5-C", "X.....,..."},
    {"DEC-12 first digit replaces what stands there", Address::X, "12>3", "X+...3.000"},
    {"DEC-12 further digits extend", Address::X, "12>34", "X+..34.000"},
    {"DEC-12 the sign belongs to what is replaced", Address::X, "-12>3", "X+...3.000"},
    {"DEC-12 a sign typed first stays", Address::X, "12>-3", "X-...3.000"},
    {"sign alone changes a value that stands there", Address::X, "12>-", "X-..12.000"},
    {"BLK-009 F from the right", Address::F, "1000", "F1000"},
    {"BLK-009 F with leading zeros", Address::F, "25", "F0025"},
    {"F has no decimals and no sign", Address::F, "2.5-", "F0025"},
    {"BLK-009 surplus digits", Address::F, "12345", "F1234"},
    {"BLK-013 H", Address::H, "10", "H0010"},
    {"BLK-012 M", Address::M, "03", "M03"},
    {"BLK-014 W", Address::W, "7", "W07"},
    {"BLK-006 N", Address::N, "40", "N040"},
    {"DEC-60 parameter begun", Address::X, "#", "X......↓.."},
    {"DEC-60 parameter", Address::X, "#4", "X......#04"},
    {"DEC-60 two digits", Address::X, "#63", "X......#63"},
    {"surplus parameter digits", Address::X, "#634", "X......#63"},
    {"DEC-60 in H", Address::H, "#63", "H.#63"},
    {"parameter begun in H", Address::H, "#", "H.↓.."},
    {"C leads back from a parameter", Address::X, "#4C5", "X+...5.000"},
    {"sign has no meaning for a parameter", Address::X, "#4-", "X......#04"},
    {"KEY-070 not in M", Address::M, "#3", "M03"},
    {"KEY-070 not in T", Address::T, "#3", "T03"},
};

class WordEntries : public testing::TestWithParam<WordCase> {};

TEST_P(WordEntries, ShowWhatWasTyped) {
  WordEntry word = WordEntry::of(GetParam().address, nullptr);
  for (const char key : GetParam().typed) {
    if (key >= '0' && key <= '9') word.digit(key - '0');
    if (key == '.') word.point();
    if (key == '-') word.sign();
    if (key == 'C') word.clear();
    if (key == '#') (void)word.to_parameter();
    if (key == '>') word.arrive();
  }
  EXPECT_EQ(word.text(), GetParam().shown);
}

INSTANTIATE_TEST_SUITE_P(Entry, WordEntries, testing::ValuesIn(kWords));

TEST(Entry, D_14_AfterTheLastWordTheMarkerGoesToTheFirst) {
  Bench bench;
  bench.keys("EINGABE ENTER ENTER ENTER");
  bench.type("1");
  bench.keys("ENTER ENTER ENTER");
  EXPECT_EQ(bench.monitor(3), "N001 G00 □+...1.000 Y.....,... Z.....,... (EILGANG)");
}

TEST(Entry, D_54_ArcsShowTheWordsOfTheLastPlaneBeforeThem) {
  Bench bench({.tape = "P0001N001G18N005G19%"});
  bench.keys("EINGABE ENTER");
  bench.type("3");
  bench.keys("ENTER");
  bench.type("02");
  bench.keys("ENTER");
  EXPECT_EQ(bench.monitor(5), "N003 G02 □.....,... Z.....,... I.....,... K.....,...");
  bench.keys("MENU EINGABE ENTER ENTER");
  bench.type("02");
  bench.keys("ENTER");
  EXPECT_EQ(bench.monitor(5), "N006 G02 □.....,... Z.....,... J.....,... K.....,...");
}

TEST(Entry, EDIT_004_005_006_ListsShowTenBlocksAndPage) {
  std::string tape = "P0001";
  for (int i = 1; i <= 25; ++i)
    tape += std::string(i < 10 ? "N00" : "N0") + std::to_string(i) + "G11F" + std::to_string(i);
  Bench bench({.tape = tape + "%"});
  const auto first = [&] { return bench.monitor(3).substr(0, 4); };
  const auto last = [&] { return bench.monitor(12).substr(0, 4); };
  bench.keys("EINGABE ENTER");
  EXPECT_EQ(first() + last(), "N016N025");
  EXPECT_EQ(bench.monitor(13), "□026");
  bench.keys("MENU EINGABE DOWN");
  EXPECT_EQ(first() + last(), "N001N010");
  bench.keys("DOWN");
  EXPECT_EQ(first() + last(), "N011N020") << "each further press the next ten";
  bench.type("4");
  bench.keys("DOWN");
  EXPECT_EQ(first() + last(), "N004N013");
  bench.keys("DOWN");
  EXPECT_EQ(first() + last(), "N014N023");
  bench.keys("DOWN");
  EXPECT_EQ(first(), "N024");
  bench.keys("DOWN");
  EXPECT_EQ(first(), "N024") << "nothing further to show";
}

TEST(Entry, D_47_InsertionPastN999IsRefused) {
  Bench bench({.tape = "P0001N001G11F100N999G11F200%"});
  bench.keys("EINGABE ENTER");
  bench.type("1");
  bench.keys("ENTER");
  bench.type("11");
  bench.keys("ENTER");
  bench.type("300");
  bench.keys("EINGABE");
  EXPECT_EQ(bench.stores(), 0);
  EXPECT_EQ(bench.monitor(15), "Satz überprüfen");
  EXPECT_EQ(bench.monitor(5).substr(0, static_cast<std::size_t>(columns_of("□001")) + 2), "□001")
      << "the marker stands on the number";
}

TEST(Memory, D_22_CostsAreCountedWithEveryChange) {
  Memory memory;
  EXPECT_EQ(memory.free_bytes(), 16290);
  memory = memory_of(std::string(kBild7));
  EXPECT_EQ(memory.free_bytes(), 16221);
  const language::Block block{
      .number = 2, .function = {language::Function::Kind::g, 17}, .words = {}, .is_damaged = false};
  memory.insert_block(1, block);
  EXPECT_EQ(memory.free_bytes(), 16217);
  ASSERT_EQ(memory.find(1)->blocks.size(), 6U);
  EXPECT_EQ(memory.find(1)->blocks[2].number, 3);
  EXPECT_EQ(memory.find(1)->blocks.back().number, 6);
  memory.put_block(1, block);
  EXPECT_EQ(memory.free_bytes(), 16217) << "replaced by the same";
  memory.delete_block(1, 2);
  EXPECT_EQ(memory.free_bytes(), 16221);
  memory.delete_block(1, 77);
  memory.remove_program(9);
  EXPECT_EQ(memory.free_bytes(), 16221);
  memory.remove_program(1);
  EXPECT_EQ(memory.free_bytes(), 16290);
  memory.put_block(5, block);
  memory.delete_block(5, 2);
  EXPECT_EQ(memory.find(5), nullptr) << "a program goes with its last block";
}

TEST(Memory, D_47_InsertedNumbersRiseFromTheBlockOn) {
  Memory memory = memory_of("P0001N001G17N005G18N006G19N009G17%");
  memory.insert_block(1,
                      {.number = 5, .function = {language::Function::Kind::g, 90}, .words = {}, .is_damaged = false});
  std::string numbers;
  for (const language::Block& block : memory.find(1)->blocks) numbers += std::to_string(block.number) + " ";
  EXPECT_EQ(numbers, "1 5 6 7 10 ") << "this and all following numbers +1";
}

}  // namespace
}  // namespace cnclab::panel
