// Cassettes between two log-ins, and the step from the version that had none (DEC-33, STO-008).
#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "db/migrate.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

std::vector<std::string> names_of(Database& database, PersonId id) {
  std::vector<std::string> names;
  for (const StoredCassette& cassette : database.cassettes(id))
    names.push_back(cassette.name + (cassette.is_inserted ? "*" : ""));
  return names;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Cassettes, DEC_33_TenOfEachPersonWithNamesOfTheirOwn) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna"), berta = add_student(database, "berta");
  for (int i = 0; i < kMostCassettes; ++i) EXPECT_TRUE(database.add_cassette(anna, "K" + std::to_string(i), "tape", 1));
  EXPECT_FALSE(database.add_cassette(anna, "K10", "tape", 1)) << "the eleventh";
  EXPECT_TRUE(database.add_cassette(berta, "K0", "tape", 1)) << "another person's";
  EXPECT_FALSE(database.add_cassette(berta, "K0", "tape", 1)) << "a name that is taken";
  EXPECT_EQ(database.cassettes(anna).size(), 10U);
  database.remove_cassette(anna, database.cassettes(anna).front().id);
  EXPECT_TRUE(database.add_cassette(anna, "K10", "tape", 1));
}

TEST(Cassettes, DEC_33_TheTapeIsKeptByteForByte) {
  const LabFolder folder;
  const std::string bytes("\0\xff tape", 7);
  CassetteId id{};
  {
    auto database = opened(folder.file());
    id = database.add_cassette(add_student(database, "anna"), "K1", "", 5).value();
    database.put_tape(PersonId{1}, id, bytes, 9);
  }
  auto database = opened(folder.file());
  EXPECT_EQ(database.tape(PersonId{1}, id), bytes);
  ASSERT_EQ(database.cassettes(PersonId{1}).size(), 1U);
  EXPECT_EQ(database.cassettes(PersonId{1})[0].bytes, bytes.size());
  EXPECT_EQ(database.cassettes(PersonId{1})[0].changed_ms, 9);
}

TEST(Cassettes, DEC_33_OneLiesInTheRecorder) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  const CassetteId first = database.add_cassette(anna, "A", "", 1).value();
  const CassetteId second = database.add_cassette(anna, "B", "", 1).value();
  database.insert_cassette(anna, first);
  EXPECT_THAT(names_of(database, anna), ElementsAre("A*", "B"));
  database.insert_cassette(anna, second);
  EXPECT_THAT(names_of(database, anna), ElementsAre("A", "B*"));
  database.insert_cassette(anna, std::nullopt);
  EXPECT_THAT(names_of(database, anna), ElementsAre("A", "B"));
}

TEST(Cassettes, SEC_004_AnotherPersonsCannotBeReached) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna"), berta = add_student(database, "berta");
  const CassetteId id = database.add_cassette(anna, "A", "tape", 1).value();
  EXPECT_FALSE(database.tape(berta, id));
  database.put_tape(berta, id, "hers", 2);
  database.insert_cassette(berta, id);
  EXPECT_FALSE(database.rename_cassette(berta, id, "B"));
  database.remove_cassette(berta, id);
  EXPECT_EQ(database.tape(anna, id), "tape");
  EXPECT_THAT(names_of(database, anna), ElementsAre("A"));
}

TEST(Cassettes, DEC_33_ANameThatIsTakenIsNotGiven) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  const CassetteId id = database.add_cassette(anna, "A", "", 1).value();
  database.add_cassette(anna, "B", "", 1);
  EXPECT_FALSE(database.rename_cassette(anna, id, "B"));
  EXPECT_TRUE(database.rename_cassette(anna, id, "A")) << "its own";
  EXPECT_TRUE(database.rename_cassette(anna, id, "C"));
  EXPECT_THAT(names_of(database, anna), ElementsAre("B", "C"));
}

TEST(Cassettes, STO_004_GoWithTheirPerson) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  database.add_cassette(anna, "A", "", 1);
  database.erase(anna);
  EXPECT_THAT(database.cassettes(anna), IsEmpty());
}

TEST(Cassettes, STO_008_ALabOfTheVersionBeforeKeepsWhatItHas) {
  const LabFolder folder;
  {
    SQLite::Database old(folder.file().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    migrate(old, folder.file(), std::span(migrations()).first(2));
    old.exec("INSERT INTO person (name, role, password_hash, created_ms) VALUES ('anna', 'student', 'hash', 1)");
    old.exec("INSERT INTO control_state VALUES (1, x'7b7d', 1)");
  }
  auto database = opened(folder.file());
  ASSERT_TRUE(database.person("anna"));
  EXPECT_EQ(database.control_state(PersonId{1}), "{}");
  EXPECT_TRUE(database.add_cassette(PersonId{1}, "A", "tape", 1));
  EXPECT_TRUE(std::filesystem::exists(folder.file().string() + ".version-2"));
}

}  // namespace
}  // namespace cnclab::db
