// Logins of stations and instructors: passwords, seats, certificates, protocol versions (SEAT, SEC, exit codes of
// interfaces.md section 3).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/fake_server.hpp"
#include "harness/raw_client.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;
/// Classroom with a server whose instructor still has the one-time password.
struct FreshLab {
  TemporaryFolder folder;
  Passwords passwords;
  ServerProcess server = start();
  InstructorOptions options{.server = server.address(),
                            .fingerprint = server.fingerprint(),
                            .user = "lehrer",
                            .password_file = passwords.set("one-time", server.one_time_password().value()),
                            .new_password_file = {},
                            .state_folder = folder.path() / "state"};

  ServerProcess start() const {
    auto started =
        ServerProcess::start({.data = folder.path() / "data", .log = {}, .port = 0, .configuration = {}, .more = {}});
    if (!started) throw std::runtime_error(started.error().log);
    return std::move(*started);
  }
};

TEST(FirstLogin, SEC_002_a_one_time_password_opens_nothing_but_its_own_change) {
  FreshLab lab;
  const OneShot refused = Instructor(lab.options).run({"status"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, testing::StartsWith("error: "));
  EXPECT_EQ(refused.output, "");
}

TEST(FirstLogin, SEC_002_passwd_answers_the_forced_change_and_the_old_password_is_void) {
  FreshLab lab;
  InstructorOptions options = lab.options;
  options.new_password_file = lab.passwords.file_of("lehrer");
  const OneShot changed = Instructor(options).run({"passwd"});
  EXPECT_EQ(changed.exit_code, 0) << changed.errors;
  ASSERT_EQ(changed.objects.size(), 1U);
  EXPECT_EQ(changed.objects[0]["ok"], true);
  EXPECT_EQ(Instructor(lab.options).run({"status"}).exit_code, 1) << "the one-time password";
  options.password_file = options.new_password_file;
  options.new_password_file.clear();
  EXPECT_EQ(Instructor(options).run({"status"}).exit_code, 0);
}

TEST(FirstLogin, SEC_002_a_weak_new_password_is_refused_and_the_old_one_stays) {
  FreshLab lab;
  InstructorOptions options = lab.options;
  options.new_password_file = lab.passwords.set("weak", "kurz");
  EXPECT_EQ(Instructor(options).run({"passwd"}).exit_code, 1);
  options.new_password_file = lab.passwords.file_of("lehrer");
  EXPECT_EQ(Instructor(options).run({"passwd"}).exit_code, 0);
}

TEST(FirstLogin, SEC_002_a_forced_change_to_the_same_password_is_refused) {
  Classroom room;
  const auto file = room.passwords().file_of("anna");
  room.instructor().must({"student", "add", "anna", "--password-file", file.string(), "--must-change"});
  StationOptions options = room.station_options(1, "anna");
  options.password_file = file;
  options.new_password_file = file;
  EXPECT_EQ(StationProcess(options).wait(kLimit), 4);
  options.new_password_file = room.passwords().set("anna.new", "ein anderes Passwort");
  StationProcess anna(options);
  anna.wait_for("CNC 3300");
}

TEST(FirstLogin, SEC_002_a_student_without_a_given_password_must_change_the_printed_one) {
  Classroom room;
  const OneShot added = room.instructor().must({"student", "add", "anna"});
  ASSERT_EQ(added.objects.size(), 1U);
  EXPECT_EQ(added.objects[0]["name"], "anna");
  Passwords one_time;
  StationOptions options = room.station_options(1, "anna");
  options.password_file = one_time.set("anna", added.objects[0]["password"]);
  EXPECT_EQ(StationProcess(options).wait(kLimit), 4) << "without a new password";
  options.new_password_file = room.passwords().file_of("anna");
  StationProcess(options).wait_for("CNC 3300");
  StationProcess again = room.seat(1, "anna");
  again.quit();
}

TEST(Login, SEC_003_a_wrong_password_and_an_unknown_name_get_the_same_answer_and_exit_code_4) {
  Classroom room;
  room.add_student("anna");
  RawClient client(room.server().port());
  ASSERT_TRUE(client.greet(v1::CLIENT_KIND_STATION));
  const auto wrong = client.log_in("anna", "not the password", 1);
  const auto unknown = client.log_in("nobody", "not the password", 1);
  ASSERT_TRUE(wrong && unknown);
  EXPECT_EQ(wrong->result(), v1::LOGIN_RESULT_REFUSED);
  EXPECT_EQ(unknown->result(), v1::LOGIN_RESULT_REFUSED);
  EXPECT_EQ(wrong->text(), unknown->text());
  StationOptions options = room.station_options(1, "anna");
  options.password_file = room.passwords().set("wrong", "also wrong");
  EXPECT_EQ(StationProcess(options).wait(kLimit), 4);
}

class DelayedLogin : public testing::TestWithParam<std::string> {};

TEST_P(DelayedLogin, SEC_003_after_five_wrong_passwords_the_name_has_to_wait_at_most_30_s) {
  Classroom room;
  room.add_student("anna");
  RawClient client(room.server().port());
  ASSERT_TRUE(client.greet(v1::CLIENT_KIND_STATION));
  constexpr int kFree = 5;
  for (int attempt = 1; attempt <= kFree; ++attempt) {
    const auto answer = client.log_in(GetParam(), "wrong number " + std::to_string(attempt), 1);
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->result(), v1::LOGIN_RESULT_REFUSED) << attempt;
  }
  const auto delayed = client.log_in(GetParam(), room.passwords().password_of("anna"), 1);
  ASSERT_TRUE(delayed);
  EXPECT_EQ(delayed->result(), v1::LOGIN_RESULT_WAIT);
  EXPECT_GE(delayed->wait_seconds(), 1U);
  EXPECT_LE(delayed->wait_seconds(), 30U);
}

