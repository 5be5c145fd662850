// The lab's machine at real stations: whose zero it has, which tool is in its spindle, what its data do, what its tool
// cuts, and how what it did is played again (DEC-24 to DEC-29, ERR-020, HW-022, STO-007).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

/// A machine of 20 mm of travel on each axis, so that references are near, and two students.
class LabMachine : public testing::Test {
 protected:
  explicit LabMachine(const std::string& configuration = "") : room_(configuration) {
    ask({"machine-data", "03=20000", "04=20000", "05=20000"});
  }

  OneShot ask(const std::vector<std::string>& arguments) { return room_.instructor().must(arguments); }
  nlohmann::json machine() { return room_.instructor().status()["machine"]; }
  /// The selector falls back to 0.
  void take_back() {
    ASSERT_TRUE(eventually(kLimit, [&] { return room_.instructor().run({"release"}).exit_code == 0; }));
    ASSERT_TRUE(eventually(kLimit, [&] { return room_.instructor().status()["selected"] == 0; }));
  }
  /// A START that crosses a change of the screen is refused (AUTH-008) and pressed again, as its sentence asks.
  static void start_until(StationProcess& station, const std::string& text) {
    station.key("START");
    ASSERT_TRUE(eventually(kLimit, [&] {
      if (station.shows("START kam zu spät")) station.key("START");
      return station.shows(text);
    })) << station.text();
  }
  /// All three axes to their switches.
  void reference(StationProcess& station) {
    station.key("MENU HAND PLUS_X PLUS_Y PLUS_Z REFERENZ");
    ASSERT_TRUE(eventually(kLimit, [&] {
      if (station.shows("START kam zu spät")) station.key("REFERENZ");
      return machine()["referenced"] == true && machine()["state"] == "standstill";
    })) << station.text();
  }
  static void call_x(StationProcess& station, const std::string& value) {
    station.key("MENU HAND ISTWERT PLUS_X");
    station.type(value);
    station.key("ISTWERT");
  }
  /// The kinds of the journal, with what they tell.
  bool journal_tells(const std::string& student, const std::string& kind, const std::string& detail) {
    const auto entries = ask({"journal", student}).objects;
    return std::ranges::any_of(entries, [&](const auto& entry) {
      return entry["kind"] == kind && entry["detail"].template get<std::string>().find(detail) != std::string::npos;
    });
  }

  Classroom room_;
};

TEST_F(LabMachine, DEC_25_its_data_act_on_its_iron_and_the_students_on_the_training_machine) {
  room_.add_student("anna", {"P0001\nN001G01X+15000F3000\n"});
  StationProcess anna = room_.seat(1, "anna");
  anna.key("AUTOMAT ENTER ENTER START");
  anna.wait_for("X  +0015.000");  // her own machine has 500 mm
  anna.key("MENU");
  room_.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER");
  start_until(anna, "Endschalter X");
  EXPECT_EQ(monitor_row(anna.screen(), 16), "Endschalter");
  take_back();
  anna.expect_ok("hold 50 ENTER+RESET");
  anna.key("ENTER ENTER");
  anna.type("40000");  // X ACHSE: 20 mm from the middle, where X stands at 15 now
  anna.key("ENTER");
  anna.wait_for("NR 04");
  anna.key("RESET AUTOMAT ENTER ENTER START");
  anna.wait_for("Endschalter X");
}

TEST_F(LabMachine, DEC_27_each_student_finds_the_own_zero_again) {
  room_.add_student("anna");
  room_.add_student("otto");
  StationProcess anna = room_.seat(1, "anna"), otto = room_.seat(2, "otto");
  room_.give_machine(1, anna);
  reference(anna);
  call_x(anna, "100");
  anna.wait_for("X  +0100.000");
  take_back();
  room_.give_machine(2, otto);
  EXPECT_TRUE(eventually(kLimit, [&] { return machine()["x"] == 0; })) << "none of his own: the reference point";
  call_x(otto, "7.5");
  take_back();
  room_.give_machine(1, anna);
  EXPECT_TRUE(eventually(kLimit, [&] { return machine()["x"] == 100; })) << machine();
  take_back();
  room_.give_machine(2, otto);
  EXPECT_TRUE(eventually(kLimit, [&] { return machine()["x"] == 7.5; })) << machine();
}

