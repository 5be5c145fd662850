// Blocks and programs: order, insertion, removal, versions (EDIT-020, SCR-054, STO-001, STO-005).
#include <gmock/gmock.h>

#include "db/failure.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Optional;

struct Programs : ::testing::Test {
  Database database = opened(":memory:");
  PersonId anna = add_student(database, "anna");
  PersonId berta = add_student(database, "berta");

  std::vector<int> order(PersonId id) {
    std::vector<int> numbers;
    for (const StoredProgram& program : database.programs(id)) numbers.push_back(program.number);
    return numbers;
  }
};

TEST_F(Programs, PutBlockMakesTheProgramAndKeepsGapsAscending) {  // EDIT-032
  database.put_block(anna, 1, block(20, "G01X+2"), kAuthor);
  database.put_block(anna, 1, block(3, "G00X+1"), {"lehrer", 0, 6000});
  const auto programs = database.programs(anna);
  ASSERT_EQ(programs.size(), 1U);
  EXPECT_EQ(programs[0].number, 1);
  EXPECT_EQ(programs[0].version, 2);
  EXPECT_EQ(programs[0].changed_ms, 6000);
  EXPECT_THAT(programs[0].blocks, ElementsAre(block(3, "G00X+1"), block(20, "G01X+2")));
}

TEST_F(Programs, ProgramsStandInStorageOrderNotByNumber) {  // SCR-054
  for (const int program : {7, 2, 9}) database.put_block(anna, program, block(1, "M30"), kAuthor);
  database.put_block(anna, 2, block(2, "M30"), kAuthor);
  database.replace_program(anna, 7, {block(5, "M05")}, kAuthor);
  EXPECT_THAT(order(anna), ElementsAre(7, 2, 9));
  database.remove_program(anna, 7, kAuthor);
  database.put_block(anna, 7, block(1, "M30"), kAuthor);
  EXPECT_THAT(order(anna), ElementsAre(2, 9, 7));
}

TEST_F(Programs, InsertRaisesTheNumbersThatFollowAndKeepsGaps) {  // EDIT-020
  database.replace_program(anna, 1, {block(1, "A"), block(2, "B"), block(3, "C"), block(7, "D")}, kAuthor);
  database.insert_block(anna, 1, block(2, "NEU"), kAuthor, renumbered);
  EXPECT_THAT(database.programs(anna).at(0).blocks,
              ElementsAre(block(1, "A"), block(2, "NEU"), block(3, "B"), block(4, "C"), block(8, "D")));
  EXPECT_THAT(texts_at(database, anna, 1, 1), Optional(ElementsAre("N001A", "N002B", "N003C", "N007D")));
}

TEST_F(Programs, InsertThatWouldPassN999ChangesNothing) {  // D-47
  database.replace_program(anna, 1, {block(1, "A"), block(999, "B")}, kAuthor);
  EXPECT_THROW(
      database.insert_block(anna, 1, block(1, "NEU"), kAuthor,
                            [](const StoredBlock& old, int) { return StoredBlock{0, old.text, old.check_code}; }),
      StoreFailure);
  EXPECT_THAT(database.programs(anna).at(0).blocks, ElementsAre(block(1, "A"), block(999, "B")));
  EXPECT_EQ(database.versions(anna, 1).size(), 1U);
}

TEST_F(Programs, DeletingTheLastBlockLeavesAnEmptyProgram) {
  database.put_block(anna, 1, block(1, "A"), kAuthor);
  database.delete_block(anna, 1, 1, kAuthor);
  ASSERT_EQ(database.programs(anna).size(), 1U);
  EXPECT_THAT(database.programs(anna)[0].blocks, IsEmpty());
  EXPECT_THAT(texts_at(database, anna, 1, 1), Optional(ElementsAre("N001A")));
}

TEST_F(Programs, WhatIsNotThereIsDeletedWithoutAVersion) {
  database.put_block(anna, 1, block(1, "A"), kAuthor);
  database.delete_block(anna, 1, 2, kAuthor);
  database.delete_block(anna, 5, 1, kAuthor);
  database.remove_program(anna, 5, kAuthor);
  EXPECT_EQ(database.versions(anna, 1).size(), 1U);
  EXPECT_THAT(database.versions(anna, 5), IsEmpty());
}

