// The instructor's one-shot commands against a real server: what they print, and what comes of it (INS-003 to INS-005).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

class Commands : public testing::Test {
 protected:
  OneShot ask(const std::vector<std::string>& arguments) { return room_.instructor().run(arguments); }
  OneShot must(const std::vector<std::string>& arguments) { return room_.instructor().must(arguments); }
  std::string file(const std::string& name, const std::string& content) {
    return folder_.write(name, content).string();
  }

  TemporaryFolder folder_;
  Classroom room_;
};

TEST_F(Commands, INS_004_a_roster_is_imported_whole_and_exported_again) {
  const auto csv = file("roster.csv", "name,password,language\nanna,,en\notto,\"sehr,geheim\",\n\nemil\n");
  const OneShot imported = must({"import", csv});
  ASSERT_EQ(imported.objects.size(), 2U) << imported.output;
  EXPECT_EQ(imported.objects[0]["name"], "anna");
  EXPECT_GE(imported.objects[0]["password"].get<std::string>().size(), 12U);
  EXPECT_EQ(imported.objects[1]["name"], "emil");
  const auto target = (folder_.path() / "out.csv").string();
  must({"export", target});
  EXPECT_EQ(read_file(target), "name,password,language\nanna,,en\nemil,,\notto,,\n");
  room_.passwords().set("otto", "sehr,geheim");
  StationProcess otto = room_.seat(2, "otto");
}

TEST_F(Commands, INS_004_an_import_with_errors_names_every_line_and_adds_nobody) {
  room_.add_student("otto");
  const OneShot bad = ask({"import", file("bad.csv", "anna,kurz,\nemil,,fr\nberta\nberta\na b,,\n")});
  EXPECT_EQ(bad.exit_code, 1);
  for (const char* line : {"Zeile 1: ", "Zeile 2: ", "Zeile 4: ", "Zeile 5: "})
    EXPECT_THAT(bad.errors, HasSubstr(line));
  const OneShot both = ask({"import", file("both.csv", "name,password,language\notto,,\nanna,kurz,\nemil,,fr\n,,\n")});
  for (const char* line : {"Zeile 2: den Namen otto gibt es schon\n", "Zeile 3: ", "Zeile 4: ", "Zeile 5: "})
    EXPECT_THAT(both.errors, HasSubstr(line));
  const OneShot known = ask({"import", file("known.csv", "berta\notto\n")});
  EXPECT_EQ(known.exit_code, 1);
  EXPECT_THAT(known.errors, HasSubstr("Zeile 2: "));
  EXPECT_EQ(must({"students"}).objects.size(), 2U) << "lehrer and otto";
}

TEST_F(Commands, INS_004_a_file_that_is_not_UTF_8_is_refused_with_its_line_and_nothing_is_sent) {
  const auto roster = file("latin1.csv", "name,password,language\nm\xfcller,,\n");
  const OneShot refused = ask({"import", roster});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, testing::StartsWith("error: " + roster + ":2: "));
  EXPECT_THAT(refused.errors, testing::Not(HasSubstr("protobuf")));
  Instructor instructor = room_.instructor();
  instructor.options().password_file = file("latin1-password", "gr\xfc\xdf");
  const OneShot unreadable = instructor.run({"students"});
  EXPECT_EQ(unreadable.exit_code, 1);
  EXPECT_THAT(unreadable.errors, HasSubstr(":1: "));
}

TEST_F(Commands, INS_005_whatever_fails_a_command_prints_error_and_exits_1) {
  const auto fails = [](const Instructor& instructor, const std::vector<std::string>& arguments) {
    const OneShot failed = instructor.run(arguments);
    EXPECT_EQ(failed.exit_code, 1) << failed.errors;
    EXPECT_THAT(failed.errors, testing::StartsWith("error: "));
    EXPECT_EQ(failed.output, "");
  };
  fails(room_.instructor(), {"select", "3"});
  fails(room_.instructor(), {"select", "16"});
  fails(room_.instructor(), {"bogus"});
  Instructor unreachable = room_.instructor(), wrong_password = room_.instructor(), other_server = room_.instructor();
  unreachable.options().server = "127.0.0.1:1";
  fails(unreachable, {"status"});
  wrong_password.options().password_file = file("wrong", "not the password");
  fails(wrong_password, {"status"});
  other_server.options().fingerprint = "SHA256:" + std::string(43, 'A');
  fails(other_server, {"status"});
}

TEST_F(Commands, INS_004_a_renamed_student_logs_in_by_the_new_name_with_all_programs) {
  room_.add_student("anna", {"P0001\nN001G00X+1000\n"});
  must({"student", "rename", "anna", "anne"});
  room_.passwords().set("anne", room_.passwords().password_of("anna"));
  StationProcess anne = room_.seat(1, "anne");
  EXPECT_EQ(must({"program", "show", "anne", "P0001"}).output, "P0001\nN001G00X+1000\n%\n");
}

