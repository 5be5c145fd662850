// How the server starts, refuses to start, and ends (interfaces.md section 2, STO-008, AUTH-012).
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr auto kPromisedEnd = 5s;  // what the server promises
const std::string kEndlessWay = "P0001\nN001G01X+100000F3000\nN002G01X-100000\nN003G20P0001N001\n";

/// A database in a data folder, after a clean end of its server.
fs::path database_after_a_lesson(Classroom& room) {
  room.server().terminate();
  EXPECT_EQ(room.server().wait(kPromisedEnd), 0);
  return room.data() / "cnclab.db";
}

StartFailure start_again(Classroom& room) {
  const fs::path log = room.folder().path() / "second.log";
  auto started = ServerProcess::start({.data = room.data(), .log = log, .port = 0, .configuration = {}, .more = {}});
  if (started) throw std::runtime_error("the server started");
  return started.error();
}

TEST(ServerStart, SEC_002_only_the_first_start_prints_a_one_time_password) {
  Classroom room;
  EXPECT_TRUE(room.server().one_time_password());
  EXPECT_THAT(room.server().fingerprint(), testing::StartsWith("SHA256:"));
  room.crash_and_restart();
  EXPECT_FALSE(room.server().one_time_password());
}

TEST(ServerStart, SEC_001_the_certificate_stays_the_same_over_restarts) {
  Classroom room;
  const std::string before = room.server().fingerprint();
  room.crash_and_restart();
  EXPECT_EQ(room.server().fingerprint(), before);
}

TEST(ServerStart, AUTH_012_after_a_start_nobody_has_control_and_the_position_is_unreferenced) {
  Classroom room;
  const auto status = room.instructor().status();
  EXPECT_EQ(status["selected"], 0);
  EXPECT_EQ(status["offered"], 0);
  EXPECT_EQ(status["machine"]["state"], "standstill");
  EXPECT_EQ(status["machine"]["referenced"], false);
}

TEST(ServerStart, a_port_in_use_is_told_with_the_remedy) {
  Classroom room;
  const TemporaryFolder folder;
  const auto second = ServerProcess::start(
      {.data = folder.path() / "data", .log = {}, .port = room.server().port(), .configuration = {}, .more = {}});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().exit_code, 1);
  EXPECT_THAT(second.error().log, HasSubstr(std::to_string(room.server().port())));
  EXPECT_THAT(second.error().log, HasSubstr("--listen"));
  EXPECT_EQ(room.instructor().status()["selected"], 0) << "the first server goes on";
}

TEST(ServerStart, a_port_of_the_configuration_in_use_names_its_own_setting) {
  Classroom room;
  struct Row {
    const char* section;
    const char* key;
  };
  for (const auto& [section, key] : {Row{"dnc", "listen"}, Row{"server", "metrics"}}) {
    const TemporaryFolder folder;
    const std::string configuration =
        std::string("[") + section + "]\n" + key + " = \"" + room.server().address() + "\"\n";
    const auto second = ServerProcess::start(
        {.data = folder.path() / "data", .log = {}, .port = 0, .configuration = configuration, .more = {}});
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().exit_code, 1);
    EXPECT_THAT(second.error().log, HasSubstr(std::string("[") + section + "] " + key + " in lab.toml"));
    EXPECT_THAT(second.error().log, testing::Not(HasSubstr("--listen")));
  }
}

TEST(ServerStart, a_configuration_that_is_none_is_refused) {
  using namespace std::string_literals;
  const std::pair<std::string, std::string> rows[] = {
      {"[\0\0\0la\0 nknown ; 1\n"s, "NUL"},
      {"\n[?lab]\n", "lab.toml:2:"},
      {"# für alle\n[lab]\naccept = „true“\n", "lab.toml:3: letters beyond a-z"},
      {"[server]\ndata = '/srv/übung'\n", "lab.toml:2: letters beyond a-z need double"},
      {"[server]\ndata = \"/srv/\xFC\"\n", "lab.toml:2: this letter is no UTF-8"},
      {"[lab]\nlanguage = \"\"\"de\"\"\"\n", "lab.toml:2: a text stands on one line"},
      {"[server]\n\nlisten = \"localhost:3300\"\n", "lab.toml:3: 'listen' must be an address and a port"},
      {"[server]\nmetrics = \"9100\"\n", "lab.toml:2: 'metrics' must be an address and a port"},
      {"[dnc]\nlisten = \"127.0.0.1\"\n", "lab.toml:2: 'listen' must be an address and a port"},
      {"[dnc]\ndevice = \"/dev/ttyUSB0\"\n", "lab.toml:2: 'device' needs 'station'"},
      {"[lab]\nsilence_manual_ms = 50\n", "lab.toml:2: 'silence_manual_ms' must be a number from 100 to 300"},
      {"[workpiece]\nsize_mm = [1001, 80, 30]\n", "lab.toml:2: 'size_mm' must be three lengths from 1 to 1000 mm"},
  };
  for (const auto& [configuration, expected] : rows) {
    const TemporaryFolder folder;
    const auto started = ServerProcess::start(
        {.data = folder.path() / "data", .log = {}, .port = 0, .configuration = configuration, .more = {}});
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().exit_code, 1);
    EXPECT_THAT(started.error().log, HasSubstr(expected));
  }
}

