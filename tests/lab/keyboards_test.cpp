// Keys of seats and consoles with time in our hands: what stops, who signs, who has the keys back (AUTH-006, AUTH-016).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "keyboard_rig.hpp"

namespace cnclab::lab {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class KeyboardsOfALab : public testing::Test, protected KeyboardRig {
 protected:
  /// The machine's tick has a thread of its own: the lab's time goes on until it has done what is asked for.
  template <class Condition>
  bool comes_true(Condition condition) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > limit) return false;
      pass_ms(11);
    }
    return true;
  }
  /// The next START is pressed in view of it (AUTH-008).
  [[nodiscard]] bool has_seen_rest() const { return eva.screen.text(18).find("Angehalten") != std::string::npos; }
  /// A START for each screen that shows another situation or asks for one more, until one counts.
  bool starts_again() {
    std::uint64_t pressed_for = 0;
    return comes_true([&] {
      if (is_running()) return !has_seen_rest();
      if (eva.state != pressed_for || eva.screen.text(18).find("zu spät") != std::string::npos) {
        pressed_for = eva.state;
        strike(eva, Key::START);
      }
      return false;
    });
  }
  bool is_running() { return status().stations(0).running(); }
  /// Keys going down together, then up, in view of the newest screen.
  void strike_together(Caller& caller, const std::vector<Key>& keys) {
    for (const bool pressed : {true, false}) {
      v1::ClientMessage message;
      auto& event = *message.mutable_key();
      event.set_number(++caller.number);
      for (const Key key : keys) event.add_keys(static_cast<v1::Key>(key));
      event.set_pressed(pressed);
      event.mutable_seen()->set_beat(caller.beat);
      event.mutable_seen()->set_state(caller.state);
      lab().receive(caller.visit, message);
    }
    look(caller);
  }
  /// The console sees the station's screen and has its keyboard.
  std::string take() {
    static_cast<void>(order([](auto& request) { request.mutable_watch()->set_station(kSeat); }));
    return order([](auto& request) { request.mutable_take()->set_station(kSeat); }).error();
  }
};

TEST_F(KeyboardsOfALab, AUTH_006_STOP_stops_whatever_is_held_with_it) {
  ASSERT_NO_FATAL_FAILURE(run_on_machine(eva));
  for (const std::vector<Key>& keys : {std::vector{Key::STOP, Key::D5}, std::vector{Key::D5, Key::STOP},
                                       std::vector{Key::PLUS_X, Key::ENTER, Key::STOP}}) {
    strike_together(eva, keys);
    ASSERT_TRUE(comes_true([&] { return has_seen_rest(); })) << eva.screen.text(18);
    ASSERT_TRUE(starts_again()) << eva.screen.text(18) << testing::PrintToString(journal_of("eva"));
  }
}

// A START that waits behind another key was pressed before the STOP that overtakes it.
TEST_F(KeyboardsOfALab, AUTH_006_no_START_that_was_pressed_before_STOP_acts_after_it) {
  ASSERT_NO_FATAL_FAILURE(run_on_machine(eva));
  strike(eva, Key::STOP);
  ASSERT_TRUE(comes_true([&] { return has_seen_rest(); })) << eva.screen.text(18);
  for (const Key key : {Key::START, Key::START, Key::STOP}) {
    v1::ClientMessage message;
    auto& event = *message.mutable_key();
    event.set_number(++eva.number);
    event.add_keys(static_cast<v1::Key>(key));
    event.set_pressed(true);
    event.mutable_seen()->set_beat(eva.beat);
    event.mutable_seen()->set_state(eva.state);
    lab().receive(eva.visit, message);
  }
  ASSERT_TRUE(comes_true([&] { return eva.handled == eva.number; }));
  pass_ms(200);
  EXPECT_FALSE(is_running());
}

