// Who moves the lab's machine: offers, leases, lost lines, two stations at once (AUTH-001 to AUTH-009).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "harness/classroom.hpp"
#include "programs.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

/// Two students with an endless program, seated.
class Selector : public testing::Test {
 protected:
  Selector() {
    room_.add_student("anna", {kEndless});
    room_.add_student("otto", {kEndless});
  }

  nlohmann::json machine() { return room_.instructor().status()["machine"]; }
  int selected() { return room_.instructor().status()["selected"]; }
  OneShot ask(const std::vector<std::string>& arguments) { return room_.instructor().run(arguments); }

  static void run_program(StationProcess& station) { station.key("AUTOMAT ENTER ENTER START"); }
  void run_on_machine(int number, StationProcess& station) {
    room_.give_machine(number, station);
    run_program(station);
    ASSERT_TRUE(eventually(kLimit, [&] { return machine()["x"] > 2; })) << station.text();
  }
  [[nodiscard]] bool comes_to_rest() {
    return eventually(kLimit, [&] { return machine()["state"] == "standstill"; });
  }
  /// Several looks at the machine, each a whole question and answer, give the same position.
  void expect_still() {
    const auto before = machine();
    constexpr int kLooks = 10;
    for (int look = 0; look < kLooks; ++look) {
      const auto now = machine();
      ASSERT_EQ(now["x"], before["x"]);
      ASSERT_EQ(now["state"], before["state"]);
    }
  }

  Classroom room_;
};

TEST_F(Selector, AUTH_002_a_station_without_a_login_cannot_be_selected) {
  const OneShot refused = ask({"select", "3"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, HasSubstr("3"));
  EXPECT_EQ(selected(), 0);
}

TEST_F(Selector, AUTH_005_an_offer_is_shown_and_gives_nobody_control_before_START) {
  StationProcess anna = room_.seat(1, "anna");
  room_.instructor().must({"select", "1"});
  anna.wait_for("START nimmt an");
  const auto status = room_.instructor().status();
  EXPECT_EQ(status["offered"], 1);
  EXPECT_EQ(status["selected"], 0);
}

TEST_F(Selector, AUTH_005_accepting_with_START_starts_nothing) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("AUTOMAT ENTER ENTER");
  room_.give_machine(1, anna);
  anna.wait_for("MASCHINE");
  expect_still();
  EXPECT_EQ(room_.instructor().station(1)["running"], false);
  EXPECT_EQ(room_.instructor().station(1)["mode"], "MENU") << "AUTH-003";
}

TEST_F(Selector, AUTH_005_STOP_declines_the_offer) {
  StationProcess anna = room_.seat(1, "anna");
  room_.instructor().must({"select", "1"});
  anna.wait_for("START nimmt an");
  anna.key("STOP");
  EXPECT_EQ(room_.instructor().status()["offered"], 0);
  anna.key("START");
  EXPECT_EQ(selected(), 0);
}

TEST_F(Selector, AUTH_001_the_selected_stations_program_moves_the_machine_and_all_see_who_has_it) {
  StationProcess anna = room_.seat(1, "anna");
  StationProcess otto = room_.seat(2, "otto");
  run_on_machine(1, anna);
  EXPECT_EQ(machine()["state"], "moving");
  anna.wait_for("MASCHINE");
  otto.wait_for("TRAINING");
  otto.wait_for("Platz 01");
  anna.key("STOP");
  EXPECT_TRUE(comes_to_rest());
}

TEST_F(Selector, AUTH_001_another_stations_START_moves_its_training_machine_only) {
  StationProcess anna = room_.seat(1, "anna");
  StationProcess otto = room_.seat(2, "otto");
  room_.give_machine(1, anna);
  run_program(otto);
  ASSERT_TRUE(eventually(kLimit, [&] { return room_.instructor().station(2)["running"] == true; }));
  EXPECT_EQ(machine()["x"], 0);
  expect_still();
  EXPECT_EQ(selected(), 1);
}

TEST_F(Selector, AUTH_004_release_and_select_are_refused_with_a_reason_while_a_program_runs) {
  StationProcess anna = room_.seat(1, "anna");
  StationProcess otto = room_.seat(2, "otto");
  run_on_machine(1, anna);
  for (const auto& command : {std::vector<std::string>{"release"}, std::vector<std::string>{"select", "2"}}) {
    const OneShot refused = ask(command);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.errors, testing::StartsWith("error: "));
  }
  EXPECT_EQ(selected(), 1);
  EXPECT_EQ(room_.instructor().status()["offered"], 0);
}

TEST_F(Selector, AUTH_004_force_stops_first_and_offers_only_after_standstill) {
  StationProcess anna = room_.seat(1, "anna");
  StationProcess otto = room_.seat(2, "otto");
  run_on_machine(1, anna);
  room_.instructor().must({"select", "2", "--force"});
  ASSERT_TRUE(eventually(kLimit, [&] {
    const auto status = room_.instructor().status();
    EXPECT_TRUE(status["offered"] != 2 || status["machine"]["state"] == "standstill") << status;
    return status["offered"] == 2;
  }));
  anna.wait_for("TRAINING");
  otto.key("START");
  ASSERT_TRUE(eventually(kLimit, [&] { return selected() == 2; }));
  anna.key("START");
  expect_still();
}