TEST_F(Programs, VersionsGoOnAfterRemovalAndEachCanBeRead) {  // STO-005
  database.put_block(anna, 1, block(1, "A"), kAuthor);
  database.put_block(anna, 1, block(1, "B"), {"lehrer", 0, 7000});
  database.remove_program(anna, 1, kAuthor);
  database.put_block(anna, 1, block(2, "C"), kAuthor);
  const auto versions = database.versions(anna, 1);
  ASSERT_EQ(versions.size(), 4U);
  EXPECT_EQ(versions[1].kind, "put");
  EXPECT_EQ(versions[1].block, 1);
  EXPECT_EQ(versions[1].author.name, "lehrer");
  EXPECT_EQ(versions[1].author.time_ms, 7000);
  EXPECT_EQ(versions[2].kind, "remove");
  EXPECT_EQ(versions[2].author.station, 1);
  EXPECT_EQ(versions[3].version, 4);
  EXPECT_THAT(texts_at(database, anna, 1, 1), Optional(ElementsAre("N001A")));
  EXPECT_THAT(texts_at(database, anna, 1, 2), Optional(ElementsAre("N001B")));
  EXPECT_THAT(texts_at(database, anna, 1, 3), Optional(IsEmpty()));
  EXPECT_THAT(texts_at(database, anna, 1, 4), Optional(ElementsAre("N002C")));
  EXPECT_THAT(texts_at(database, anna, 1, 0), Optional(ElementsAre("N002C")));
  EXPECT_EQ(texts_at(database, anna, 1, 5), std::nullopt);
  EXPECT_EQ(texts_at(database, anna, 1, -1), std::nullopt);
  EXPECT_EQ(texts_at(database, anna, 2, 0), std::nullopt);
}

TEST_F(Programs, ASecondPersonSeesAndChangesNothingOfTheFirst) {  // STO-001
  database.put_block(anna, 1, block(1, "A"), kAuthor);
  EXPECT_THAT(database.programs(berta), IsEmpty());
  EXPECT_THAT(database.versions(berta, 1), IsEmpty());
  EXPECT_EQ(texts_at(database, berta, 1, 0), std::nullopt);
  database.delete_block(berta, 1, 1, kAuthor);
  database.remove_program(berta, 1, kAuthor);
  database.put_block(berta, 1, block(1, "B"), kAuthor);
  EXPECT_THAT(database.programs(anna).at(0).blocks, ElementsAre(block(1, "A")));
  EXPECT_EQ(database.programs(anna).at(0).version, 1);
}

struct RefusedBlock {
  const char* name;
  int program;
  StoredBlock stored;
};

TEST_F(Programs, RefusesWhatTheSchemaForbids) {
  const RefusedBlock rows[] = {
      {"block 0", 1, {0, "N000", 1}},
      {"block 1000", 1, {1000, "N1000", 1}},
      {"program 10000", 10000, {1, "N001", 1}},
      {"program -1", -1, {1, "N001", 1}},
      {"empty text", 1, {1, "", 1}},
      {"two lines", 1, {1, "N001\nN002", 1}},
  };
  for (const RefusedBlock& row : rows) {
    SCOPED_TRACE(row.name);
    EXPECT_THROW(database.put_block(anna, row.program, row.stored, kAuthor), StoreFailure);
    EXPECT_THROW(database.replace_program(anna, row.program, {row.stored}, kAuthor), StoreFailure);
    EXPECT_THAT(database.programs(anna), IsEmpty());
    EXPECT_THAT(database.versions(anna, row.program), IsEmpty());
  }
  EXPECT_THROW(database.replace_program(anna, 1, {block(1, "A"), block(1, "B")}, kAuthor), StoreFailure);
  EXPECT_THROW(database.put_block(PersonId{99}, 1, block(1, "A"), kAuthor), StoreFailure);
}

TEST_F(Programs, LargestProgramIsInsertedIntoAtItsHead) {
  std::vector<StoredBlock> blocks;
  for (int number = 1; number <= 998; ++number) blocks.push_back(block(number, "G01X+" + std::to_string(number)));
  database.replace_program(anna, 1, blocks, kAuthor);
  database.insert_block(anna, 1, block(1, "G90"), kAuthor, renumbered);
  const auto stored = database.programs(anna).at(0).blocks;
  ASSERT_EQ(stored.size(), 999U);
  EXPECT_EQ(stored[0], block(1, "G90"));
  EXPECT_EQ(stored[998], block(999, "G01X+998"));
  EXPECT_EQ(texts_at(database, anna, 1, 1)->size(), 998U);
}

}  // namespace
}  // namespace cnclab::db
