// What the lab forgets by itself, and what a screen says that could not store (INS-004, STO-005, STO-006, STO-009).
#include <gtest/gtest.h>

#include "keyboard_rig.hpp"
#include "lab/stored_control.hpp"

namespace cnclab::lab {
namespace {

constexpr std::int64_t kDay_ms = 86'400'000;
constexpr std::int64_t kHour_ms = 3'600'000;

class House : public testing::Test, protected SmallLab {
 protected:
  /// Days pass; the house is kept once an hour.
  void pass_days(double days) {
    unix_ms_ += static_cast<std::int64_t>(days * kDay_ms);
    advance_ms(kHour_ms + 1);
    poll();
  }
  bool is_known(const std::string& name) {
    bool found = false;
    with_database([&](db::Database& database) { found = database.person(name).has_value(); });
    return found;
  }
};

TEST_F(House, INS_004_an_archived_student_comes_back_for_30_days_and_is_erased_then) {
  poll();
  with_database([&](db::Database& database) { database.archive(database.person("udo")->id, unix_ms_); });
  pass_days(29.9);
  EXPECT_TRUE(is_known("udo"));
  pass_days(0.2);
  EXPECT_FALSE(is_known("udo"));
  EXPECT_TRUE(is_known("eva")) << "who is on the roster stays";
}

TEST_F(House, STO_005_a_removed_program_can_be_restored_after_30_days_too) {
  const db::Author author{"eva", 1, unix_ms_};
  with_database([&](db::Database& database) {
    const auto id = database.person("eva")->id;
    database.put_block(id, 1, {1, "N001G00X+1000", 0}, author);
    database.remove_program(id, 1, author);
  });
  poll();
  pass_days(31);
  std::optional<db::BlockTexts> blocks;
  with_database([&](db::Database& database) { blocks = version_texts(database, database.person("eva")->id, 1, 1); });
  EXPECT_EQ(blocks, (db::BlockTexts{{1, "N001G00X+1000"}}));
}

TEST_F(House, STO_006_the_journal_is_kept_for_90_days) {
  poll();
  with_database([&](db::Database& database) { database.add_journal({{unix_ms_, 1, "eva", "key", "MENU", 0}}); });
  const auto has_key = [&] {
    bool has = false;
    with_database([&](db::Database& database) {
      for (const auto& entry : database.journal("eva", 0)) has = has || entry.kind == "key";
    });
    return has;
  };
  pass_days(89.9);
  EXPECT_TRUE(has_key());
  pass_days(0.2);
  EXPECT_FALSE(has_key());
}

class EnglishHouse : public testing::Test, protected SmallLab {
 protected:
  EnglishHouse() : SmallLab(english()) {}
  static Configuration english() {
    Configuration configuration;
    configuration.tongue = language::Tongue::english;
    return configuration;
  }
};

TEST_F(EnglishHouse, STO_009_what_could_not_be_stored_is_told_in_the_students_language) {
  Caller eva = call();
  log_in(eva, "eva", 1);
  with_database([](db::Database& database) { database.erase(database.person("eva")->id); });
  for (const Key key : {Key::EINGABE, Key::ENTER, Key::ENTER, Key::ENTER, Key::D1, Key::EINGABE}) strike(eva, key);
  settle_until([&] { return !eva.visit->desk->storing; });
  EXPECT_EQ(eva.visit->desk->view.screen.text(18).substr(0, 29), "Not stored: Value not allowed");
}

class LostRuns : public testing::Test, protected KeyboardRig {};

TEST_F(LostRuns, STO_009_the_instructor_sees_once_that_the_record_of_a_run_is_lost) {
  EXPECT_EQ(status().runs_lost(), 0);
  with_database([](db::Database& database) { database.erase(database.person("eva")->id); });  // nobody to keep it for
  for (const Key key : {Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) {
    strike(eva, key);
    pass_ms(50);
  }
  strike(eva, Key::STOP);
  pass_ms(200);
  strike(eva, Key::MENU);
  pass_ms(1000);  // the journal is written five times a second
  settle_until([&] { return status().runs_lost() > 0; });
  std::vector<std::string> entries;
  settle_until([&] {
    pass_ms(300);
    entries.clear();
    with_database([&](db::Database& database) {
      for (const auto& entry : database.journal("eva", 0))
        if (entry.kind == "run_lost") entries.push_back(entry.detail);
    });
    return !entries.empty();
  });
  EXPECT_EQ(entries, (std::vector<std::string>{"P0001 N001 training: refused by the database"}));
  EXPECT_EQ(status().runs_lost(), 1) << "begin, events and end are one run";
  EXPECT_NE(lab().metrics().find("cnclab_runs_lost_total 1\n"), std::string::npos);
}

}  // namespace
}  // namespace cnclab::lab