TEST_F(Commands, DEC_08_a_student_has_the_model_and_the_language_that_the_instructor_has_set) {
  room_.add_student("anna");
  must({"student", "set", "anna", "--model", "3250", "--language", "en"});
  StationProcess anna = room_.seat(1, "anna");
  EXPECT_TRUE(anna.shows("CNC 3250")) << anna.text();
  EXPECT_TRUE(anna.shows("all keys")) << anna.text();
  EXPECT_EQ(ask({"student", "set", "nobody", "--model", "3300"}).exit_code, 1);
  EXPECT_EQ(ask({"student", "set", "anna"}).exit_code, 1);
}

TEST_F(Commands, INS_003_programs_are_sent_to_all_and_collected_from_all) {
  room_.add_student("anna");
  room_.add_student("otto");
  must({"program", "send", file("tape", "P0001\nN001G00X+1000\nP0002\nN001G00Y+1000\n"), "--all"});
  must({"program", "send", file("own", "P0003\nN001G00Z+1000\n"), "otto"});
  EXPECT_EQ(ask({"program", "send", file("tape", "P0001\nN001G00X+1000\n"), "--all"}).exit_code, 1);
  const OneShot collected = must({"program", "collect", folder_.path().string()});
  ASSERT_EQ(collected.objects.size(), 2U) << collected.output;
  EXPECT_EQ(read_file(folder_.path() / "anna.tape"), "P0001\nN001G00X+1000\n%\nP0002\nN001G00Y+1000\n%\n");
  EXPECT_THAT(read_file(folder_.path() / "otto.tape"), HasSubstr("P0003\nN001G00Z+1000\n%\n"));
  must({"program", "collect", folder_.path().string(), "P0003"});
  EXPECT_EQ(read_file(folder_.path() / "otto.tape"), "P0003\nN001G00Z+1000\n%\n");
  // What was collected can be sent again.
  must({"program", "send", (folder_.path() / "otto.tape").string(), "anna"});
}

TEST_F(Commands, DEC_06_a_tape_with_nothing_but_a_cycles_program_is_refused_with_the_reason) {
  room_.add_student("anna");
  EXPECT_THAT(ask({"program", "send", file("tape", "P9981\nN001G91\n"), "anna"}).errors,
              HasSubstr("P9981 bis P9989 gehören den Zyklen"));
  EXPECT_THAT(ask({"program", "send", file("empty", "%\n"), "anna"}).errors, HasSubstr("kein Programm"));
}