TEST_F(KeyboardsOfALab, AUTH_006_MASCHINE_HALT_halts_whatever_is_held_with_it) {
  ASSERT_NO_FATAL_FAILURE(run_on_machine(eva));
  Caller udo = call();
  log_in(udo, "udo", 2);
  alive.push_back(&udo);
  pass_ms(50);
  for (const std::vector<Key>& keys :
       {std::vector{Key::MASCHINE_HALT, Key::D5}, std::vector{Key::D5, Key::MASCHINE_HALT},
        std::vector{Key::STOP, Key::MASCHINE_HALT}}) {
    strike_together(udo, keys);
    EXPECT_EQ(status().halted_by(), "Platz 2, udo");
    strike(udo, Key::MASCHINE_HALT);
    ASSERT_EQ(status().halted_by(), "");
  }
  EXPECT_TRUE(comes_true([&] { return !is_running(); }));
}

TEST_F(KeyboardsOfALab, AUTH_006_who_has_moved_to_another_seat_releases_the_own_press) {
  for (const std::uint32_t seat : {2U, 3U}) {
    Caller udo = call();
    log_in(udo, "udo", seat);
    strike(udo, Key::MASCHINE_HALT);
    EXPECT_EQ(status().halted_by(), seat == 2 ? "Platz 2, udo" : "");
    v1::ClientMessage out;
    out.mutable_logout();
    lab().receive(udo.visit, out);
  }
}

TEST_F(KeyboardsOfALab, AUTH_006_the_instructors_halt_holds_when_the_student_who_pressed_before_releases) {
  strike(eva, Key::MASCHINE_HALT);
  ASSERT_EQ(order([](auto& request) { request.mutable_halt(); }).error(), "");
  EXPECT_EQ(status().halted_by(), "Platz 7, eva; lehrer");
  strike(eva, Key::MASCHINE_HALT);
  EXPECT_EQ(status().halted_by(), "lehrer");
  EXPECT_THAT(eva.screen.text(18), HasSubstr("MASCHINE HALT gilt noch, gedrückt von lehrer."));
  ASSERT_EQ(order([](auto& request) { request.mutable_clear_halt(); }).error(), "");
  EXPECT_EQ(status().halted_by(), "");
}

TEST_F(KeyboardsOfALab, AUTH_006_a_console_that_types_for_a_student_signs_its_own_halt) {
  ASSERT_EQ(take(), "");
  strike(console, Key::MASCHINE_HALT);
  EXPECT_EQ(status().halted_by(), "lehrer");
  strike(eva, Key::MASCHINE_HALT);  // acts though the keyboard is taken, and is her own press
  EXPECT_EQ(status().halted_by(), "lehrer; Platz 7, eva");
  strike(eva, Key::MASCHINE_HALT);
  EXPECT_EQ(status().halted_by(), "lehrer") << "she cannot withdraw the instructor's";
  strike(console, Key::MASCHINE_HALT);
  EXPECT_EQ(status().halted_by(), "");
  EXPECT_THAT(journal_of(""), Contains(HasSubstr("halt|lehrer|")));
}

TEST_F(KeyboardsOfALab, AUTH_016_a_console_that_falls_silent_stops_the_machine_and_the_student_has_the_keys_back) {
  ASSERT_EQ(take(), "");
  ASSERT_NO_FATAL_FAILURE(run_on_machine(console));
  alive = {&eva};  // the console's line stays, nothing comes over it
  pass_ms(1200);
  EXPECT_TRUE(comes_true([&] { return !eva.visit->desk->control.is_running(); }));
  EXPECT_THAT(eva.screen.text(18), HasSubstr("Die Konsole ist fort"));
  strike(eva, Key::MENU);
  strike(eva, Key::EINGABE);
  EXPECT_TRUE(comes_true([&] { return eva.screen.text(2).contains("EINGABEMODUS"); })) << eva.screen.text(18);
  alive = {&eva, &console};
  EXPECT_EQ(status().stations(0).taken_by(), "");
  EXPECT_THAT(journal_of("eva"), Contains("lease_ended|console silent|eva"));
  EXPECT_THAT(journal_of("eva"), Contains("keyboard_given|console lost|eva"));
}

