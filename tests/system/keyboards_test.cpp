// Keyboards locked, taken over, and a screen shown to all: STOP and MASCHINE HALT act through all of it (AUTH-016,
// INS-002, SEC-007).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"
#include "harness/raw_client.hpp"
#include "programs.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

/// An instructor's console that types: a connection that lasts, unlike a one-shot command's.
class TypingConsole {
 public:
  explicit TypingConsole(Classroom& room) : client_(room.server().port()) {
    if (!client_.greet(v1::CLIENT_KIND_INSTRUCTOR)) throw std::runtime_error("no Welcome");
    const auto answer = client_.log_in("lehrer", room.passwords().password_of("lehrer"), 0);
    if (!answer || answer->result() != v1::LOGIN_RESULT_OK) throw std::runtime_error("no login");
  }

  void take(std::uint32_t station) {
    for (const bool watch : {true, false}) {
      v1::ClientMessage message;
      message.mutable_request()->set_number(1);
      (watch ? message.mutable_request()->mutable_watch() : message.mutable_request()->mutable_take())
          ->set_station(station);
      client_.send(message);
      // A screen may come first: unacknowledged it would be the last one.
      auto reply = client_.read(kLimit);
      for (; reply && !reply->has_answer(); reply = client_.read(kLimit)) answer(*reply);
      if (!reply || !reply->answer().error().empty()) throw std::runtime_error("not taken");
    }
  }
  /// Presses and releases, in view of the newest screen and beat.
  void press(v1::Key key) {
    for (const bool pressed : {true, false}) {
      v1::ClientMessage message;
      auto& event = *message.mutable_key();
      event.set_number(++number_);
      event.add_keys(key);
      event.set_pressed(pressed);
      event.mutable_seen()->set_beat(beat_);
      event.mutable_seen()->set_state(state_);
      client_.send(message);
    }
  }
  /// Asks for the status again and again, answering beats and screens meanwhile, until `done` likes it.
  template <class Condition>
  bool live_until(Condition done) {
    const Deadline deadline(kLimit);
    while (!deadline.has_passed()) {
      v1::ClientMessage question;
      question.mutable_request()->set_number(2);
      question.mutable_request()->mutable_status();
      client_.send(question);
      for (bool is_answered = false; !is_answered;) {
        const auto message = client_.read(kLimit);
        if (!message) return false;
        answer(*message);
        is_answered = message->has_answer();
        if (is_answered && done(message->answer().items(0).status())) return true;
      }
    }
    return false;
  }
  [[nodiscard]] std::uint64_t state() const { return state_; }
  /// A screen and a beat have come: from now on a START is pressed in view of something (AUTH-008).
  [[nodiscard]] bool has_looked() const { return state_ != 0 && beat_ != 0; }

 private:
  void answer(const v1::ServerMessage& message) {
    v1::ClientMessage reply;
    if (message.has_beat()) {
      beat_ = message.beat().number();
      reply.mutable_alive()->set_beat(beat_);
    } else if (message.has_screen()) {
      state_ = message.screen().state();
      reply.mutable_screen_ack()->set_number(message.screen().number());
    } else {
      return;
    }
    client_.send(reply);
  }

  RawClient client_;
  std::uint64_t number_ = 0, beat_ = 0, state_ = 0;
};

class Keyboards : public testing::Test {
 protected:
  Keyboards() {
    room_.add_student("anna", {kEndless});
    room_.add_student("otto");
    anna_.emplace(room_.seat(1, "anna"));
  }
  nlohmann::json status() { return room_.instructor().status(); }
  std::string machine_state() { return status()["machine"]["state"]; }
  bool comes_to(const std::string& state) {
    return eventually(kLimit, [&] { return machine_state() == state; });
  }
  void run_on_machine() {
    room_.give_machine(1, *anna_);
    anna_->key("AUTOMAT ENTER ENTER START");
    ASSERT_TRUE(comes_to("moving")) << anna_->text();
  }

  Classroom room_;
  std::optional<StationProcess> anna_;
};

TEST_F(Keyboards, SEC_007_a_locked_keyboard_does_nothing_until_it_is_unlocked) {
  room_.instructor().must({"lock", "1"});
  anna_->wait_for("gesperrt");
  anna_->key("EINGABE");
  EXPECT_FALSE(anna_->shows("EINGABEMODUS"));
  EXPECT_EQ(room_.instructor().station(1)["locked"], true);
  room_.instructor().must({"unlock", "1"});
  anna_->wait_gone("gesperrt");
  anna_->key("EINGABE");
  EXPECT_TRUE(anna_->shows("EINGABEMODUS"));
}

TEST_F(Keyboards, SEC_007_a_lock_follows_the_student_to_another_station) {
  room_.instructor().must({"lock", "1"});
  anna_->quit();
  anna_.emplace(room_.seat(4, "anna"));
  anna_->wait_for("gesperrt");
  EXPECT_EQ(room_.instructor().station(4)["locked"], true);
}

TEST_F(Keyboards, AUTH_016_locking_the_controlling_station_stops_first_and_it_cannot_be_selected) {
  run_on_machine();
  room_.instructor().must({"lock", "1"});
  ASSERT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["selected"], 0);
  const OneShot refused = room_.instructor().run({"select", "1"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, HasSubstr("gesperrt"));
}

