// Copies, restoring and migrating (STO-008).
#include "db/backup.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <gmock/gmock.h>

#include <array>

#include "db/migrate.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

using ::testing::HasSubstr;

TEST(Backup, HoldsWhatIsCommittedAndNothingElse) {
  const LabFolder folder;
  auto database = opened(folder.file());
  database.put_value("certificate", "c");
  database.transaction([&] {
    database.put_value("epoch", "not yet");
    database.backup_to(folder.path() / "copy.db");
  });
  auto copy = opened(folder.path() / "copy.db");
  EXPECT_EQ(copy.value("certificate"), "c");
  EXPECT_EQ(copy.value("epoch"), std::nullopt);
}

TEST(Backup, ThatCannotBeWrittenIsAnErrorAndLeavesTheOldCopy) {
  const LabFolder folder;
  auto database = opened(folder.file());
  const auto copied = copy_database(folder.file(), folder.path() / "no" / "copy.db");
  ASSERT_FALSE(copied);
  EXPECT_THAT(copied.error().text, HasSubstr("cannot be copied"));
  EXPECT_THROW(database.backup_to(folder.path() / "no" / "copy.db"), std::runtime_error);
}

// What a started lab has beside its people.
void make_lab(Database& database) {
  database.put_value("certificate", "c");
  database.put_value("private_key", "k");
}

TEST(Restore, STO_008_AFileThatHoldsNoLabChangesNothing) {
  const LabFolder folder;
  {
    auto database = opened(folder.file());
    make_lab(database);
  }
  {
    const std::ofstream empty(folder.path() / "empty.db");
    opened(folder.path() / "unused.db");
  }
  const std::string before = content(folder.file());
  for (const char* name : {"empty.db", "unused.db"}) {
    const auto refused = restore_database(folder.path() / name, folder.file());
    ASSERT_FALSE(refused) << name;
    EXPECT_THAT(refused.error().text, HasSubstr("is no backup of a lab"));
  }
  EXPECT_FALSE(restore_database("/dev/null", folder.file()));
  EXPECT_EQ(content(folder.file()), before);
}

TEST(Restore, TakesTheCopyKeepsTheOldAsideAndLeavesNoStaleWal) {
  const LabFolder folder;
  {
    auto database = opened(folder.file());
    make_lab(database);
    database.put_value("epoch", "1");
    ASSERT_TRUE(copy_database(folder.file(), folder.path() / "copy.db"));
    database.put_value("epoch", "2");
    EXPECT_EQ(restore_database(folder.path() / "copy.db", folder.file()).error().kind, OpenError::Kind::locked);
  }
  {
    const std::ofstream stale(folder.file().string() + "-wal");
  }
  const auto aside = restore_database(folder.path() / "copy.db", folder.file());
  ASSERT_TRUE(aside) << aside.error().text;
  EXPECT_EQ(*aside, folder.file().string() + ".replaced-1");
  EXPECT_FALSE(std::filesystem::exists(folder.file().string() + "-wal"));
  EXPECT_EQ(opened(folder.file()).value("epoch"), "1");
  EXPECT_EQ(opened(*aside).value("epoch"), "2");
}

TEST(Restore, ADamagedOrMissingCopyChangesNothing) {
  const LabFolder folder;
  {
    opened(folder.file()).put_value("epoch", "1");
  }
  {
    std::ofstream(folder.path() / "bad.db") << "no database, but long enough to be looked at";
  }
  const std::string before = content(folder.file());
  const auto refused = restore_database(folder.path() / "bad.db", folder.file());
  EXPECT_EQ(refused.error().kind, OpenError::Kind::damaged);
  EXPECT_NE(refused.error().text.find("Name another backup"), std::string::npos) << refused.error().text;
  EXPECT_EQ(refused.error().text.find("--data"), std::string::npos) << refused.error().text;
  EXPECT_FALSE(restore_database(folder.path() / "none.db", folder.file()));
  EXPECT_EQ(content(folder.file()), before);
}

TEST(Migrations, AreNumberedFromOneWithoutGaps) {
  int expected = 1;
  for (const Migration& step : migrations()) {
    EXPECT_EQ(step.number, expected++) << step.name;
    EXPECT_THAT(std::string(step.sql), HasSubstr("CREATE"));
  }
  EXPECT_GT(expected, 1);
}

TEST(Migrations, STO_008_TheFirstReleasesDatabaseOpensAndKeepsWhatItHolds) {
  const LabFolder folder;
  {
    SQLite::Database first(folder.file().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    migrate(first, folder.file(), migrations().first(1));
    first.exec("INSERT INTO person (id, name, role, password_hash, created_ms) VALUES (1, 'anna', 'student', 'h', 5)");
    first.exec("INSERT INTO program VALUES (1, 1, 1, 1, 5)");
    first.exec("INSERT INTO block VALUES (1, 1, 1, 'N001G00X+1000', 77)");
    first.exec(
        "INSERT INTO run (person_id, station, machine, started_ms, program, block, setup, seconds, ended) "
        "VALUES (1, 3, 'lab', 5, 1, 1, x'7B7D', 2.5, 'program_end')");
  }
  auto database = opened(folder.file());
  const PersonId anna = database.person("anna")->id;
  EXPECT_EQ(database.programs(anna).at(0).blocks.at(0).check_code, 77U);
  const auto runs = database.runs(anna);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].ended, "program_end");
  EXPECT_EQ(runs[0].digest, "") << "recorded before there were digests: not replayable, but kept";
  EXPECT_TRUE(std::filesystem::exists(folder.file().string() + ".version-1"));
}

constexpr std::array<Migration, 3> kThreeSteps{
    {{1, "0001", "CREATE TABLE a (x INTEGER)"},
     {2, "0002", "ALTER TABLE a ADD COLUMN y INTEGER DEFAULT 5"},
     {3, "0003", "CREATE TABLE b (x INTEGER); INSERT INTO b SELECT y FROM a"}}};

TEST(Migrations, AnOlderDatabaseIsCopiedThenBroughtUpToDate) {
  const LabFolder folder;
  SQLite::Database database(folder.file().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  migrate(database, folder.file(), std::span(kThreeSteps).first(1));
  EXPECT_FALSE(std::filesystem::exists(folder.file().string() + ".version-0"));
  database.exec("INSERT INTO a VALUES (1)");
  migrate(database, folder.file(), kThreeSteps);
  EXPECT_EQ(schema_version(database), 3);
  EXPECT_EQ(database.execAndGet("SELECT x FROM b").getInt(), 5);
  SQLite::Database copy(folder.file().string() + ".version-1");
  EXPECT_EQ(schema_version(copy), 1);
  EXPECT_EQ(copy.execAndGet("SELECT x FROM a").getInt(), 1);
}

TEST(Migrations, AStepThatFailsLeavesTheVersionBefore) {
  const LabFolder folder;
  SQLite::Database database(folder.file().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  const std::array<Migration, 2> steps{
      {kThreeSteps[0], {2, "0002", "CREATE TABLE c (x INTEGER); INSERT INTO none VALUES (1)"}}};
  EXPECT_THROW(migrate(database, folder.file(), steps), SQLite::Exception);
  EXPECT_EQ(schema_version(database), 1);
  EXPECT_FALSE(database.tableExists("c"));
}

}  // namespace
}  // namespace cnclab::db
