// The machine data behind the programs of a whole-memory recording: read, written, refused where malformed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "language/tape.hpp"
#include "tape_text.hpp"

namespace cnclab::language {
namespace {

using std::string_literals::operator""s;

/// "03=500000 04=400000".
std::string data_of(const Tape& tape) {
  std::string text;
  for (const MachineDatum& datum : tape.machine_data) {
    if (!text.empty()) text += ' ';
    text += (datum.number < 10 ? "0" : "") + std::to_string(datum.number) + '=' + std::to_string(datum.value);
  }
  return text;
}

struct SectionRow {
  std::string id, text, data;
  std::string programs = "P0001\nN001G17\n";
};

TEST(MachineDataSection, StandsBehindTheLastProgram_DEC_34_DEC_62) {
  const SectionRow rows[] = {
      {"one per line", "P0001\nN001G17\nMD\nN03=500000\nN04=400000\n%\n", "03=500000 04=400000"},
      {"in one line", "P0001N001G17MDN03=500000N04=400000%", "03=500000 04=400000"},
      {"without %", "P0001N001G17MDN03=5", "03=5"},
      {"blanks and breaks", "P0001N001G17 M\nD N0\n3 = 50 00 N22=1 %", "03=5000 22=1"},
      {"comments", "P0001N001G17 (a) MD (Maschinendaten) N03=5 (X ACHSE) %", "03=5"},
      {"largest value", "P0001N001G17MDN03=9999999N11=0%", "03=9999999 11=0"},
      {"behind a word M", "P0001N001G01M03MDN06=3000%", "06=3000", "P0001\nN001G01M03\n"},
      {"behind an operand", "P0001N001\\10#01#02MDN06=3000%", "06=3000", "P0001\nN001\\10#01#02\n"},
      {"behind a value", "P0001N001\\00#01+5MDN06=3000%", "06=3000", "P0001\nN001\\00#01+5\n"},
      {"behind a jump's target", "P0001N001\\53N001MDN06=3000%", "06=3000", "P0001\nN001\\53N001\n"},
      {"behind G20", "P0001N001G20P0001N001MDN06=3000%", "06=3000", "P0001\nN001G20P0001N001\n"},
      {"behind P0000", "P0000T001R+5000MDN06=3000%", "06=3000", "P0000\nT001R+5000\n"},
      {"behind a separator", "P0001N001G17"s + "\0\0\0\0\0\0"s + "MDN06=3000%", "06=3000"},
      {"an empty memory's", "MDN06=3000%", "06=3000", ""},
      {"another recording in the file", "P0001N001G17MDN06=3000%P0002N001G18MDN06=2000%", "06=2000",
       "P0001\nN001G17\nP0002\nN001G18\n"},
      {"none", "P0001N001G17%", ""},
  };
  for (const SectionRow& row : rows) {
    const Tape tape = read_tape(row.text, Reading::file);
    EXPECT_EQ(data_of(tape), row.data) << row.id;
    EXPECT_EQ(programs_of(tape), row.programs) << row.id;
    EXPECT_EQ(messages_of(tape), "") << row.id;
  }
}

TEST(MachineDataSection, MalformedDataAreErrorsAndNoneAreTaken_DEC_62) {
  const SectionRow rows[] = {
      {"nothing", "P0001N001G17\nMD\n%",
       "3 Maschinendatum MD ist nicht lesbar, richtig: N03=500000. Zahl berichtigen.\n"},
      {"the clock", "P0001N001G17\nMDN01=120000N03=5%",
       "2 Maschinendatum N01 ist nicht lesbar, richtig: N03..N22. Zahl berichtigen.\n"},
      {"no value", "P0001N001G17\nMDN03=N04=5%",
       "2 Maschinendatum N03 ist nicht lesbar, richtig: 0..9999999. Zahl berichtigen.\n"},
      {"no =", "P0001N001G17\nMDN035N04=5%",
       "2 Maschinendatum N ist nicht lesbar, richtig: N03=500000. Zahl berichtigen.\n"},
      {"one digit", "P0001N001G17\nMDN3=5%",
       "2 Maschinendatum N ist nicht lesbar, richtig: N03=500000. Zahl berichtigen.\n"},
      {"negative", "P0001N001G17\nMDN03=-5%",
       "2 Maschinendatum N03 ist nicht lesbar, richtig: 0..9999999. Zahl berichtigen.\n"},
      {"too large", "P0001N001G17\nMDN03=10000000%",
       "2 Maschinendatum N03 ist nicht lesbar, richtig: 0..9999999. Zahl berichtigen.\n"},
      {"longer than any number", "P0001N001G17\nMDN03=" + std::string(1000, '9') + "%",
       "2 Maschinendatum N03 ist nicht lesbar, richtig: 0..9999999. Zahl berichtigen.\n"},
      {"twice", "P0001N001G17\nMDN03=5N03=6%", "2 Maschinendatum N03 2× ist nicht lesbar. Zahl berichtigen.\n"},
      {"foreign", "P0001N001G17\nMDN03=5X%",
       "2 Maschinendatum X ist nicht lesbar, richtig: N03=500000. Zahl berichtigen.\n"},
      {"all of them", "P0001N001G17\nMDN02=1\nN03=5\nN04\n%",
       "2 Maschinendatum N02 ist nicht lesbar, richtig: N03..N22. Zahl berichtigen.\n"
       "5 Maschinendatum N ist nicht lesbar, richtig: N03=500000. Zahl berichtigen.\n"},
  };
  for (const SectionRow& row : rows) {
    const Tape tape = read_tape(row.text, Reading::file);
    EXPECT_EQ(messages_of(tape), row.data) << row.id;
    EXPECT_TRUE(tape.machine_data.empty()) << row.id;
    EXPECT_EQ(programs_of(tape), row.programs) << row.id;
  }
}

TEST(MachineDataSection, FaultsBeforeItDoNotHideIt) {
  const Tape tape = read_tape("P0001N001G99X+1MDN03=5%P0002N001G20P0001MDN04=6%", Reading::file);
  EXPECT_EQ(data_of(tape), "04=6");
  ASSERT_EQ(tape.errors.size(), 2U) << messages_of(tape);
  EXPECT_EQ(tape.errors[0].code, ErrorCode::function_unknown);
  EXPECT_EQ(tape.errors[1].code, ErrorCode::word_missing);
}

TEST(MachineDataSection, KeepsTheLineOfEachDatum) {
  const Tape tape = read_tape("P0001N001G17\nMD\nN03=5\n\nN04=6\n%", Reading::file);
  ASSERT_EQ(tape.machine_data.size(), 2U);
  EXPECT_EQ(tape.machine_data[0].line, 3);
  EXPECT_EQ(tape.machine_data[1].line, 5);
}

TEST(MachineDataSection, IsWrittenAsItIsRead_DEC_62) {
  const MachineDatum data[] = {{.number = 3, .value = 500'000}, {.number = 19, .value = 51'503}, {.number = 11}};
  EXPECT_EQ(write_machine_data(data), "MD\nN03=500000\nN19=51503\nN11=0\n");
  EXPECT_EQ(write_machine_data({}), "");
}

TEST(MachineDataSection, IsNoPartOfAStoredBlock) {
  EXPECT_FALSE(read_block("N001G17MD", 1).has_value());
  EXPECT_FALSE(read_block("T001R+1MD", kToolTable).has_value());
}

}  // namespace
}  // namespace cnclab::language
