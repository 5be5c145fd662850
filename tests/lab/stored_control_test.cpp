// Database rows become a control's memory; damage is seen (STO-003, ERR-014).
#include "lab/stored_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "language/tape.hpp"

namespace cnclab::lab {
namespace {

language::Block block_of(const char* text, std::uint16_t program = 1) {
  return language::read_block(text, program).value();
}

db::StoredProgram program_of(std::vector<db::StoredBlock> blocks) { return {1, 1, 0, std::move(blocks)}; }

TEST(StoredControl, STO_003_AWrongCheckCodeMarksTheBlockAndKeepsTheOthers) {
  auto good = stored_block(1, block_of("N001G00X+50000Y+50000Z+50000"));
  auto bad = stored_block(1, block_of("N002G04H0010"));
  bad.check_code ^= 1U;
  const auto memory = memory_of({program_of({good, bad})}, 16384);
  const auto* program = memory.find(1);
  ASSERT_NE(program, nullptr);
  ASSERT_EQ(program->blocks.size(), 2U);
  EXPECT_FALSE(program->blocks[0].is_damaged);
  EXPECT_TRUE(program->blocks[1].is_damaged);
  EXPECT_EQ(program->blocks[1].number, 2);
}

TEST(StoredControl, STO_003_TheCheckCodeKnowsTheProgram) {
  const auto block = block_of("N001G90");
  EXPECT_NE(stored_block(1, block).check_code, stored_block(2, block).check_code);
}

TEST(StoredControl, STO_003_TextThatIsNoBlockIsDamageToo) {
  const auto memory = memory_of({program_of({{7, "N007?", language::check_code(1, "N007?")}})}, 16384);
  ASSERT_NE(memory.find(1), nullptr);
  EXPECT_TRUE(memory.find(1)->blocks[0].is_damaged);
  EXPECT_EQ(memory.find(1)->blocks[0].number, 7);
}

TEST(StoredControl, ERR_014_ADatumWithAWrongCheckCodePutsTheWholeRomSetInPlace) {
  auto wrong = stored_datum(6, 2000);
  EXPECT_EQ(machine_data_of({stored_datum(7, 1234), wrong}).get(7), 1234);
  wrong.value = 2500;
  EXPECT_TRUE(is_damaged({stored_datum(7, 1234), wrong}));
  EXPECT_EQ(machine_data_of({stored_datum(7, 1234), wrong}), machine::MachineData{});
}

std::vector<db::StoredDatum> whole_set() {
  std::vector<db::StoredDatum> data;
  for (const auto& form : machine::datum_forms())
    data.push_back(stored_datum(form.number, machine::MachineData{}.get(form.number)));
  return data;
}

TEST(StoredControl, AUTH_011_STO_003_DamageInTheLabMachinesDataLiftsNoLimitThatIsWhole) {
  EXPECT_TRUE(lab_machine_data_of({}).damaged.empty()) << "never changed";
  EXPECT_TRUE(lab_machine_data_of(whole_set()).damaged.empty());
  auto data = whole_set();
  std::ranges::find(data, 6, &db::StoredDatum::number)->value = 1000;
  std::ranges::find(data, 6, &db::StoredDatum::number)->check_code = stored_datum(6, 1000).check_code;
  std::ranges::find(data, 22, &db::StoredDatum::number)->check_code ^= 1U;
  const auto found = lab_machine_data_of(data);
  EXPECT_EQ(found.damaged, std::vector{22});
  EXPECT_EQ(found.data.get(6), 1000) << "F MAX as the instructor set it";
}

TEST(StoredControl, AUTH_011_STO_003_ANumberThatIsGoneFromTheLabMachinesDataIsDamageToo) {
  auto data = whole_set();
  std::ranges::find(data, 3, &db::StoredDatum::number)->number = 23;
  EXPECT_EQ(lab_machine_data_of(data).damaged, std::vector{3});
}

/// Eva, of whom nothing is stored.
class StoredStudent : public testing::Test {
 protected:
  StoredStudent() {
    db::Person person;
    person.name = "eva";
    person.role = "student";
    eva_ = database_.add_person(person, 1).value();
  }

