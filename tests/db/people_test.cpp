// The roster: names, passwords, archive, erasing (INS-004, SEC-002).
#include <gmock/gmock.h>

#include "db/failure.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> names(Database& database, bool with_archived) {
  std::vector<std::string> found;
  for (const Person& person : database.people(with_archived)) found.push_back(person.name);
  return found;
}

TEST(People, AddedPersonComesBackWithEveryField) {
  auto database = opened(":memory:");
  const Person lehrer{.id = {},
                      .name = "lehrer",
                      .role = "instructor",
                      .language = "en",
                      .model = "3250",
                      .password_hash = "$argon2id$x",
                      .must_change = true,
                      .last_seen_ms = 0,
                      .archived_ms = std::nullopt};
  const auto id = database.add_person(lehrer, 77);
  ASSERT_TRUE(id);
  const auto found = database.person("lehrer");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, *id);
  EXPECT_EQ(found->role, "instructor");
  EXPECT_EQ(found->language, "en");
  EXPECT_EQ(found->model, "3250");
  EXPECT_EQ(found->password_hash, "$argon2id$x");
  EXPECT_TRUE(found->must_change);
  EXPECT_FALSE(found->archived_ms);
  EXPECT_FALSE(database.person("Lehrer"));
}

TEST(People, ANameIsGivenOnceEvenWhenArchived) {
  auto database = opened(":memory:");
  const PersonId id = add_student(database, "schueler01");
  database.archive(id, 9000);
  EXPECT_FALSE(database.add_person(*database.person("schueler01"), 1));
  EXPECT_THAT(names(database, false), IsEmpty());
  EXPECT_THAT(names(database, true), ElementsAre("schueler01"));
  EXPECT_EQ(database.person("schueler01")->archived_ms, 9000);
  database.archive(id, 9999);  // the 30 days count from the first time
  EXPECT_EQ(database.person("schueler01")->archived_ms, 9000);
  database.unarchive(id);
  EXPECT_THAT(names(database, false), ElementsAre("schueler01"));
}

TEST(People, PasswordAndLastSeenChange) {
  auto database = opened(":memory:");
  const PersonId id = add_student(database, "schueler01");
  database.set_password(id, "other", true);
  database.set_last_seen(id, 123456789012);
  const auto found = database.person("schueler01");
  EXPECT_EQ(found->password_hash, "other");
  EXPECT_TRUE(found->must_change);
  EXPECT_EQ(found->last_seen_ms, 123456789012);
}

TEST(People, RenameRefusesATakenName) {
  auto database = opened(":memory:");
  const PersonId one = add_student(database, "anna");
  add_student(database, "berta");
  EXPECT_FALSE(database.rename(one, "berta"));
  EXPECT_TRUE(database.rename(one, "clara"));
  EXPECT_TRUE(database.rename(one, "clara"));
  EXPECT_THAT(names(database, false), ElementsAre("berta", "clara"));
}

TEST(People, EraseTakesEverythingOfThePersonAndNothingOfOthers) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  const PersonId berta = add_student(database, "berta");
  for (const PersonId id : {anna, berta}) {
    database.put_block(id, 1, block(1, "G00X+1"), kAuthor);
    database.put_machine_datum(id, {12, 3000, 1}, kAuthor);
    database.put_control_state(id, "{}", 1);
    const auto run = database.begin_run({.person = id, .station = 1, .machine = "training", .setup = "{}"});
    database.add_trace(run, 0, "xx");
  }
  database.add_journal({{1, 1, "anna", "login", "", 0}, {2, 2, "berta", "login", "", 0}});
  database.erase(anna);

  EXPECT_FALSE(database.person("anna"));
  EXPECT_THAT(database.programs(anna), IsEmpty());
  EXPECT_THAT(database.versions(anna, 1), IsEmpty());
  EXPECT_THAT(database.machine_data(anna), IsEmpty());
  EXPECT_EQ(database.control_state(anna), "");
  EXPECT_THAT(database.runs(anna), IsEmpty());
  EXPECT_THAT(database.journal("anna", 0), IsEmpty());

  EXPECT_EQ(database.programs(berta).size(), 1U);
  EXPECT_EQ(database.machine_data(berta).size(), 1U);
  EXPECT_EQ(database.control_state(berta), "{}");
  EXPECT_EQ(database.trace(database.runs(berta).at(0).id), "xx");
  EXPECT_EQ(database.journal("", 0).size(), 1U);
}

TEST(People, AnErasedPersonsNumberIsNeverGivenAgain) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  database.erase(anna);
  EXPECT_NE(add_student(database, "anna"), anna);
  EXPECT_THROW(database.put_block(anna, 1, block(1, "G00"), kAuthor), StoreFailure);  // came late
  EXPECT_THROW(database.put_control_state(anna, "{}", 1), StoreFailure);
}

TEST(People, AnUnknownRoleIsRefused) {
  auto database = opened(":memory:");
  Person person{.name = "x", .role = "owner", .password_hash = "h"};
  try {
    database.add_person(person, 1);
    FAIL() << "stored";
  } catch (const StoreFailure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::refused);
  }
}

}  // namespace
}  // namespace cnclab::db
