// Machine data, control states, journal, runs, single values (STO-001, STO-005 to STO-007, SEAT-004).
#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <gmock/gmock.h>

#include "db/failure.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

using ::testing::IsEmpty;

TEST(MachineData, EachPersonAndTheLabMachineHaveTheirOwn) {  // STO-001, DEC-25
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  database.put_machine_datum(anna, {12, 3000, 7}, kAuthor);
  database.put_machine_datum(kLabMachine, {12, 2000, 8}, kAuthor);
  database.put_machine_datum(anna, {3, -500000, 4294967295U}, kAuthor);
  const auto data = database.machine_data(anna);
  ASSERT_EQ(data.size(), 2U);
  EXPECT_EQ(data[0].number, 3);
  EXPECT_EQ(data[0].value, -500000);
  EXPECT_EQ(data[0].check_code, 4294967295U);
  EXPECT_EQ(data[1].value, 3000);
  ASSERT_EQ(database.machine_data(kLabMachine).size(), 1U);
  EXPECT_EQ(database.machine_data(kLabMachine)[0].value, 2000);
}

TEST(MachineData, EachChangeKeepsWhatWasBefore) {  // STO-005
  const LabFolder folder;
  {
    auto database = opened(folder.file());
    database.put_machine_datum(kLabMachine, {12, 3000, 7}, kAuthor);
    database.put_machine_datum(kLabMachine, {12, 1000, 9}, {"lehrer", 0, 6000});
  }
  SQLite::Database raw(folder.file().string());
  EXPECT_EQ(raw.execAndGet("SELECT group_concat(coalesce(before, 'none') || '>' || after || ' ' || by_whom) FROM "
                           "machine_datum_change")
                .getString(),
            "none>3000 schueler01,3000>1000 lehrer");
}

TEST(Runs, STO_007_ARunThatItsServerDidNotEndIsClosedWithItsReasonAtTheNextOpening) {
  const LabFolder folder;
  std::int64_t run = 0;
  {
    auto database = opened(folder.file());
    RunRecord record;
    record.person = add_student(database, "anna");
    record.machine = "lab";
    record.setup = "{}";
    run = database.begin_run(record);
    database.add_trace(run, 1, std::string(54'000, 'x'));
    EXPECT_EQ(database.run(run)->ended, "") << "while it lasts";
  }
  const auto closed = opened(folder.file()).run(run);
  EXPECT_EQ(closed->ended, "server_lost");
  EXPECT_EQ(closed->seconds, 1.5);
  EXPECT_EQ(closed->digest, "") << "not to be replayed";
}

TEST(MachineData, WhatWasStoredTogetherIsOneVersionAndComesBack) {  // STO-005
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  const Author first{"anna", 7, 1000}, second{"anna", 7, 2000}, third{"lehrer", 0, 2000};
  database.put_machine_datum(anna, {12, 3000, 1}, first);
  database.put_machine_datum(anna, {16, 40, 1}, first);
  database.put_machine_datum(anna, {12, 2500, 1}, second);
  database.put_machine_datum(anna, {22, 1, 1}, third);
  database.put_machine_datum(add_student(database, "berta"), {12, 1, 1}, first);
  const auto versions = database.machine_data_versions(anna);
  ASSERT_EQ(versions.size(), 3U);
  EXPECT_EQ(versions[0].numbers, (std::vector<int>{12, 16}));
  EXPECT_EQ(versions[0].author.station, 7);
  EXPECT_EQ(versions[2].version, 3);
  EXPECT_EQ(versions[2].author.name, "lehrer");
  using Values = std::map<int, std::int64_t>;
  EXPECT_EQ(database.machine_data_at(anna, 0), Values());
  EXPECT_EQ(database.machine_data_at(anna, 1), (Values{{12, 3000}, {16, 40}}));
  EXPECT_EQ(database.machine_data_at(anna, 2), (Values{{12, 2500}, {16, 40}}));
  EXPECT_EQ(database.machine_data_at(anna, 3), (Values{{12, 2500}, {16, 40}, {22, 1}}));
  EXPECT_EQ(database.machine_data_at(anna, 4), std::nullopt);
  EXPECT_EQ(database.machine_data_at(anna, -1), std::nullopt);
}

TEST(ControlState, IsKeptPerPersonAndReplaced) {  // SEAT-004
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  EXPECT_EQ(database.control_state(anna), "");
  database.put_control_state(anna, R"({"mode":"AUTOMAT"})", 1);
  database.put_control_state(anna, std::string("\0\xff binary", 9), 2);
  EXPECT_EQ(database.control_state(anna), std::string("\0\xff binary", 9));
  EXPECT_EQ(database.control_state(add_student(database, "berta")), "");
}

TEST(Journal, ListsByPersonAndTimeInTheOrderOfWriting) {  // STO-006, AUTH-015
  auto database = opened(":memory:");
  database.add_journal({{100, 7, "anna", "grant", "selected by lehrer", 12}, {90, 0, "lehrer", "login", "", 0}});
  database.add_journal({{200, 7, "anna", "stop", "", 0xffffffffffU}});
  const auto all = database.journal("", 0);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].detail, "selected by lehrer");
  EXPECT_EQ(all[0].station, 7);
  EXPECT_EQ(all[0].lease, 12U);
  EXPECT_EQ(all[1].person, "lehrer");
  EXPECT_EQ(all[2].lease, 0xffffffffffU);
  ASSERT_EQ(database.journal("anna", 101).size(), 1U);
  EXPECT_EQ(database.journal("anna", 101)[0].kind, "stop");
  database.forget_journal_before(100);
  EXPECT_EQ(database.journal("", 0).size(), 2U);
}

