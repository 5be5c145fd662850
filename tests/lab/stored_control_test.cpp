// Database rows become a control's memory; damage is seen (STO-003, ERR-014).
#include "lab/stored_control.hpp"

#include <gtest/gtest.h>

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

TEST(StoredControl, STO_005_OnlyChangedMachineDataAreWritten) {
  auto database = db::Database::open(":memory:").value();
  db::Person person;
  person.name = "eva";
  person.role = "student";
  const auto id = database.add_person(person, 1).value();
  const db::Author author{"eva", 3, 1};
  database.put_machine_datum(id, {6, 2500, 1}, author);
  carry_out(database, id, panel::PutMachineData{}, author);
  EXPECT_FALSE(is_damaged(database.machine_data(id))) << "a wrong check code is renewed";
  machine::MachineData data;
  ASSERT_TRUE(data.set(22, 0));
  carry_out(database, id, panel::PutMachineData{data}, author);
  EXPECT_EQ(machine_data_of(database.machine_data(id)), data);
}

TEST(StoredControl, StoresWhatAControlAsksFor) {
  auto database = db::Database::open(":memory:").value();
  db::Person person;
  person.name = "eva";
  person.role = "student";
  const auto id = database.add_person(person, 1).value();
  const db::Author author{"eva", 3, 1};
  for (const char* text : {"N001G90", "N002G00X+1000"})
    carry_out(database, id, panel::PutBlock{1, block_of(text)}, author);
  carry_out(database, id, panel::InsertBlock{1, block_of("N002G91")}, author);
  carry_out(database, id, panel::DeleteBlock{1, 1}, author);
  const auto memory = memory_of(read_control(database, id).programs, 16384);
  const auto* program = memory.find(1);
  ASSERT_NE(program, nullptr);
  ASSERT_EQ(program->blocks.size(), 2U);
  EXPECT_EQ(language::write_block(program->blocks[0]), "N002G91");
  EXPECT_EQ(language::write_block(program->blocks[1]), "N003G00X+1000");
  EXPECT_FALSE(program->blocks[1].is_damaged) << "EDIT-020: the raised number has its own check code";
}

TEST(StoredControl, MOD_077_STO_005_ErasingTheWholeMemoryResetsTheMachineDataAndKeepsTheVersions) {
  auto database = db::Database::open(":memory:").value();
  db::Person person;
  person.name = "eva";
  person.role = "student";
  const auto id = database.add_person(person, 1).value();
  const db::Author author{"eva", 3, 1};
  carry_out(database, id, panel::PutBlock{1, block_of("N001G90")}, author);
  carry_out(database, id, panel::PutBlock{0, block_of("T001R+5000", 0)}, author);
  machine::MachineData data;
  ASSERT_TRUE(data.set(6, 2000));
  carry_out(database, id, panel::PutMachineData{data}, author);
  carry_out(database, id, panel::EraseMemory{{0, 1}, {}}, author);
  const auto stored = read_control(database, id);
  EXPECT_TRUE(memory_of(stored.programs, 16384).programs().empty());
  EXPECT_EQ(machine_data_of(stored.machine_data), machine::MachineData{});
  const auto versions = database.versions(id, 1);
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(database.program_at(id, 1, versions.front().version).value(), std::vector<std::string>{"N001G90"});
}

}  // namespace
}  // namespace cnclab::lab
