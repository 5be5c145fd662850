// Command lines become requests: every command of the interface description, section 4 (INS-005).
#include "instructor/command_line.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace cnclab::instructor {
namespace {

struct CommandRow {
  std::string name;
  std::vector<std::string> arguments;
  std::string request;  ///< text format
};

void PrintTo(const CommandRow& row, std::ostream* out) { *out << row.name; }

/// Two files that commands read; their paths are the same in every run of one test program.
std::string file_with(const std::string& name, const std::string& content) {
  const auto path =
      std::filesystem::path(testing::TempDir()) / ("cnclab-instructor-" + std::to_string(::getpid()) + "-" + name);
  std::ofstream(path, std::ios::binary) << content;
  return path.string();
}

std::string tape() { return file_with("tape", "P0001\nN001G00X+1000\n%\n"); }
std::string password() { return file_with("password", "geheim123\nsecond line\n"); }

class CommandTable : public testing::TestWithParam<CommandRow> {};

TEST_P(CommandTable, becomes_its_request) {
  const auto line = read_command_line(GetParam().arguments);
  ASSERT_TRUE(line) << line.error().text;
  ASSERT_TRUE(line->command);
  v1::InstructorRequest expected;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(GetParam().request, &expected));
  EXPECT_EQ(line->command->request.ShortDebugString(), expected.ShortDebugString());
}

/// The selector, the machine, the stations.
std::vector<CommandRow> machine_rows() {
  return {
      {"INS-005 status", {"status"}, "status{}"},
      {"AUTH-002 select", {"select", "7"}, "select{station:7}"},
      {"AUTH-004 select --force", {"select", "15", "--force"}, "select{station:15 force:true}"},
      {"AUTH-001 release", {"release"}, "release{}"},
      {"AUTH-004 release --force", {"release", "--force"}, "release{force:true}"},
      {"AUTH-006 halt", {"halt"}, "halt{}"},
      {"AUTH-006 clear-halt", {"clear-halt"}, "clear_halt{}"},
      {"AUTH-010 power-off", {"power-off"}, "power_off{}"},
      {"AUTH-010 power-on", {"power-on"}, "power_on{}"},
      {"input of the machine", {"input", "0", "on"}, "input{input:0 on:true}"},
      {"input of card 2", {"input", "28", "off"}, "input{input:28 on:false}"},
      {"EXT-060 remote", {"remote", "3", "on"}, "remote{station:3 on:true}"},
      {"ERR-034 ram-fault", {"ram-fault", "3", "on"}, "ram_fault{station:3 on:true}"},
      {"ERR-034 ram-fault off", {"ram-fault", "3", "off"}, "ram_fault{station:3}"},
      {"DEC-25 machine-data prints", {"machine-data"}, "machine_data{}"},
      {"DEC-25 machine-data changes",
       {"machine-data", "06=2500", "12=80"},
       "machine_data{data{number:6 value:2500} data{number:12 value:80}}"},
      {"DEC-29 tools prints", {"tools"}, "tools{}"},
      {"DEC-29 tools", {"tools", tape()}, R"(tools{tape:"P0001\nN001G00X+1000\n%\n"})"},
      {"DEC-24 workpiece prints", {"workpiece"}, "workpiece{print_only:true}"},
      {"DEC-24 workpiece", {"workpiece", "120", "80", "30.5"}, "workpiece{x:120 y:80 z:30.5}"},
      {"INS-002 message", {"message", "3", "Bitte", "warten"}, R"(message{station:3 text:"Bitte warten"})"},
      {"INS-002 message to all", {"message", "all", "Pause"}, R"(message{station:0 text:"Pause"})"},
      {"INS-002 show", {"show", "4"}, "show{station:4}"},
      {"INS-002 show off", {"show", "off"}, "show{station:0}"},
      {"INS-002 watch", {"watch", "4"}, "watch{station:4}"},
      {"INS-002 take", {"take", "4"}, "take{station:4}"},
      {"INS-002 give", {"give", "4"}, "give{station:4}"},
      {"SEC-007 lock", {"lock", "4"}, "lock{station:4}"},
      {"SEC-007 unlock", {"unlock", "4"}, "unlock{station:4}"},
      {"SEC-007 expel", {"expel", "4"}, "expel{station:4}"},
  };
}

