// Roles: what a student asks for beyond the own data is refused, whatever the client (SEC-004, SEAT-006).
#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/raw_client.hpp"

namespace cnclab::harness {
namespace {

/// Every request there is, about otto where it is about somebody.
std::vector<v1::InstructorRequest> all_requests() {
  std::vector<v1::InstructorRequest> requests;
  const auto* choice = v1::InstructorRequest::descriptor()->FindOneofByName("what");
  for (int i = 0; i < choice->field_count(); ++i) {
    v1::InstructorRequest request;
    request.set_number(static_cast<std::uint64_t>(i) + 1);
    auto* content = request.GetReflection()->MutableMessage(&request, choice->field(i));
    for (const char* name : {"name", "student"}) {
      const auto* field = content->GetDescriptor()->FindFieldByName(name);
      if (field != nullptr) content->GetReflection()->SetString(content, field, "otto");
    }
    for (const char* name : {"station", "program", "run"}) {
      const auto* field = content->GetDescriptor()->FindFieldByName(name);
      if (field == nullptr) continue;
      if (field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_UINT32) {
        content->GetReflection()->SetUInt32(content, field, 1);
      } else {
        content->GetReflection()->SetUInt64(content, field, 1);
      }
    }
    requests.push_back(request);
  }
  return requests;
}

class Rights : public testing::Test {
 protected:
  Rights() {
    room_.add_student("anna", {"P0001\nN001G00X+1000\n"});
    room_.add_student("otto", {"P0001\nN001G00X+2000\n"});
  }

  /// A client of our own that has logged in as anna.
  std::unique_ptr<RawClient> anna_logged_in() {
    auto client = std::make_unique<RawClient>(room_.server().port());
    if (!client->greet(v1::CLIENT_KIND_STATION)) throw std::runtime_error("no Welcome");
    const auto answer = client->log_in("anna", room_.passwords().password_of("anna"), 1);
    if (!answer || answer->result() != v1::LOGIN_RESULT_OK) throw std::runtime_error("no login");
    return client;
  }

  Classroom room_;
};

TEST_F(Rights, SEC_004_a_student_is_refused_every_request_of_an_instructor) {
  auto client = anna_logged_in();
  for (const auto& request : all_requests()) {
    v1::ClientMessage message;
    *message.mutable_request() = request;
    client->send(message);
    const auto answer = client->read_until(v1::ServerMessage::kAnswer);
    if (!answer) {  // the line was ended instead: that is a refusal too
      client = anna_logged_in();
      continue;
    }
    EXPECT_NE(answer->answer().error(), "") << request.ShortDebugString();
    EXPECT_EQ(answer->answer().items_size(), 0) << request.ShortDebugString();
    EXPECT_EQ(answer->answer().transfer(), 0U) << request.ShortDebugString();
  }
  const auto status = room_.instructor().status();
  EXPECT_EQ(status["selected"], 0);
  EXPECT_EQ(status["offered"], 0);
  EXPECT_EQ(status["machine"]["state"], "standstill");
  EXPECT_EQ(room_.instructor().must({"program", "show", "otto", "P0001"}).output, "P0001\nN001G00X+2000\n%\n");
  EXPECT_EQ(room_.instructor().must({"students"}).objects.size(), 3U);
}

TEST_F(Rights, SEC_004_a_student_cannot_log_in_as_an_instructors_console) {
  RawClient client(room_.server().port());
  ASSERT_TRUE(client.greet(v1::CLIENT_KIND_INSTRUCTOR));
  const auto answer = client.log_in("anna", room_.passwords().password_of("anna"), 0);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->result(), v1::LOGIN_RESULT_NOT_ALLOWED);
  Instructor pretender = room_.instructor();
  pretender.options().user = "anna";
  pretender.options().password_file = room_.passwords().file_of("anna");
  EXPECT_EQ(pretender.run({"students"}).exit_code, 1);
}

TEST_F(Rights, SEAT_006_a_student_cannot_observe_another) {
  StationProcess otto = room_.seat(2, "otto");
  RawClient client(room_.server().port());
  ASSERT_TRUE(client.greet(v1::CLIENT_KIND_OBSERVER));
  const auto answer = client.log_in("anna", room_.passwords().password_of("anna"), 2);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->result(), v1::LOGIN_RESULT_NOT_ALLOWED);
}

TEST_F(Rights, SEAT_006_an_observer_sees_the_screen_and_can_do_nothing) {
  room_.instructor().must(
      {"student", "add", "gast", "--role", "observer", "--password-file", room_.passwords().file_of("gast").string()});
  StationProcess otto = room_.seat(2, "otto");
  otto.key("EINGABE");
  StationOptions options = room_.station_options(0, "gast");
  options.more = {"--observe", "2"};
  StationProcess guest(options);
  guest.wait_for("EINGABEMODUS");
  EXPECT_THAT(guest.send("key MENU").value_or("ended"), testing::StartsWith("error"));
  EXPECT_TRUE(otto.shows("EINGABEMODUS"));
}

TEST_F(Rights, SEAT_006_an_observer_of_an_empty_seat_is_told_so_until_somebody_comes) {
  room_.instructor().must(
      {"student", "add", "gast", "--role", "observer", "--password-file", room_.passwords().file_of("gast").string()});
  StationOptions options = room_.station_options(0, "gast");
  options.more = {"--observe", "2"};
  StationProcess guest(options);
  EXPECT_EQ(guest.screen().size(), 24U);
  guest.wait_for("An Platz 2 ist niemand angemeldet.");
  StationProcess otto = room_.seat(2, "otto");
  guest.wait_for("CNC 3300");
  otto.quit();
  guest.wait_for("An Platz 2 ist niemand angemeldet.");
  guest.quit();
}

TEST_F(Rights, INS_004_a_removed_student_cannot_log_in_until_restored_with_all_programs) {
  room_.instructor().must({"student", "remove", "otto"});
  EXPECT_EQ(StationProcess(room_.station_options(2, "otto")).wait(10s), 4);
  room_.instructor().must({"student", "restore", "otto"});
  StationProcess otto = room_.seat(2, "otto");
  EXPECT_EQ(room_.instructor().must({"program", "show", "otto", "P0001"}).output, "P0001\nN001G00X+2000\n%\n");
}

TEST_F(Rights, INS_007_an_instructor_may_sit_at_a_station_and_select_it) {
  StationProcess teacher = room_.seat(15, "lehrer");
  room_.give_machine(15, teacher);
  EXPECT_EQ(room_.instructor().station(15)["role"], "instructor");
}

}  // namespace
}  // namespace cnclab::harness