TEST(Journal, IsAppendOnly) {  // STO-006
  const LabFolder folder;
  {
    opened(folder.file()).add_journal({{100, 7, "anna", "grant", "", 12}});
  }
  SQLite::Database raw(folder.file().string(), SQLite::OPEN_READWRITE);
  EXPECT_THROW(raw.exec("UPDATE journal SET person = 'berta'"), SQLite::Exception);
}

TEST(Runs, EventsComeBackInTheirOrderOverSeveralBatches) {  // STO-007
  auto database = opened(":memory:");
  const auto run = database.begin_run({.person = add_student(database, "anna"), .machine = "lab", .setup = "{}"});
  const std::vector<RunEvent> first{{0, "override", 0.5}, {0, "go", 1}}, second{{0, "stop", 2}, {7, "go", 1}};
  database.add_run_events(run, first);
  database.add_run_events(run, second);
  EXPECT_THAT(database.run_events(run), testing::ElementsAre(first[0], first[1], second[0], second[1]));
}

TEST(Runs, OldOnesAndAllButTheNewestOfEachPersonAreForgotten) {  // STO-007: bounded
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna"), otto = add_student(database, "otto");
  for (const std::int64_t started_ms : {10, 20, 30, 40})
    for (const PersonId person : {anna, otto})
      database.begin_run({.person = person, .machine = "training", .started_ms = started_ms, .setup = "{}"});
  database.forget_old_runs(20, 2);
  for (const PersonId person : {anna, otto}) {
    const auto runs = database.runs(person);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].started_ms, 40);
    EXPECT_EQ(runs[1].started_ms, 30);
  }
  database.forget_old_runs(35, 9);
  EXPECT_EQ(database.runs(anna).size(), 1U);
}