/// People, their programs and records.
std::vector<CommandRow> people_rows() {
  return {
      {"INS-004 students", {"students"}, "students{}"},
      {"SEC-002 student add", {"student", "add", "anna"}, R"(student_add{name:"anna" role:"student"})"},
      {"INS-004 student add with everything",
       {"student", "add", "otto", "--password-file", password(), "--must-change", "--role", "observer", "--language",
        "en"},
       R"(student_add{name:"otto" password:"geheim123" must_change:true role:"observer" language:"en"})"},
      {"INS-004 student remove", {"student", "remove", "anna"}, R"(student_remove{name:"anna"})"},
      {"INS-004 student remove --erase",
       {"student", "remove", "anna", "--erase"},
       R"(student_remove{name:"anna" erase:true})"},
      {"INS-004 student restore", {"student", "restore", "anna"}, R"(student_restore{name:"anna"})"},
      {"DEC-08 student set",
       {"student", "set", "anna", "--model", "3250", "--language", "lab"},
       R"(student_set{name:"anna" model:"3250" language:"lab"})"},
      {"INS-004 student rename",
       {"student", "rename", "anna", "anne"},
       R"(student_rename{name:"anna" new_name:"anne"})"},
      {"INS-004 student password", {"student", "password", "anna"}, R"(student_password{name:"anna"})"},
      {"INS-004 import", {"import", tape()}, R"(import{csv:"P0001\nN001G00X+1000\n%\n"})"},
      {"INS-004 export", {"export", "/tmp/roster.csv"}, "export{}"},
      {"INS-003 programs", {"programs", "anna"}, R"(programs{name:"anna"})"},
      {"INS-003 program show", {"program", "show", "anna", "P0012"}, R"(program_show{student:"anna" program:12})"},
      {"STO-005 program show --version",
       {"program", "show", "anna", "P0001", "--version", "4"},
       R"(program_show{student:"anna" program:1 version:4})"},
      {"INS-003 program send",
       {"program", "send", tape(), "anna", "otto"},
       R"(program_send{tape:"P0001\nN001G00X+1000\n%\n" students:"anna" students:"otto"})"},
      {"INS-003 program send --all",
       {"program", "send", tape(), "--all", "--replace"},
       R"(program_send{tape:"P0001\nN001G00X+1000\n%\n" all:true replace:true})"},
      {"INS-003 program collect", {"program", "collect", "/tmp", "P0001"}, "program_collect{program:1 only_that:true}"},
      {"STO-005 program versions",
       {"program", "versions", "anna", "P0001"},
       R"(program_versions{student:"anna" program:1})"},
      {"STO-005 program restore",
       {"program", "restore", "anna", "P0001", "3"},
       R"(program_restore{student:"anna" program:1 version:3})"},
      {"STO-005 program restore of machine data",
       {"program", "restore", "anna", "MD", "3"},
       R"(program_restore{student:"anna" program:10000 version:3})"},
      {"STO-007 runs", {"runs", "anna"}, R"(runs{name:"anna"})"},
      {"STO-007 run trace", {"run", "trace", "12", "/tmp/trace.csv"}, "run_trace{run:12}"},
      {"STO-007 run replay", {"run", "replay", "12"}, "run_replay{run:12}"},
      {"STO-006 journal",
       {"journal", "anna", "--since", "2026-01-31"},
       R"(journal{student:"anna" since:"2026-01-31"})"},
      {"STO-008 backup", {"backup", "/tmp/backup.db"}, "backup{}"},
  };
}

INSTANTIATE_TEST_SUITE_P(INS_005_machine, CommandTable, testing::ValuesIn(machine_rows()));
INSTANTIATE_TEST_SUITE_P(INS_005_people, CommandTable, testing::ValuesIn(people_rows()));

TEST(CommandLine, INS_005_content_goes_to_the_named_file) {
  EXPECT_EQ(read_command_line({"run", "trace", "1", "/tmp/t.csv"})->command->content_file, "/tmp/t.csv");
  EXPECT_EQ(read_command_line({"backup", "/tmp/b.db"})->command->content_file, "/tmp/b.db");
  EXPECT_TRUE(read_command_line({"status"})->command->content_file.empty());
}

TEST(CommandLine, SEC_002_passwd_takes_the_new_password_from_a_file_before_or_after_the_command) {
  const auto file = password();
  for (const auto& arguments : {std::vector<std::string>{"passwd", "--new-password-file", file},
                                std::vector<std::string>{"--new-password-file", file, "passwd"}}) {
    const auto line = read_command_line(arguments);
    ASSERT_TRUE(line);
    EXPECT_TRUE(line->command->changes_own_password);
    EXPECT_EQ(line->access.new_password_file, file);
  }
}