TEST(ServerStart, a_data_folder_that_cannot_be_made_is_told_with_the_remedy) {
  const TemporaryFolder folder;
  const auto file = folder.write("file", "not a folder");
  const auto started = ServerProcess::start(
      {.data = file / "data", .log = folder.path() / "log", .port = 0, .configuration = {}, .more = {}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().exit_code, 1);
  EXPECT_THAT(started.error().log, HasSubstr((file / "data").string()));
  EXPECT_THAT(started.error().log, HasSubstr("--data"));
}

TEST(ServerStart, a_data_folder_that_is_not_writable_is_told_with_the_remedy) {
  const TemporaryFolder folder;
  const fs::path data = "/proc/self";  // not even root may write there
  const auto started =
      ServerProcess::start({.data = data, .log = folder.path() / "log", .port = 0, .configuration = {}, .more = {}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().exit_code, 1);
  EXPECT_THAT(started.error().log, HasSubstr("/proc/self"));
  EXPECT_THAT(started.error().log, HasSubstr("--data"));
}

TEST(ServerStart, slips_of_the_pen_are_told_with_the_remedy_and_make_nothing) {
  struct Row {
    const char* name;
    std::vector<std::string> arguments;
    const char *told, *remedy;
  };
  const Row rows[] = {
      {"address of another computer", {"--listen", "192.0.2.1:0"}, "does not have that address", "--listen"},
      {"no configuration", {"--config", "/nowhere/lab.toml"}, "/nowhere/lab.toml", "--print-config"},
      {"no lab there", {"--new-instructor-password"}, "there is no lab in", "--data DIR"}};
  for (const Row& row : rows) {
    const TemporaryFolder folder;
    const fs::path data = folder.path() / "TYPO", log = folder.path() / "log";
    std::vector<std::string> arguments{"--data", data.string()};
    arguments.insert(arguments.end(), row.arguments.begin(), row.arguments.end());
    ChildProcess server({.program = programs_folder() / "cnclab-server",
                         .arguments = arguments,
                         .environment = {},
                         .stderr_file = log});
    EXPECT_EQ(server.wait(kLimit), 1) << row.name;
    std::ostringstream said;
    said << std::ifstream(log).rdbuf();
    EXPECT_THAT(said.str(), HasSubstr(row.told)) << row.name;
    EXPECT_THAT(said.str(), HasSubstr(row.remedy)) << row.name;
    const bool is_begun = row.arguments.front() == "--listen";  // its password is shown before anything can fail
    EXPECT_EQ(fs::exists(data), is_begun) << row.name;
  }
}

TEST(ServerStart, STO_008_a_damaged_database_is_refused_and_left_untouched) {
  Classroom room;
  const fs::path database = database_after_a_lesson(room);
  constexpr std::streamoff kFirstPageHeader = 100;
  {
    std::fstream stream(database, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(kFirstPageHeader);
    stream << std::string(20'000, '\xA5');
  }
  const std::string before = read_file(database);
  const StartFailure failure = start_again(room);
  EXPECT_EQ(failure.exit_code, 1);
  EXPECT_THAT(failure.log, HasSubstr(database.string()));
  EXPECT_THAT(failure.log, HasSubstr("--restore"));
  EXPECT_EQ(read_file(database), before);
}

TEST(ServerStart, STO_008_a_database_cut_off_to_nothing_is_no_new_lab) {
  Classroom room;
  const fs::path database = database_after_a_lesson(room);
  fs::resize_file(database, 0);
  const StartFailure failure = start_again(room);
  EXPECT_EQ(failure.exit_code, 1);
  EXPECT_THAT(failure.log, HasSubstr("is empty"));
  EXPECT_EQ(fs::file_size(database), 0U);
}

TEST(ServerStart, STO_008_a_file_that_is_no_database_is_refused_and_left_untouched) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "data");
  const auto file = folder.write("data/cnclab.db", std::string(5'000, 'x'));
  const auto started =
      ServerProcess::start({.data = folder.path() / "data", .log = {}, .port = 0, .configuration = {}, .more = {}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().exit_code, 1);
  EXPECT_EQ(read_file(file), std::string(5'000, 'x'));
}

TEST(ServerStart, STO_008_a_database_of_a_newer_version_is_refused_and_left_untouched) {
  Classroom room;
  const fs::path database = database_after_a_lesson(room);
  constexpr std::streamoff kUserVersion = 60;  // big-endian in SQLite's file header: the schema's number
  {
    std::fstream stream(database, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(kUserVersion);
    stream << std::string("\0\0\x03\xE7", 4);
  }
  const std::string before = read_file(database);
  const StartFailure failure = start_again(room);
  EXPECT_EQ(failure.exit_code, 1);
  EXPECT_THAT(failure.log, HasSubstr("999"));
  EXPECT_EQ(read_file(database), before);
}

TEST(ServerEnd, SIGTERM_ends_an_idle_lab_with_0_within_5_s_and_the_stations_with_10) {
  Classroom room;
  room.add_student("anna");
  StationProcess anna = room.seat(1, "anna");
  room.server().terminate();
  EXPECT_EQ(room.server().wait(kPromisedEnd), 0);
  EXPECT_EQ(anna.wait(kPromisedEnd), 10);
}

TEST(ServerEnd, SIGINT_is_a_clean_end_too) {
  Classroom room;
  kill(room.server().pid(), SIGINT);
  EXPECT_EQ(room.server().wait(kPromisedEnd), 0);
}

TEST(ServerEnd, SIGTERM_stops_a_moving_machine_and_ends_with_0_within_5_s) {
  Classroom room;
  room.add_student("anna", {kEndlessWay});
  StationProcess anna = room.seat(1, "anna");
  room.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(eventually(5s, [&] { return room.instructor().status()["machine"]["x"] > 1; }));
  room.server().terminate();
  EXPECT_EQ(room.server().wait(kPromisedEnd), 0);
}

TEST(ServerEnd, STO_002_what_was_acknowledged_before_SIGTERM_is_there_afterwards) {
  Classroom room;
  room.add_student("anna", {"P0007\nN001G00X+1000\n"});
  room.server().terminate();
  ASSERT_EQ(room.server().wait(kPromisedEnd), 0);
  room.crash_and_restart();
  EXPECT_EQ(room.instructor().must({"program", "show", "anna", "P0007"}).output, "P0007\nN001G00X+1000\n%\n");
}

/// The whole answer to one HTTP request on a loopback port.
std::string http(std::uint16_t port, const std::string& request) {
  const int line = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string answer;
  if (::connect(line, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::send(line, request.data(), request.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(request.size())) {
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::recv(line, part.data(), part.size(), 0)) > 0;)
      answer.append(part.data(), static_cast<std::size_t>(got));
  }
  ::close(line);
  return answer;
}

TEST(ServerStart, metrics_are_Prometheus_text_on_a_loopback_port_of_their_own) {
  Classroom room("[server]\nmetrics = \"127.0.0.1:0\"\n");
  const std::string log = room.server().log();
  const std::string head = "metrics: http://127.0.0.1:";
  const auto at = log.find(head);
  ASSERT_NE(at, std::string::npos) << log;
  const auto port = static_cast<std::uint16_t>(std::stoul(log.substr(at + head.size())));
  room.add_student("anna");
  StationProcess anna = room.seat(1, "anna");
  const std::string answer = http(port, "GET /metrics HTTP/1.1\r\nHost: lab\r\n\r\n");
  EXPECT_THAT(answer, testing::StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(answer, testing::HasSubstr("# TYPE cnclab_stations gauge\ncnclab_stations 1\n"));
  EXPECT_THAT(answer, testing::HasSubstr("\ncnclab_store_failures_total 0\n"));
  EXPECT_THAT(http(port, "GET / HTTP/1.1\r\n\r\n"), testing::StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(http(port, "POST /metrics HTTP/1.1\r\n\r\n"), testing::StartsWith("HTTP/1.1 405"));
  EXPECT_EQ(http(port, std::string(5000, 'x')).substr(0, 4), "") << "no end within 4 KiB: closed without an answer";
}

TEST(ServerStart, metrics_on_an_address_that_others_reach_are_refused) {
  const TemporaryFolder folder;
  const auto started = ServerProcess::start({.data = folder.path() / "data",
                                             .log = folder.path() / "log",
                                             .port = 0,
                                             .configuration = "[server]\nmetrics = \"0.0.0.0:0\"\n",
                                             .more = {}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().exit_code, 1);
  EXPECT_THAT(started.error().log, testing::HasSubstr("loopback"));
}

}  // namespace
}  // namespace cnclab::harness