TEST_F(Keyboards, AUTH_016_expelling_the_controlling_station_stops_first) {
  run_on_machine();
  room_.instructor().must({"expel", "1"});
  EXPECT_EQ(anna_->wait(kLimit), 9);
  EXPECT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["selected"], 0);
}

TEST_F(Keyboards, AUTH_016_MASCHINE_HALT_acts_under_lock_and_show) {
  StationProcess otto = room_.seat(2, "otto");
  run_on_machine();
  room_.instructor().must({"lock", "2"});
  otto.key("MASCHINE_HALT");
  ASSERT_TRUE(comes_to("halted"));
  otto.key("MASCHINE_HALT");
  ASSERT_TRUE(comes_to("standstill"));
  room_.instructor().must({"unlock", "2"});
  room_.instructor().must({"show", "1"});
  otto.key("MASCHINE_HALT");
  EXPECT_TRUE(comes_to("halted"));
}

TEST_F(Keyboards, INS_002_a_shown_screen_stands_on_every_station_but_the_controlling_one) {
  StationProcess otto = room_.seat(2, "otto");
  room_.give_machine(1, *anna_);
  otto.key("EINGABE");
  room_.instructor().must({"show", "2"});
  EXPECT_FALSE(anna_->shows("EINGABEMODUS")) << "the controlling station keeps its own screen";
  room_.instructor().must({"release"});
  anna_->wait_for("EINGABEMODUS");
  anna_->wait_for("Platz 2, otto, wird allen gezeigt");
  anna_->key("MENU");
  EXPECT_TRUE(anna_->shows("EINGABEMODUS")) << "keys do nothing meanwhile";
  EXPECT_EQ(status()["shown"], 2);
  room_.instructor().must({"show", "off"});
  anna_->wait_gone("EINGABEMODUS");
}

TEST_F(Keyboards, INS_002_show_ends_when_the_shown_student_leaves) {
  StationProcess otto = room_.seat(2, "otto");
  room_.instructor().must({"show", "2"});
  anna_->wait_for("wird allen gezeigt");
  otto.quit();
  anna_->wait_gone("wird allen gezeigt");
}

TEST_F(Keyboards, INS_002_a_console_types_in_the_students_place_until_it_gives_the_keyboard_back) {
  TypingConsole console(room_);
  console.take(1);
  anna_->wait_for("lehrer hat diese Tastatur");
  anna_->key("AUTOMAT");
  EXPECT_FALSE(anna_->shows("AUTOMAT P"));
  console.press(v1::KEY_EINGABE);
  anna_->wait_for("EINGABEMODUS");
  EXPECT_EQ(room_.instructor().station(1)["taken_by"], "lehrer");
  room_.instructor().must({"give", "1"});
  anna_->wait_gone("lehrer hat diese Tastatur");
  anna_->key("MENU");
  EXPECT_FALSE(anna_->shows("EINGABEMODUS"));
}

TEST_F(Keyboards, AUTH_016_a_console_that_runs_the_machine_for_a_station_stops_it_by_its_loss) {
  auto console = std::make_unique<TypingConsole>(room_);
  console->take(1);
  room_.instructor().must({"select", "1"});
  // START accepts the offer, seen on the console's own copy of the screen.
  const auto stands = [](const char* state) {
    return [state](const v1::Status& status) { return status.machine().state() == state; };
  };
  ASSERT_TRUE(console->live_until([&](const v1::Status& now) { return now.offered() == 1 && console->has_looked(); }));
  console->press(v1::KEY_START);
  ASSERT_TRUE(console->live_until([](const v1::Status& now) { return now.selected() == 1; }));
  for (const v1::Key key : {v1::KEY_AUTOMAT, v1::KEY_ENTER, v1::KEY_ENTER}) console->press(key);
  ASSERT_TRUE(console->live_until([](const v1::Status& now) { return now.stations(0).block() == 1; }));
  // A START counts only in view of the present situation (AUTH-008): one for each screen that shows another.
  std::uint64_t pressed_for = 0;
  const auto starts = [&](const v1::Status& now) {
    if (now.machine().state() == "moving") return true;
    if (console->state() != pressed_for) console->press(v1::KEY_START);
    pressed_for = console->state();
    return false;
  };
  ASSERT_TRUE(console->live_until(starts)) << anna_->text();
  anna_->press("STOP");
  ASSERT_TRUE(console->live_until(stands("standstill"))) << "the student's STOP";
  ASSERT_TRUE(console->live_until(starts)) << anna_->text();
  console.reset();
  ASSERT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["selected"], 0);
  anna_->key("MENU");
  EXPECT_EQ(room_.instructor().station(1)["taken_by"], "") << "the keys are given back";
}

TEST_F(Keyboards, AUTH_016_the_loss_of_any_other_console_changes_nothing) {
  StationProcess otto = room_.seat(2, "otto");
  run_on_machine();
  {
    TypingConsole console(room_);
    console.take(2);
  }
  EXPECT_EQ(machine_state(), "moving");
  EXPECT_EQ(status()["selected"], 1);
  EXPECT_EQ(room_.instructor().station(2)["taken_by"], "lehrer");
}

}  // namespace
}  // namespace cnclab::harness