TEST(CommandLine, connection_options_are_those_of_the_station) {
  const auto file = password();
  const auto line = read_command_line(
      {"--server", "[::1]:4711", "--user", "lehrer", "--password-file", file, "--fingerprint", "SHA256:abc", "status"});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->access.address.host, "::1");
  EXPECT_EQ(line->access.address.port, "4711");
  EXPECT_EQ(line->access.user, "lehrer");
  EXPECT_EQ(line->access.password_file, file);
  EXPECT_EQ(line->access.trust.fingerprint, "SHA256:abc");
}

TEST(CommandLine, without_a_command_it_is_the_console) {
  const auto line = read_command_line({"--server", "127.0.0.1:3300"});
  ASSERT_TRUE(line);
  EXPECT_FALSE(line->command);
}

TEST(CommandLine, help_is_no_error) {
  const auto line = read_command_line({"--help"});
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().exit_code, 0);
  EXPECT_THAT(line.error().text, testing::HasSubstr("clear-halt"));
}

struct BadRow {
  std::string name;
  std::vector<std::string> arguments;
  std::string told;  ///< part of the message
};

void PrintTo(const BadRow& row, std::ostream* out) { *out << row.name; }

class BadCommandLine : public testing::TestWithParam<BadRow> {};

TEST_P(BadCommandLine, is_an_error_and_says_what_is_wrong) {
  const auto line = read_command_line(GetParam().arguments);
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().exit_code, 1) << "interfaces.md section 4";
  EXPECT_THAT(line.error().text, testing::StartsWith("error: "));
  EXPECT_THAT(line.error().text, testing::HasSubstr(GetParam().told));
}

INSTANTIATE_TEST_SUITE_P(
    INS_005, BadCommandLine,
    testing::Values(BadRow{"SEAT-001 station 16", {"select", "16"}, "16"},
                    BadRow{"SEAT-001 station 0", {"select", "0"}, "0"}, BadRow{"no station", {"select"}, "select 1-15"},
                    BadRow{"unknown command", {"explode"}, "explode"}, BadRow{"no name", {"student", "add"}, "NAME"},
                    BadRow{"unknown role", {"student", "add", "a", "--role", "king"}, "king"},
                    BadRow{"input 9", {"input", "9", "on"}, "9"}, BadRow{"input ein", {"input", "0", "ein"}, "ein"},
                    BadRow{"missing file", {"program", "send", "/nowhere", "a"}, "/nowhere"},
                    BadRow{"nothing to set", {"student", "set", "anna"}, "--model"},
                    BadRow{"all and names", {"program", "send", tape(), "a", "--all"}, "all"},
                    BadRow{"program 12345", {"program", "show", "a", "12345"}, "12345"},
                    BadRow{"machine data are sent by no tape", {"program", "collect", "/tmp", "MD"}, "MD"},
                    BadRow{"half a datum", {"machine-data", "06="}, "06="},
                    BadRow{"huge datum", {"machine-data", "06=99999999999999999999"}, "06="},
                    BadRow{"two sizes", {"workpiece", "1", "2"}, "X Y Z"},
                    BadRow{"no text", {"message", "all"}, "TEXT"},
                    BadRow{"server without port", {"--server", "lab", "status"}, "HOST:PORT"}));

struct FaultRow {
  std::string typed, german, english;
};

void PrintTo(const FaultRow& row, std::ostream* out) { *out << row.typed; }

class FaultyEntry : public testing::TestWithParam<FaultRow> {};

TEST_P(FaultyEntry, is_explained_in_the_users_language) {
  const auto& row = GetParam();
  EXPECT_EQ(read_command(words_of(row.typed), station::Language::german).error(), row.german);
  EXPECT_EQ(read_command(words_of(row.typed), station::Language::english).error(), row.english);
}