TEST_F(LabMachine, AUTH_011_a_block_beyond_the_travel_is_refused_before_it_moves_and_its_run_is_played_again) {
  room_.add_student("anna", {"P0001\nN001G01Y-3000F3000M03\nN002G01X+19500\n"});
  StationProcess anna = room_.seat(1, "anna");
  room_.give_machine(1, anna);
  reference(anna);
  anna.key("MENU AUTOMAT ENTER ENTER");
  start_until(anna, "Verfahrweg zu gross");
  EXPECT_THAT(anna.text(), HasSubstr("P0001 N002"));
  EXPECT_EQ(machine()["x"], 0);
  EXPECT_EQ(machine()["y"], -3);
  anna.key("MENU HANDEINGABE");
  anna.wait_for("G01 X");
  anna.type("01");
  anna.key("ENTER");
  anna.type("-4");
  start_until(anna, "X  -0004.000");
  anna.key("MENU HAND MINUS_Z START");
  ASSERT_TRUE(eventually(kLimit, [&] { return machine()["z"] < -0.5; })) << anna.text();
  anna.key("STOP");
  const auto runs = [&] { return ask({"runs", "anna"}).objects; };
  ASSERT_TRUE(eventually(kLimit, [&] {
    const auto all = runs();
    return all.size() == 4 &&
           std::ranges::all_of(all, [](const auto& run) { return !run["ended"].empty() && run["ended"] != ""; });
  })) << ask({"runs", "anna"}).output;
  std::vector<std::string> ran;
  for (const auto& run : runs()) {  // by hand, HANDEINGABE, the program that failed, the reference run
    ran.push_back(run["program"]);
    const auto replayed = ask({"run", "replay", std::to_string(run["id"].get<int>())}).objects.at(0);
    EXPECT_EQ(replayed["same"], true) << run.dump() << ": " << replayed["detail"];
    EXPECT_EQ(replayed["largest_deviation_mm"], 0);
    EXPECT_GT(replayed["ticks"], 50);
  }
  EXPECT_THAT(ran, testing::UnorderedElementsAre("HAND", "HANDEINGABE", "P0001", "HAND")) << "what each has executed";
}

TEST_F(LabMachine, HW_022_the_instructors_input_goes_to_the_labs_machine) {
  room_.add_student("anna", {"P0001\nN001G11F1000M16\nN002G11M62\nN003G01X+1000\n"});
  StationProcess anna = room_.seat(1, "anna");
  room_.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER");
  start_until(anna, "wartet");
  ask({"input", "0", "on"});
  anna.wait_for("N002");
  EXPECT_EQ(machine()["state"], "halted");
  ask({"input", "12", "on"});
  anna.wait_for("X  +0001.000");
  EXPECT_TRUE(anna.shows("01000000")) << "the inputs of card 1 as they are now: " << anna.text();
  ask({"input", "0", "off"});
  EXPECT_EQ(room_.instructor().run({"input", "19", "on"}).exit_code, 1);
}

TEST_F(LabMachine, DEC_24_rapids_into_the_workpiece_and_a_spindle_that_stands_are_told) {
  room_.add_student("anna", {"P0000\nT001R+2000L+0\nP0001\nN001G11F1000T01\nN002G00Z-5000\nN003G01X+3000\n"});
  StationProcess anna = room_.seat(1, "anna");
  room_.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER");
  start_until(anna, "im Material");
  EXPECT_TRUE(eventually(kLimit, [&] { return anna.shows("P0001 N003: Fräser steht im Material"); })) << anna.text();
  EXPECT_TRUE(eventually(kLimit, [&] {
    return journal_tells("anna", "milling", "rapid in material P0001 N002") &&
           journal_tells("anna", "milling", "spindle off in material P0001 N003");
  }));
  EXPECT_GE(room_.instructor().station(1)["errors_last_minute"], 2);
}

TEST_F(LabMachine, RULE_6_status_counts_stalls_of_the_beat) {
  const auto ticks = room_.instructor().status()["ticks"];
  EXPECT_TRUE(ticks.contains("late") && ticks.contains("longest_ms"));
  EXPECT_EQ(ticks["stalls"], 0);
  EXPECT_THAT(room_.server().log(), HasSubstr("tick: "));
}

class ToolList : public LabMachine {
 protected:
  ToolList() : LabMachine("[machine]\ntool_list = true\n") {
    const auto list = room_.folder().write("tools", "P0000\nT003R+5000L+0\n");
    ask({"tools", list.string()});
    room_.add_student("anna", {kRight});
    room_.add_student("otto", {kRight});
    room_.add_student("ida", {"P0000\nT003R+5020L+0\nP0001\nN001G11F1000T03\nN002G01X+1000\n"});
  }
  static constexpr const char* kRight = "P0000\nT003R+5005L+0\nP0001\nN001G11F1000T03\nN002G01X+1000\n";
};

TEST_F(ToolList, DEC_29_the_machine_waits_for_the_tool_keeps_it_and_refuses_another_radius) {
  StationProcess anna = room_.seat(1, "anna"), otto = room_.seat(2, "otto"), ida = room_.seat(3, "ida");
  room_.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER");
  start_until(anna, "Werkzeug T03 einsetzen");
  EXPECT_EQ(monitor_row(anna.screen(), 16), "Werkzeug T03 einsetzen");
  EXPECT_EQ(machine()["state"], "halted");
  EXPECT_EQ(machine()["x"], 0);
  start_until(anna, "X  +0001.000");
  anna.key("MENU");
  take_back();
  room_.give_machine(2, otto);
  otto.key("AUTOMAT ENTER ENTER");
  start_until(otto, "beendet");  // T03 is in already
  otto.key("MENU");
  take_back();
  room_.give_machine(3, ida);
  const double before = machine()["x"];
  ida.key("AUTOMAT ENTER ENTER");
  start_until(ida, "Werkzeug falsch");
  EXPECT_THAT(ida.text(), HasSubstr("P0001 N001: T03 R 5.020 weicht ab, richtig: 4.990..5.010"));
  EXPECT_EQ(machine()["x"], before);
}

}  // namespace
}  // namespace cnclab::harness