TEST_F(Selector, AUTH_002_the_lease_number_only_grows_also_over_a_restart) {
  double before = room_.instructor().status()["lease"];
  for (int round = 0; round < 2; ++round) {
    StationProcess anna = room_.seat(1, "anna");
    room_.give_machine(1, anna);
    const double now = room_.instructor().status()["lease"];
    EXPECT_GT(now, before);
    before = now;
    room_.crash_and_restart();
  }
}

TEST_F(Selector, AUTH_007_a_cut_line_stops_the_machine_and_takes_control_away) {
  TcpProxy line(room_.server().port());
  StationProcess anna = room_.seat_behind(line, 1, "anna");
  run_on_machine(1, anna);
  line.cut();
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  EXPECT_TRUE(comes_to_rest());
  expect_still();
}

TEST_F(Selector, AUTH_007_a_silent_line_stops_the_machine_and_takes_control_away) {
  TcpProxy line(room_.server().port());
  StationProcess anna = room_.seat_behind(line, 1, "anna");
  run_on_machine(1, anna);
  line.stall();
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  EXPECT_TRUE(comes_to_rest());
}

TEST_F(Selector, AUTH_007_signs_of_life_that_answer_no_new_beat_do_not_count) {
  TcpProxy line(room_.server().port());
  StationProcess anna = room_.seat_behind(line, 1, "anna");
  run_on_machine(1, anna);
  line.stall_answers();
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  EXPECT_TRUE(comes_to_rest());
}

TEST_F(Selector, AUTH_009_the_reconnected_station_moves_nothing) {
  TcpProxy line(room_.server().port());
  StationProcess anna = room_.seat_behind(line, 1, "anna");
  run_on_machine(1, anna);
  line.cut();
  ASSERT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  EXPECT_THAT(anna.send("key START").value_or(""), HasSubstr("VERBINDUNG VERLOREN"));
  line.mend();
  ASSERT_TRUE(eventually(10s, [&] { return anna.send("wait 500 TRAINING") == "ok"; }));
  ASSERT_TRUE(comes_to_rest());
  const auto before = machine();
  anna.key("START");
  expect_still();
  EXPECT_EQ(machine()["x"], before["x"]);
  EXPECT_EQ(selected(), 0);
}

TEST_F(Selector, AUTH_007_a_killed_station_stops_the_machine) {
  StationProcess anna = room_.seat(1, "anna");
  run_on_machine(1, anna);
  anna.kill_hard();
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  EXPECT_TRUE(comes_to_rest());
}

TEST_F(Selector, AUTH_007_a_frozen_station_stops_the_machine) {
  StationProcess anna = room_.seat(1, "anna");
  run_on_machine(1, anna);
  anna.send_signal(SIGSTOP);
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  EXPECT_TRUE(comes_to_rest());
  anna.send_signal(SIGCONT);
}

TEST_F(Selector, AUTH_002_logging_out_and_taking_over_end_the_lease) {
  StationProcess anna = room_.seat(1, "anna");
  room_.give_machine(1, anna);
  StationOptions options = room_.station_options(2, "anna");
  options.more = {"--take-over"};
  StationProcess again(options);
  again.wait_for("TRAINING");
  EXPECT_EQ(anna.wait(kLimit), 6);
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  room_.give_machine(2, again);
  again.quit();
  EXPECT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
}

TEST_F(Selector, AUTH_001_two_stations_fighting_for_the_machine_never_both_have_it) {
  StationProcess anna = room_.seat(1, "anna");
  StationProcess otto = room_.seat(2, "otto");
  double lease = room_.instructor().status()["lease"];
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    const int number = round % 2 + 1;
    StationProcess& winner = number == 1 ? anna : otto;
    StationProcess& loser = number == 1 ? otto : anna;
    room_.instructor().must({"select", std::to_string(number), "--force"});
    loser.key("START");
    ASSERT_TRUE(eventually(kLimit, [&] { return room_.instructor().status()["offered"] == number; }));
    loser.key("START");
    EXPECT_EQ(selected(), 0) << "the other's START accepted an offer that was not its own";
    winner.key("START");
    ASSERT_TRUE(eventually(kLimit, [&] { return selected() == number; }));
    winner.wait_for("MASCHINE");
    loser.wait_for("TRAINING");
    const double now = room_.instructor().status()["lease"];
    EXPECT_GT(now, lease);
    lease = now;
  }
}

TEST_F(Selector, AUTH_015_offers_grants_and_losses_are_in_the_journal) {
  StationProcess anna = room_.seat(1, "anna");
  room_.give_machine(1, anna);
  room_.instructor().must({"release"});
  ASSERT_TRUE(eventually(kLimit, [&] { return selected() == 0; }));
  const auto has_all = [&] {
    std::string kinds;
    for (const auto& entry : room_.instructor().must({"journal", "anna"}).objects) {
      kinds += entry["kind"].get<std::string>() + " ";
    }
    return kinds.find("offer ") != std::string::npos && kinds.find("grant ") != std::string::npos &&
           kinds.find("lease_ended ") != std::string::npos;
  };
  EXPECT_TRUE(eventually(kLimit, has_all)) << room_.instructor().must({"journal", "anna"}).output;
}

}  // namespace
}  // namespace cnclab::harness