TEST(Runs, NewestFirstWithTheirTraceJoinedByTick) {  // STO-007
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  const auto first = database.begin_run({.person = anna,
                                         .station = 3,
                                         .machine = "lab",
                                         .lease = 9,
                                         .started_ms = 50,
                                         .program = 1,
                                         .block = 2,
                                         .setup = R"({"f":1})"});
  const auto second = database.begin_run({.person = anna, .station = 3, .machine = "training", .setup = "{}"});
  database.add_trace(first, 1000, std::string("B\0", 2));
  database.add_trace(first, 0, "A");
  database.end_run(first, {.seconds = 12.5, .ended = "program_end", .ticks = 12500, .digest = "00ff"});
  const auto runs = database.runs(anna);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].id, second);
  EXPECT_FALSE(runs[0].seconds);
  EXPECT_EQ(runs[0].ended, "");
  EXPECT_EQ(runs[1].id, first);
  EXPECT_EQ(runs[1].machine, "lab");
  EXPECT_EQ(runs[1].lease, 9U);
  EXPECT_EQ(runs[1].program, 1);
  EXPECT_EQ(runs[1].block, 2);
  EXPECT_EQ(runs[1].setup, R"({"f":1})");
  EXPECT_DOUBLE_EQ(runs[1].seconds.value(), 12.5);
  EXPECT_EQ(runs[1].ended, "program_end");
  EXPECT_EQ(runs[1].ticks, 12500);
  EXPECT_EQ(runs[1].digest, "00ff");
  EXPECT_EQ(database.run(first)->digest, "00ff");
  EXPECT_EQ(database.run(first)->person, anna);
  EXPECT_FALSE(database.run(999));
  EXPECT_EQ(database.trace(first), std::string("AB\0", 3));
  EXPECT_THAT(database.runs(add_student(database, "berta")), IsEmpty());
}

TEST(Runs, ForgettingKeepsTheNewestTraces) {
  auto database = opened(":memory:");
  const PersonId anna = add_student(database, "anna");
  std::vector<std::int64_t> ids;
  for (int i = 0; i < 4; ++i) {
    ids.push_back(database.begin_run({.person = anna, .station = 1, .machine = "lab", .setup = "{}"}));
    if (i != 3) database.add_trace(ids.back(), 0, "x");  // the newest run has none
  }
  database.forget_old_traces(2);
  EXPECT_EQ(database.trace(ids[0]), "");
  EXPECT_EQ(database.trace(ids[1]), "x");
  EXPECT_EQ(database.trace(ids[2]), "x");
  EXPECT_EQ(database.runs(anna).size(), 4U);
}

TEST(Values, AreBytesAndReplaced) {
  auto database = opened(":memory:");
  EXPECT_EQ(database.value("certificate"), std::nullopt);
  database.put_value("certificate", "one");
  database.put_value("certificate", std::string("t\0wo", 4));
  EXPECT_EQ(database.value("certificate"), std::string("t\0wo", 4));
  database.put_value("empty", "");
  EXPECT_EQ(database.value("empty"), "");
}

TEST(Transaction, RollsBackWhatThrowsAndOnlyThat) {
  auto database = opened(":memory:");
  database.transaction([&] {
    database.put_value("kept", "1");
    EXPECT_THROW(database.transaction([&] {
      database.put_value("lost", "1");
      throw std::runtime_error("no");
    }),
                 std::runtime_error);
    EXPECT_TRUE(database.in_transaction());
  });
  EXPECT_FALSE(database.in_transaction());
  EXPECT_TRUE(database.value("kept"));
  EXPECT_FALSE(database.value("lost"));
}

TEST(Failure, EveryKindHasASentenceForRow18InBothLanguages) {  // DEC-01: one row of 80 columns
  for (const FailureKind kind :
       {FailureKind::locked, FailureKind::full, FailureKind::damaged, FailureKind::disk, FailureKind::refused})
    for (const char* language : {"de", "en"}) {
      const auto text = explain(kind, language);
      const auto is_start = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; };
      const auto room = 80 - std::string_view(language[0] == 'd' ? "Nicht gespeichert: " : "Not stored: ").size();
      EXPECT_LE(static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_start)), room) << text;
    }
}

}  // namespace
}  // namespace cnclab::db