TEST_F(Commands, INS_003_however_long_a_collected_file_is_it_can_be_sent_again) {
  Classroom large("[lab]\nmemory_bytes = 99999\n");
  large.add_student("anna");
  large.add_student("otto");
  std::string tape;
  for (int program = 1; program <= 5; ++program) {
    tape += "P000" + std::to_string(program) + "\n";
    for (int block = 1; block <= 900; ++block)
      tape += "N" + std::to_string(1000 + block).substr(1) + "G01X+1000Y-1000\n";
    tape += "%\n";
  }
  ASSERT_GT(tape.size(), 65'536U);
  large.instructor().must({"program", "send", file("long", tape), "anna"});
  large.instructor().must({"program", "collect", folder_.path().string()});
  EXPECT_EQ(read_file(folder_.path() / "anna.tape"), tape);
  large.instructor().must({"program", "send", (folder_.path() / "anna.tape").string(), "otto"});
  EXPECT_EQ(large.instructor().must({"programs", "otto"}).objects.size(), 5U);
  // Nothing of a long file that was refused is left for the next one.
  EXPECT_EQ(large.instructor().run({"program", "send", file("long", tape), "anna"}).exit_code, 1);
  large.instructor().must({"program", "send", file("short", "P0009\nN001G00X+1000\n"), "anna"});
}

TEST_F(Commands, INS_003_a_program_that_does_not_fit_the_memory_is_refused_for_all) {
  room_.add_student("anna");
  std::string tape = "P0001\n";
  for (int block = 1; block <= 999; ++block) {
    const std::string digits = std::to_string(1000 + block).substr(1);
    tape += "N" + digits + "G01X+100000Y+100000Z+100000F1000S1000T01M03\n";
  }
  const OneShot refused = ask({"program", "send", file("large", tape), "anna"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, HasSubstr("anna"));
  EXPECT_TRUE(must({"programs", "anna"}).objects.empty());
}

TEST_F(Commands, STO_005_an_older_version_becomes_the_newest_also_of_a_program_that_was_deleted) {
  room_.add_student("anna", {"P0001\nN001G00X+1000\n"});
  must({"program", "send", file("second", "P0001\nN001G00X+2000\n"), "anna", "--replace"});
  StationProcess anna = room_.seat(1, "anna");
  must({"program", "restore", "anna", "P0001", "1"});
  EXPECT_EQ(must({"program", "show", "anna", "P0001"}).output, "P0001\nN001G00X+1000\n%\n");
  anna.key("EINGABE DOWN");
  anna.wait_for("1.000");
  EXPECT_EQ(must({"program", "versions", "anna", "P0001"}).objects.size(), 3U);
  EXPECT_EQ(ask({"program", "restore", "anna", "P0001", "9"}).exit_code, 1);
}

TEST_F(Commands, STO_005_the_tool_table_has_versions_like_a_program) {
  room_.add_student("anna", {"P0000\nT001R+5000L+1000\n"});
  must({"program", "send", file("second", "P0000\nT001R+6000L+1000\n"), "anna", "--replace"});
  must({"program", "restore", "anna", "P0000", "1"});
  EXPECT_THAT(must({"program", "show", "anna", "P0000"}).output, HasSubstr("R+5000"));
  EXPECT_EQ(must({"program", "versions", "anna", "P0000"}).objects.size(), 3U);
}

TEST_F(Commands, STO_005_machine_data_have_versions_and_come_back) {
  room_.add_student("anna");
  StationProcess anna = room_.seat(1, "anna");
  anna.expect_ok("hold 50 ENTER+RESET");
  anna.wait_for("MASCHINENDATEN");
  for (int i = 0; i < 5; ++i) anna.key("ENTER");
  anna.type("1500");
  anna.key("ENTER");
  ASSERT_TRUE(eventually(5s, [&] { return must({"program", "versions", "anna", "MD"}).objects.size() == 1; }))
      << anna.text();
  EXPECT_THAT(must({"program", "show", "anna", "MD"}).output, HasSubstr("06 = 1500"));
  must({"program", "restore", "anna", "MD", "0"});
  EXPECT_THAT(must({"program", "show", "anna", "MD"}).output, HasSubstr("06 = 3000"));
  anna.key("RESET");
  anna.expect_ok("hold 50 ENTER+RESET");
  for (int i = 0; i < 5; ++i) anna.key("ENTER");
  anna.wait_for("3000");
  EXPECT_EQ(ask({"program", "restore", "anna", "MD", "9"}).exit_code, 1);
}

TEST_F(Commands, DEC_29_the_machines_tools_and_workpiece_are_kept_over_a_restart) {
  must({"tools", file("tools", "P0000\nT001R+5000L+100000\n")});
  must({"workpiece", "100", "60.5", "20"});
  EXPECT_EQ(ask({"tools", file("other", "P0001\nN001G00X+1000\n")}).exit_code, 1);
  EXPECT_EQ(ask({"workpiece", "0.5", "60", "20"}).exit_code, 1);
  room_.crash_and_restart();
  EXPECT_EQ(must({"tools"}).output, "P0000\nT001R+5000L+100000\n%\n");
  const auto size = must({"workpiece"}).objects.at(0);
  EXPECT_EQ(size["x"], 100);
  EXPECT_EQ(size["y"], 60.5);
  EXPECT_EQ(size["z"], 20);
}

TEST_F(Commands, STO_008_a_backup_made_while_students_work_is_restored_by_the_server) {
  room_.add_student("anna", {"P0001\nN001G00X+1000\n"});
  StationProcess anna = room_.seat(1, "anna");
  const auto copy = folder_.path() / "copy.db";
  must({"backup", copy.string()});
  EXPECT_EQ(std::filesystem::status(copy).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  must({"student", "remove", "anna", "--erase"});
  const std::string fingerprint = room_.server().fingerprint();
  room_.server().terminate();
  ASSERT_EQ(room_.server().wait(5s), 0);
  ChildProcess restore({.program = programs_folder() / "cnclab-server",
                        .arguments = {"--data", room_.data().string(), "--restore", copy.string()},
                        .environment = {},
                        .stderr_file = folder_.path() / "restore.log"});
  ASSERT_EQ(restore.wait(10s), 0) << read_file(folder_.path() / "restore.log");
  room_.crash_and_restart();
  EXPECT_EQ(room_.server().fingerprint(), fingerprint) << "certificate and key are in the backup";
  EXPECT_EQ(must({"program", "show", "anna", "P0001"}).output, "P0001\nN001G00X+1000\n%\n");
}

TEST_F(Commands, INS_002_watch_prints_the_stations_screen_as_it_changes) {
  room_.add_student("anna");
  StationProcess anna = room_.seat(1, "anna");
  Instructor instructor = room_.instructor();
  const auto& options = instructor.options();
  ChildProcess watch({.program = programs_folder() / "cnclab-instructor",
                      .arguments = {"--server", options.server, "--user", options.user, "--password-file",
                                    options.password_file.string(), "--fingerprint", options.fingerprint, "watch", "1"},
                      .environment = {},
                      .stderr_file = folder_.path() / "watch.log"});
  const Deadline deadline(10s);
  const auto read_until = [&](const std::string& text) {
    while (auto line = watch.read_line(deadline))
      if (line->find(text) != std::string::npos) return true;
    return false;
  };
  ASSERT_TRUE(read_until("CNC 3300")) << read_file(folder_.path() / "watch.log");
  ASSERT_TRUE(read_until("end"));
  anna.key("EINGABE");
  EXPECT_TRUE(read_until("EINGABEMODUS"));
  must({"expel", "1"});
  EXPECT_TRUE(read_until("An Platz 1 ist niemand angemeldet."));
}

TEST_F(Commands, STO_007_runs_on_both_machines_are_recorded_and_replayed_to_the_same_trajectory) {
  room_.add_student("anna", {"P0001\nN001G01X+5000F2000M03\nN002G01Y+3000F1000\nN003G04H0002\nN004G01X-1000M02\n"});
  StationProcess anna = room_.seat(1, "anna");
  const auto runs = [&] { return must({"runs", "anna"}).objects; };
  const auto has_ended = [&](std::size_t count) {
    return eventually(10s, [&] {
      const auto all = runs();
      return all.size() == count && all[0]["ended"] == "program_end";
    });
  };
  anna.key("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(has_ended(1)) << anna.text() << must({"runs", "anna"}).output;
  EXPECT_EQ(runs()[0]["machine"], "training");
  anna.key("MENU");
  room_.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER");
  anna.expect_ok("pot 60");
  anna.key("START");
  ASSERT_TRUE(has_ended(2)) << anna.text();
  EXPECT_EQ(runs()[0]["machine"], "lab");
  // The program as it was then: a later change does not matter.
  must({"program", "send", file("other", "P0001\nN001G00X+1000\n"), "anna", "--replace"});
  for (const auto& run : runs()) {
    const auto replayed = must({"run", "replay", std::to_string(run["id"].get<int>())}).objects.at(0);
    EXPECT_EQ(replayed["same"], true) << run["machine"] << ": " << replayed["detail"];
    EXPECT_EQ(replayed["largest_deviation_mm"], 0);
    EXPECT_GT(replayed["ticks"], 300);
  }
  EXPECT_EQ(ask({"run", "replay", "999"}).exit_code, 1);
  // A row for each tick, whether a trace was kept (the lab's machine) or not.
  for (const auto& run : runs()) {
    EXPECT_EQ(run["program"], "P0001");
    const auto target = folder_.path() / "trace.csv";
    must({"run", "trace", std::to_string(run["id"].get<int>()), target.string()});
    const std::string csv = read_file(target);
    EXPECT_THAT(csv, testing::StartsWith("t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block\n0.001,"));
    const auto ticks = must({"run", "replay", std::to_string(run["id"].get<int>())}).objects.at(0)["ticks"].get<int>();
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), ticks + 1) << run["machine"];
    EXPECT_THAT(csv, HasSubstr(",1,4\n")) << "the last block";
  }
  EXPECT_EQ(ask({"run", "trace", "999", (folder_.path() / "none.csv").string()}).exit_code, 1);
}

TEST_F(Commands, INS_006_hands_stand_in_the_order_in_which_they_were_raised) {
  room_.add_student("anna");
  room_.add_student("otto");
  StationProcess anna = room_.seat(1, "anna"), otto = room_.seat(2, "otto");
  otto.key("MELDUNG");
  anna.key("MELDUNG");
  EXPECT_EQ(room_.instructor().station(2)["meldung"], 1);
  EXPECT_EQ(room_.instructor().station(1)["meldung"], 2);
  otto.key("MELDUNG");
  EXPECT_EQ(room_.instructor().station(1)["meldung"], 1);
}

TEST_F(Commands, INS_001_status_names_the_last_key_and_counts_errors_of_the_last_minute) {
  room_.add_student("anna");
  StationProcess anna = room_.seat(1, "anna");
  anna.key("AUTOMAT 9 9 9 9 ENTER");
  EXPECT_EQ(room_.instructor().station(1)["last_key"], "ENTER");
  EXPECT_EQ(room_.instructor().station(1)["errors_last_minute"], 1);
}

}  // namespace
}  // namespace cnclab::harness