  inline static const db::Author kEva{"eva", 3, 1};
  db::Database database_ = db::Database::open(":memory:").value();
  db::PersonId eva_{};
};

TEST_F(StoredStudent, STO_005_OnlyChangedMachineDataAreWritten) {
  database_.put_machine_datum(eva_, {6, 2500, 1}, kEva);
  carry_out(database_, eva_, panel::PutMachineData{}, kEva);
  EXPECT_FALSE(is_damaged(database_.machine_data(eva_))) << "a wrong check code is renewed";
  machine::MachineData data;
  ASSERT_TRUE(data.set(22, 0));
  carry_out(database_, eva_, panel::PutMachineData{data}, kEva);
  EXPECT_EQ(machine_data_of(database_.machine_data(eva_)), data);
}

TEST_F(StoredStudent, StoresWhatAControlAsksFor) {
  for (const char* text : {"N001G90", "N002G00X+1000"})
    carry_out(database_, eva_, panel::PutBlock{1, block_of(text)}, kEva);
  carry_out(database_, eva_, panel::InsertBlock{1, block_of("N002G91")}, kEva);
  carry_out(database_, eva_, panel::DeleteBlock{1, 1}, kEva);
  const auto memory = memory_of(read_control(database_, eva_).programs, 16384);
  const auto* program = memory.find(1);
  ASSERT_NE(program, nullptr);
  ASSERT_EQ(program->blocks.size(), 2U);
  EXPECT_EQ(language::write_block(program->blocks[0]), "N002G91");
  EXPECT_EQ(language::write_block(program->blocks[1]), "N003G00X+1000");
  EXPECT_FALSE(program->blocks[1].is_damaged) << "EDIT-020: the raised number has its own check code";
}

TEST_F(StoredStudent, EXT_023_024_STO_005_WhatWasReadTakesTheOldOnesPlaceAndTheVersionsStay) {
  carry_out(database_, eva_, panel::PutBlock{1, block_of("N001G90")}, kEva);
  carry_out(database_, eva_, panel::PutBlock{2, block_of("N001G90")}, kEva);
  machine::MachineData data;
  ASSERT_TRUE(data.set(6, 2000));
  const language::Program read{.number = 1, .blocks = {block_of("N001G91"), block_of("N005G00X+1000")}};
  carry_out(database_, eva_, panel::PutPrograms{.programs = {read}, .removed = {1, 2}, .data = data}, kEva);
  const auto stored = read_control(database_, eva_);
  const auto memory = memory_of(stored.programs, 16384);
  ASSERT_EQ(memory.programs().size(), 1U);
  EXPECT_EQ(memory.programs()[0], read);
  EXPECT_EQ(machine_data_of(stored.machine_data), data);
  EXPECT_FALSE(database_.versions(eva_, 2).empty());
}

TEST_F(StoredStudent, MOD_077_STO_005_ErasingTheWholeMemoryResetsTheMachineDataAndKeepsTheVersions) {
  carry_out(database_, eva_, panel::PutBlock{1, block_of("N001G90")}, kEva);
  carry_out(database_, eva_, panel::PutBlock{0, block_of("T001R+5000", 0)}, kEva);
  machine::MachineData data;
  ASSERT_TRUE(data.set(6, 2000));
  carry_out(database_, eva_, panel::PutMachineData{data}, kEva);
  carry_out(database_, eva_, panel::EraseMemory{{0, 1}, {}}, kEva);
  const auto stored = read_control(database_, eva_);
  EXPECT_TRUE(memory_of(stored.programs, 16384).programs().empty());
  EXPECT_EQ(machine_data_of(stored.machine_data), machine::MachineData{});
  const auto versions = database_.versions(eva_, 1);
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(version_texts(database_, eva_, 1, versions.front().version), (db::BlockTexts{{1, "N001G90"}}));
}

}  // namespace
}  // namespace cnclab::lab