INSTANTIATE_TEST_SUITE_P(
    INS_005, FaultyEntry,
    testing::Values(FaultRow{"bogus command", "Den Befehl „bogus“ gibt es nicht.", R"(There is no command "bogus".)"},
                    FaultRow{"select 16", "„16“ passt nicht zu 1-15. So: select 1-15 [--force]",
                             R"("16" does not fit 1-15. Usage: select 1-15 [--force])"},
                    FaultRow{"select", "Unvollständig oder widersprüchlich. So: select 1-15 [--force]",
                             "Incomplete or contradictory. Usage: select 1-15 [--force]"},
                    FaultRow{"halt now", "„now“ ist zu viel. So: halt", R"("now" is too much. Usage: halt)"},
                    FaultRow{"workpiece 1 2", "„1 2“ passt nicht zu X Y Z. So: workpiece [X Y Z]",
                             R"("1 2" does not fit X Y Z. Usage: workpiece [X Y Z])"},
                    FaultRow{"workpiece 1 2 breit", "„1 2 breit“ passt nicht zu X Y Z. So: workpiece [X Y Z]",
                             R"("1 2 breit" does not fit X Y Z. Usage: workpiece [X Y Z])"},
                    FaultRow{"program send /nowhere anna",
                             "Die Datei „/nowhere“ gibt es nicht. So: program send FILE [NAME…] [--all] [--replace]",
                             R"(There is no file "/nowhere". Usage: program send FILE [NAME…] [--all] [--replace])"},
                    FaultRow{"student",
                             "Unvollständig oder widersprüchlich. So: student add|set|remove|restore|rename|password",
                             "Incomplete or contradictory. Usage: student add|set|remove|restore|rename|password"},
                    FaultRow{"", "Einen Befehl eingeben, z. B. students.", "A command is needed, e.g. students."}));

TEST(CommandLine, INS_005_a_fault_of_a_connection_option_names_it_and_not_the_command) {
  setenv("LC_ALL", "de_DE.UTF-8", 1);
  EXPECT_EQ(read_command_line({"--password-file", "/nix", "status"}).error().text,
            "error: --password-file: Die Datei „/nix“ gibt es nicht.\n");
  EXPECT_EQ(read_command_line({"--bogus", "status"}).error().text, "error: „--bogus“ ist zu viel. So: status\n");
  EXPECT_THAT(read_command_line({"student", "add", "anna", "--password-file", "/nix"}).error().text,
              testing::StartsWith("error: --password-file: Die Datei „/nix“ gibt es nicht. So: student add NAME"));
  unsetenv("LC_ALL");
}

TEST(CommandLine, SEC_002_a_file_without_a_password_adds_nobody) {
  for (const char* const content : {"", "\n", "\r\nsecret\n"}) {
    const auto file = file_with("empty", content);
    const auto line = read_command_line({"student", "add", "anna", "--password-file", file});
    ASSERT_FALSE(line);
    EXPECT_THAT(line.error().text, testing::StartsWith("error: " + file + ": "));
  }
}

TEST(CommandLine, version_is_told_as_by_the_station) {
  const auto line = read_command_line({"--version"});
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().exit_code, 0);
  EXPECT_THAT(line.error().text, testing::StartsWith("cnclab-instructor "));
}

TEST(CommandLine, INS_005_files_that_are_not_UTF_8_are_refused_with_their_line) {
  const std::string latin1 = "anna\nm\xfcller\n";
  const auto file = file_with("latin1", latin1);
  for (const auto& arguments : {std::vector<std::string>{"import", file},
                                {"program", "send", file, "anna"},
                                {"tools", file},
                                {"student", "add", "anna", "--password-file", file}}) {
    const auto line = read_command_line(arguments);
    ASSERT_FALSE(line) << arguments.front();
    EXPECT_EQ(line.error().exit_code, 1);
    EXPECT_THAT(line.error().text, testing::StartsWith("error: " + file + ":2: ")) << arguments.front();
    EXPECT_THAT(line.error().text, testing::HasSubstr("UTF-8"));
  }
  EXPECT_THAT(read_command_line({"message", "all", "Gr\xfc\xdf Gott"}).error().text, testing::HasSubstr("UTF-8"));
  EXPECT_TRUE(read_command_line({"message", "all", "Grüß Gott"}));
}

TEST(CommandLine, INS_003_faults_in_a_sent_file_name_the_file) {
  const auto sent = read_command_line({"program", "send", tape(), "anna"});
  ASSERT_TRUE(sent && sent->command);
  EXPECT_EQ(with_sent_file(*sent->command, "3: P0001 N002: falsch"), tape() + ":3: P0001 N002: falsch");
  EXPECT_EQ(with_sent_file(*sent->command, "anna hat schon ein Programm"), "anna hat schon ein Programm");
  EXPECT_EQ(with_sent_file(*read_command_line({"status"})->command, "3: x"), "3: x");
}

TEST(ProgramNumber, BLK_007_has_up_to_four_digits_with_or_without_P) {
  EXPECT_EQ(program_number("P0001"), 1U);
  EXPECT_EQ(program_number("9999"), 9999U);
  EXPECT_EQ(program_number("P0000"), 0U);
  for (const auto* text : {"", "P", "P00001", "PX", "-1", "1.0"}) EXPECT_FALSE(program_number(text)) << text;
}

}  // namespace
}  // namespace cnclab::instructor