TEST_F(KeyboardsOfALab, AUTH_016_a_console_silent_beside_a_station_without_the_machine_changes_nothing) {
  ASSERT_EQ(take(), "");
  alive = {&eva};
  pass_ms(1200);
  EXPECT_EQ(status().stations(0).taken_by(), "lehrer");
}

TEST_F(KeyboardsOfALab, AUTH_015_the_loss_of_the_line_stands_in_the_students_own_journal) {
  ASSERT_NO_FATAL_FAILURE(run_on_machine(eva));
  lab().lost(eva.visit);
  alive = {&console};
  EXPECT_THAT(journal_of("eva"), Contains("lease_ended|line lost|eva"));
}

TEST_F(KeyboardsOfALab, AUTH_015_an_instructors_order_without_a_student_stands_in_the_instructors_journal) {
  ASSERT_EQ(order([](auto& request) { request.mutable_power_off(); }).error(), "");
  ASSERT_EQ(order([](auto& request) { request.mutable_power_on(); }).error(), "");
  const auto lines = journal_of("lehrer");
  EXPECT_THAT(lines, Contains("power_off|lehrer|lehrer"));
  EXPECT_THAT(lines, Contains("power_on|lehrer|lehrer"));
}

// interfaces.md section 3: what a key has done is contained in the next screen.
TEST_F(KeyboardsOfALab, STOP_is_acknowledged_by_the_screen_that_shows_its_effect) {
  ASSERT_NO_FATAL_FAILURE(run_on_machine(eva));
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    strike(eva, Key::STOP);
    ASSERT_TRUE(comes_true([&] { return eva.handled == eva.number; }));
    ASSERT_THAT(eva.screen.text(18), Not(HasSubstr("Programm läuft"))) << "round " << round;
    ASSERT_TRUE(comes_true([&] { return has_seen_rest(); }));
    ASSERT_TRUE(starts_again()) << eva.screen.text(18);
  }
}

TEST_F(KeyboardsOfALab, DEC_39_RESET_acts_while_the_menu_of_LABOR_is_open) {
  ASSERT_NO_FATAL_FAILURE(run_on_machine(eva));
  strike(eva, Key::LABOR);
  strike(eva, Key::RESET);
  EXPECT_TRUE(comes_true([&] { return !is_running() && status().selected() == 0; }));
  EXPECT_THAT(eva.screen.text(18), HasSubstr("RESET hat die Maschine abgegeben."));
}

TEST_F(KeyboardsOfALab, INS_002_SEAT_004_AMessageForASeatWhoseLineIsBrokenIsInRow18WhenItIsBack) {
  const std::string ticket = eva.login()->ticket();
  lab().lost(eva.visit);
  alive = {&console};
  for (const char* text : {"erstens", "zweitens"})
    ASSERT_EQ(order([&](auto& request) {
                request.mutable_message()->set_station(kSeat);
                request.mutable_message()->set_text(text);
              }).error(),
              "");
  pass_ms(20'000);  // longer than any notice stands
  v1::ClientMessage resume;
  resume.mutable_resume()->set_ticket(ticket);
  Caller again = call();
  lab().receive(again.visit, resume);
  alive = {&console, &again};
  pass_ms(100);
  EXPECT_THAT(again.screen.text(18), HasSubstr("lehrer: zweitens"));
  pass_ms(10'000);
  EXPECT_THAT(again.screen.text(18), Not(HasSubstr("zweitens"))) << "it stands as long as any other";
  strike(again, Key::LABOR);
  strike(again, Key::D6);
  pass_ms(100);
  EXPECT_THAT(again.screen.text(19), HasSubstr("lehrer: zweitens"));
  EXPECT_THAT(again.screen.text(20), HasSubstr("lehrer: erstens"));
}

}  // namespace
}  // namespace cnclab::lab
