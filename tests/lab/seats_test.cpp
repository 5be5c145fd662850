// Seats whose line is broken, and what others see of them: nothing of another student's (SEC-004, SEAT-003, SEAT-004).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "keyboard_rig.hpp"

namespace cnclab::lab {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string all_rows(const Screen& screen) {
  std::string text;
  for (int row = 0; row < Screen::kRows; ++row) text += screen.text(row) + "\n";
  return text;
}

class SeatsOfALab : public testing::Test, protected KeyboardRig {
 protected:
  /// A second line of eva's, logged in at seat 2, that looks on at her control.
  Caller look_on() {
    Caller looker = call();
    log_in(looker, "eva", 2, "geheim123", v1::ELSEWHERE_LOOK_ON);
    return looker;
  }
  void log_out(Caller& caller) {
    v1::ClientMessage out;
    out.mutable_logout();
    lab().receive(caller.visit, out);
    std::erase(alive, &caller);
  }
  /// Her station's answer to what it is told when it comes back with its ticket.
  Caller come_back(const std::string& ticket) {
    Caller caller = call();
    v1::ClientMessage message;
    message.mutable_resume()->set_ticket(ticket);
    lab().receive(caller.visit, message);
    return caller;
  }
  void cut(Caller& caller) {
    lab().lost(caller.visit);
    std::erase(alive, &caller);
  }
  std::string at(std::uint32_t station, const std::function<v1::StationOnly*(v1::InstructorRequest&)>& what) {
    return order([&](auto& request) { what(request)->set_station(station); }).error();
  }
};

TEST_F(SeatsOfALab, SEC_004_who_looks_on_sees_the_own_control_and_nobody_else_who_sits_down_there) {
  Caller looker = look_on();
  alive.push_back(&looker);
  pass_ms(50);
  EXPECT_THAT(all_rows(looker.screen), HasSubstr("eva"));
  cut(eva);  // her control stays at seat 7, its line is broken
  Caller udo = call();
  log_in(udo, "udo", kSeat);
  alive.push_back(&udo);
  strike(udo, Key::EINGABE);
  pass_ms(1100);
  EXPECT_THAT(all_rows(looker.screen), Not(HasSubstr("udo")));
  EXPECT_THAT(all_rows(looker.screen), Not(HasSubstr("EINGABEMODUS")));
}

TEST_F(SeatsOfALab, SEC_004_looking_on_ends_when_the_control_leaves_its_seat) {
  for (const bool moves : {false, true}) {
    Caller looker = look_on();
    ASSERT_EQ(looker.visit->stage, Stage::looking_on);
    if (moves) {
      Caller elsewhere = call();
      log_in(elsewhere, "eva", 3, "geheim123", v1::ELSEWHERE_TAKE_OVER);
    } else {
      log_out(eva);
      eva = call();
      log_in(eva, "eva", kSeat);
    }
    EXPECT_EQ(looker.visit->stage, Stage::gone);
    ASSERT_TRUE(looker.peer->sent.back().has_bye());
    EXPECT_EQ(looker.peer->sent.back().bye().exit_code(), 0U);
  }
}

TEST_F(SeatsOfALab, SEC_004_a_message_for_a_seat_reaches_who_sits_there_alone) {
  const std::string ticket = eva.visit->desk->ticket;
  cut(eva);
  Caller udo = call();
  log_in(udo, "udo", kSeat);
  v1::InstructorRequest request;
  request.mutable_message()->set_station(kSeat);
  request.mutable_message()->set_text("nur für udo");
  ASSERT_EQ(ask(console, request).error(), "");
  EXPECT_EQ(udo.visit->desk->messages.size(), 1U);
  log_out(udo);
  const Caller back = come_back(ticket);
  EXPECT_TRUE(back.visit->desk->messages.empty());
}

TEST_F(SeatsOfALab, SEAT_004_a_raised_hand_survives_a_cut_line_in_its_place) {
  Caller udo = call();
  log_in(udo, "udo", 2);
  strike(eva, Key::MELDUNG);
  strike(udo, Key::MELDUNG);
  const std::string ticket = eva.visit->desk->ticket;
  cut(eva);
  const Caller back = come_back(ticket);
  ASSERT_EQ(back.visit->stage, Stage::at_desk);
  const v1::Status now = status();
  for (const auto& station : now.stations())
    EXPECT_EQ(station.meldung(), station.user() == "eva" ? 1U : 2U) << station.user();
  log_out(udo);
  Caller again = call();
  log_in(again, "udo", 2);
  const v1::Status later = status();
  for (const auto& station : later.stations())
    EXPECT_EQ(station.meldung(), station.user() == "eva" ? 1U : 0U) << "a log-out lowers it: " << station.user();
}

TEST_F(SeatsOfALab, SEC_007_a_keyboard_is_locked_while_its_line_is_broken) {
  const std::string ticket = eva.visit->desk->ticket;
  cut(eva);
  EXPECT_EQ(at(kSeat, [](auto& request) { return request.mutable_lock(); }), "");
  Caller back = come_back(ticket);
  strike(back, Key::EINGABE);
  EXPECT_THAT(all_rows(back.screen), Not(HasSubstr("EINGABEMODUS")));
  EXPECT_THAT(back.screen.text(18), HasSubstr("gesperrt"));
}

TEST_F(SeatsOfALab, SEC_007_who_is_expelled_while_the_line_is_broken_is_told_when_it_is_back) {
  const std::string ticket = eva.visit->desk->ticket;
  cut(eva);
  EXPECT_EQ(at(kSeat, [](auto& request) { return request.mutable_expel(); }), "");
  EXPECT_EQ(status().stations_size(), 0);
  const Caller back = come_back(ticket);
  ASSERT_TRUE(back.peer->sent.back().has_bye());
  EXPECT_EQ(back.peer->sent.back().bye().exit_code(), 9U);
}

TEST_F(SeatsOfALab, SEC_007_what_is_ordered_for_a_seat_is_for_who_sits_there_now) {
  cut(eva);
  Caller udo = call();
  log_in(udo, "udo", kSeat);
  EXPECT_EQ(at(kSeat, [](auto& request) { return request.mutable_lock(); }), "");
  EXPECT_TRUE(udo.visit->desk->is_locked);
}

TEST_F(SeatsOfALab, INS_004_a_language_set_while_the_control_was_kept_holds_from_the_next_login_on) {
  cut(eva);
  const auto set = order([](auto& request) {
    request.mutable_student_set()->set_name("eva");
    request.mutable_student_set()->set_language("en");
  });
  ASSERT_EQ(set.error(), "");
  Caller again = call();
  log_in(again, "eva", kSeat);
  alive.push_back(&again);
  EXPECT_EQ(again.login()->language(), "en");
  pass_ms(100);
  EXPECT_THAT(again.screen.text(0), HasSubstr("Station 07"));
}

TEST_F(SeatsOfALab, AUTH_006_clearing_a_halt_that_nobody_pressed_says_so) {
  const auto clear = [&] { return order([](auto& request) { request.mutable_clear_halt(); }).items(0).done(); };
  EXPECT_EQ(clear().detail(), "Es war kein Halt gedrückt.");
  static_cast<void>(order([](auto& request) { request.mutable_halt(); }));
  EXPECT_EQ(clear().detail(), "");
  EXPECT_EQ(status().halted_by(), "");
}

TEST_F(SeatsOfALab, INS_003_a_fault_of_a_sent_file_names_its_line_and_a_place_only_where_there_is_one) {
  const auto fault = [&](const std::string& tape) {
    return order([&](auto& request) {
             request.mutable_program_send()->set_tape(tape);
             request.mutable_program_send()->set_all(true);
           })
        .error();
  };
  EXPECT_THAT(fault("g01\n"), testing::StartsWith("1: Kleinbuchstabe"));
  EXPECT_THAT(fault("P0001\nN001G01X+\n%"), testing::StartsWith("2: P0001 N001: "));
}

}  // namespace
}  // namespace cnclab::lab