INSTANTIATE_TEST_SUITE_P(known_and_unknown_names, DelayedLogin, testing::Values("anna", "nobody"));

TEST(Seats, SEAT_001_a_taken_seat_ends_the_second_station_with_7_and_names_who_sits_there) {
  Classroom room;
  room.add_student("anna");
  room.add_student("otto");
  StationProcess anna = room.seat(1, "anna");
  StationOptions options = room.station_options(1, "otto");
  options.log = room.folder().path() / "otto.log";
  EXPECT_EQ(StationProcess(options).wait(kLimit), 7);
  EXPECT_THAT(read_file(options.log), HasSubstr("anna"));
  anna.key("MENU");
}

TEST(Seats, SEAT_001_station_0_and_16_are_usage_errors) {
  Classroom room;
  room.add_student("anna");
  for (const int station : {16, -1, 100}) {
    EXPECT_EQ(StationProcess(room.station_options(station, "anna")).wait(kLimit), 2) << station;
  }
}

TEST(Seats, SEAT_003_the_same_student_elsewhere_is_refused_without_take_over) {
  Classroom room;
  room.add_student("anna");
  StationProcess first = room.seat(1, "anna");
  EXPECT_EQ(StationProcess(room.station_options(2, "anna")).wait(kLimit), 4);
  first.key("MENU");
}

TEST(Seats, SEAT_003_take_over_ends_the_first_station_with_6_and_continues_its_screen) {
  Classroom room;
  room.add_student("anna");
  StationProcess first = room.seat(1, "anna");
  first.key("EINGABE");
  first.wait_for("EINGABEMODUS");
  StationOptions options = room.station_options(2, "anna");
  options.more = {"--take-over"};
  StationProcess second(options);
  second.wait_for("EINGABEMODUS");
  EXPECT_EQ(first.wait(kLimit), 6);
}

TEST(Seats, SEAT_003_a_station_whose_line_was_broken_ends_with_6_when_its_student_has_sat_down_elsewhere) {
  Classroom room;
  room.add_student("anna");
  TcpProxy line(room.server().port());
  StationProcess first = room.seat_behind(line, 1, "anna");
  line.cut();
  ASSERT_TRUE(eventually(kLimit, [&] { return room.instructor().station(1)["connected"] == false; }));
  StationProcess second = room.seat(2, "anna");
  line.mend();
  EXPECT_EQ(first.wait(kLimit), 6);
  second.key("MENU");
}

TEST(Seats, SEC_004_looking_on_ends_with_the_login_that_is_looked_at) {
  Classroom room;
  room.add_student("anna");
  room.add_student("otto");
  StationProcess first = room.seat(1, "anna");
  StationOptions options = room.station_options(2, "anna");
  options.more = {"--look-on"};
  StationProcess looker(options);
  looker.wait_for("anna");
  first.quit();
  EXPECT_EQ(looker.wait(kLimit), 0);
}

TEST(Seats, SEAT_002_logging_out_and_in_at_another_station_finds_the_own_control_as_it_was) {
  Classroom room;
  room.add_student("anna", {"P0012\nN001G00X+1000\n"});
  {
    StationProcess first = room.seat(1, "anna");
    first.key("EINGABE CLEAR");
    first.type("12");
    first.key("ENTER");
    first.wait_for("N001 G00 X+...1.000");
    first.quit();
  }
  StationProcess second = room.seat(9, "anna");
  second.wait_for("EINGABEMODUS");
  second.wait_for("N001 G00 X+...1.000");
  second.wait_for("Platz 09");
}

TEST(Certificate, SEC_001_another_fingerprint_ends_station_and_instructor_with_5) {
  Classroom room;
  room.add_student("anna");
  const std::string other = "SHA256:" + std::string(43, 'A');
  StationOptions options = room.station_options(1, "anna");
  options.fingerprint = other;
  EXPECT_EQ(StationProcess(options).wait(kLimit), 5);
  Instructor instructor = room.instructor();
  instructor.options().fingerprint = other;
  EXPECT_EQ(instructor.run({"status"}).exit_code, 1);
}

TEST(Certificate, SEC_001_the_first_connection_pins_and_a_changed_certificate_ends_with_5) {
  auto first = std::make_unique<FakeServer>();
  const TemporaryFolder folder;
  Passwords passwords;
  StationOptions options{.server = first->address(),
                         .fingerprint = {},
                         .station = 1,
                         .user = "anna",
                         .password_file = passwords.file_of("anna"),
                         .new_password_file = {},
                         .state_folder = folder.path() / "state",
                         .log = folder.path() / "station.log",
                         .more = {}};
  EXPECT_EQ(StationProcess(options).wait(kLimit), 8) << "pinned, then the foreign version";
  EXPECT_EQ(StationProcess(options).wait(kLimit), 8) << "known now";
  const std::uint16_t port = first->port();
  first.reset();
  const FakeServer other(port);
  EXPECT_EQ(StationProcess(options).wait(kLimit), 5) << read_file(options.log);
}

TEST(ProtocolVersion, a_foreign_version_is_answered_with_the_supported_ones_and_the_line_ends) {
  Classroom room;
  RawClient client(room.server().port());
  const auto welcome = client.greet(v1::CLIENT_KIND_STATION, 99);
  ASSERT_TRUE(welcome);
  EXPECT_FALSE(welcome->accepted());
  EXPECT_THAT(welcome->versions(), testing::ElementsAre(1U));
  EXPECT_NE(welcome->text(), "");
  EXPECT_TRUE(client.is_closed_within(5s));
}

TEST(ProtocolVersion, a_server_of_another_version_ends_station_and_instructor_with_8) {
  FakeServer server;
  const TemporaryFolder folder;
  Passwords passwords;
  const StationOptions options{.server = server.address(),
                               .fingerprint = server.fingerprint(),
                               .station = 1,
                               .user = "anna",
                               .password_file = passwords.file_of("anna"),
                               .new_password_file = {},
                               .state_folder = folder.path(),
                               .log = {},
                               .more = {}};
  EXPECT_EQ(StationProcess(options).wait(kLimit), 8);
  const Instructor instructor({.server = server.address(),
                               .fingerprint = server.fingerprint(),
                               .user = "lehrer",
                               .password_file = passwords.file_of("lehrer"),
                               .new_password_file = {},
                               .state_folder = folder.path()});
  EXPECT_EQ(instructor.run({"status"}).exit_code, 1);
}

TEST(Connection, no_server_ends_station_and_instructor_with_3) {
  Classroom room;
  room.add_student("anna");
  const StationOptions options = room.station_options(1, "anna");
  room.server().kill_hard();
  EXPECT_EQ(StationProcess(options).wait(kLimit), 3);
  EXPECT_EQ(room.instructor().run({"status"}).exit_code, 1);
}

}  // namespace
}  // namespace cnclab::harness
