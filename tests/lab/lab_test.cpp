// The lab as connections see it: messages in, messages out, with a database in memory and a clock of our own.
#include "lab/lab.hpp"

#include <gtest/gtest.h>

#include "language/tape.hpp"
#include "small_lab.hpp"

namespace cnclab::lab {
namespace {

class LabTest : public testing::Test, protected SmallLab {};

TEST_F(LabTest, SEAT_002_AStudentLogsInAndSeesAScreen) {
  Caller eva = call();
  log_in(eva, "eva", 7);
  ASSERT_NE(eva.login(), nullptr);
  EXPECT_EQ(eva.login()->result(), v1::LOGIN_RESULT_OK);
  EXPECT_EQ(eva.login()->ticket().size(), 32U);
  lab_->poll();
  EXPECT_TRUE(std::ranges::any_of(eva.peer->sent, [](const auto& message) { return message.has_screen(); }));
}

TEST_F(LabTest, SEAT_001_OnlyStationsOneToFifteen) {
  for (const std::uint32_t station : {0U, 16U, 4'000'000'000U}) {
    Caller eva = call();
    log_in(eva, "eva", station);
    EXPECT_EQ(eva.login()->result(), v1::LOGIN_RESULT_NOT_ALLOWED) << station;
  }
}

TEST_F(LabTest, SEAT_001_ATakenSeatIsRefusedAndNamesWhoSitsThere) {
  Caller eva = call(), udo = call();
  log_in(eva, "eva", 7);
  log_in(udo, "udo", 7);
  EXPECT_EQ(udo.login()->result(), v1::LOGIN_RESULT_SEAT_TAKEN);
  EXPECT_EQ(udo.login()->occupant(), "eva");
}

TEST_F(LabTest, SEAT_003_ASecondLoginAsksThenTakesOver) {
  Caller here = call(), there = call();
  log_in(here, "eva", 7);
  log_in(there, "eva", 8);
  EXPECT_EQ(there.login()->result(), v1::LOGIN_RESULT_ELSEWHERE);
  EXPECT_EQ(there.login()->other_station(), 7U);
  log_in(there, "eva", 8, "geheim123", v1::ELSEWHERE_TAKE_OVER);
  EXPECT_EQ(there.login()->result(), v1::LOGIN_RESULT_OK);
  const auto bye = std::ranges::find_if(here.peer->sent, [](const auto& message) { return message.has_bye(); });
  ASSERT_NE(bye, here.peer->sent.end());
  EXPECT_EQ(bye->bye().exit_code(), 6U);
}

// A German form is not answered in the language of an account that has not been let in.
TEST_F(LabTest, SEAT_002_UntilTheLoginIsDoneTheLabSpeaksItsOwnLanguage) {
  with_database([](db::Database& database) {
    for (const char* const name : {"eva", "udo"}) database.set_language(database.person(name)->id, "en");
  });
  Caller eva = call(), udo = call(), twice = call();
  log_in(eva, "eva", 7);
  EXPECT_EQ(eva.login()->language(), "en");
  log_in(udo, "udo", 7);
  EXPECT_EQ(udo.login()->text(), "An diesem Platz sitzt schon eva.");
  log_in(twice, "eva", 8);
  EXPECT_EQ(twice.login()->text(), "Schon angemeldet an Platz 7.");
  log_in(twice, "eva", 8, "geheim123", v1::ELSEWHERE_LOOK_ON);
  EXPECT_EQ(twice.login()->language(), "en") << "who looks on has logged in";
}

TEST_F(LabTest, SEAT_004_ATicketBringsBackTheSameSeatAndReplacesTheOldLine) {
  Caller eva = call();
  log_in(eva, "eva", 7);
  v1::ClientMessage resume;
  resume.mutable_resume()->set_ticket(eva.login()->ticket());
  Caller again = call();
  lab_->receive(again.visit, resume);
  ASSERT_NE(again.login(), nullptr);
  EXPECT_EQ(again.login()->result(), v1::LOGIN_RESULT_OK);
  EXPECT_EQ(again.login()->station(), 7U);
  EXPECT_FALSE(eva.peer->reason.empty());
  Caller thief = call();
  resume.mutable_resume()->set_ticket(std::string(32, 'x'));
  lab_->receive(thief.visit, resume);
  EXPECT_EQ(thief.login()->result(), v1::LOGIN_RESULT_TICKET_VOID);
}

TEST_F(LabTest, SEC_003_UnknownNamesAndWrongPasswordsAreAnsweredAlike) {
  Caller eva = call(), nobody = call();
  log_in(eva, "eva", 1, "falsch123");
  log_in(nobody, "niemand", 1, "falsch123");
  EXPECT_EQ(eva.login()->result(), v1::LOGIN_RESULT_REFUSED);
  EXPECT_EQ(nobody.login()->result(), v1::LOGIN_RESULT_REFUSED);
  EXPECT_EQ(eva.login()->text(), nobody.login()->text());
}

TEST_F(LabTest, SEC_004_AStudentIsNoInstructor) {
  Caller console = call(v1::CLIENT_KIND_INSTRUCTOR);
  log_in(console, "eva", 0);
  EXPECT_EQ(console.login()->result(), v1::LOGIN_RESULT_NOT_ALLOWED);
  Caller eva = call();
  log_in(eva, "eva", 2);
  v1::ClientMessage request;
  request.mutable_request()->set_number(5);
  request.mutable_request()->mutable_program_show()->set_student("udo");
  lab_->receive(eva.visit, request);
  ASSERT_TRUE(eva.peer->sent.back().has_answer());
  EXPECT_FALSE(eva.peer->sent.back().answer().error().empty());
  EXPECT_EQ(eva.peer->sent.back().answer().items_size(), 0);
}

TEST_F(LabTest, SEC_006_MessagesOutOfOrderEndTheConnection) {
  Caller old = call(v1::CLIENT_KIND_STATION, 99);
  EXPECT_FALSE(old.peer->sent.front().welcome().accepted());
  EXPECT_EQ(old.peer->sent.front().welcome().versions(0), kProtocolVersion);
  EXPECT_FALSE(old.peer->reason.empty());
  Caller early = call();
  press(early, Key::START, 1);
  EXPECT_FALSE(early.peer->reason.empty()) << "a key before the login";
  Caller eva = call();
  log_in(eva, "eva", 2);
  press(eva, Key::MENU, 5);
  EXPECT_FALSE(eva.peer->reason.empty()) << "key numbers with a gap";
}

TEST_F(LabTest, SEC_005_WhoDoesNotLogInWithinTenSecondsIsHungUp) {
  Caller slow = call();
  now_ns_ += 10'500'000'000;
  lab_->poll();
  EXPECT_FALSE(slow.peer->reason.empty());
}

TEST_F(LabTest, SEC_005_AtMostSixtyFourConnectionsWaitForTheirLogin) {
  std::vector<Caller> callers;
  for (int i = 0; i < 64; ++i) callers.push_back(call());
  EXPECT_TRUE(callers.back().peer->reason.empty());
  const Caller one_more = call();
  EXPECT_FALSE(one_more.peer->reason.empty());
}

TEST_F(LabTest, INS_001_WhoSitsAtASeatIsShownAndNotWhoseControlIsKeptThere) {
  Caller console = call(v1::CLIENT_KIND_INSTRUCTOR), eva = call(), udo = call();
  log_in(console, "lehrer", 0);
  log_in(eva, "eva", 7);
  lab_->lost(eva.visit);
  const auto stations = [&] {
    v1::InstructorRequest request;
    request.mutable_status();
    return ask(console, request).items(0).status().stations();
  };
  const auto watched = [&] {
    unix_ms_ += 1000;  // each screen has a clock and is drawn anew
    advance_ms(100);
    poll();
    look(console);
    std::string text;
    for (int row = 0; row < Screen::kRows; ++row) text += console.screen.text(row) + "\n";
    return text;
  };
  ASSERT_EQ(stations().size(), 1);
  EXPECT_EQ(stations()[0].user(), "eva");
  EXPECT_FALSE(stations()[0].connected());
  log_in(udo, "udo", 7);
  ASSERT_EQ(stations().size(), 1) << "one entry for a seat";
  EXPECT_EQ(stations()[0].user(), "udo");
  EXPECT_TRUE(stations()[0].connected());
  v1::ClientMessage watch;
  watch.mutable_request()->set_number(77);
  watch.mutable_request()->mutable_watch()->set_station(7);
  lab_->receive(console.visit, watch);
  static_cast<void>(watched());
  for (int second = 0; second < 5; ++second) {
    const std::string text = watched();
    EXPECT_NE(text.find("udo"), std::string::npos) << text;
    EXPECT_EQ(text.find("eva"), std::string::npos) << text;
  }
  v1::ClientMessage log_out;
  log_out.mutable_logout();
  lab_->receive(udo.visit, log_out);
  ASSERT_EQ(stations().size(), 1);
  EXPECT_EQ(stations()[0].user(), "eva") << "kept, and the seat is free";
  static_cast<void>(watched());
  EXPECT_NE(watched().find("eva"), std::string::npos);
}

TEST_F(LabTest, SEAT_004_ASilentConnectionIsClosedAfterFiveSeconds) {
  Caller eva = call();
  log_in(eva, "eva", 7);
  now_ns_ += 4'900'000'000;
  lab_->poll();
  EXPECT_TRUE(eva.peer->reason.empty());
  now_ns_ += 200'000'000;
  lab_->poll();
  EXPECT_FALSE(eva.peer->reason.empty());
}

TEST_F(LabTest, SEAT_004_WhenTheComputersClockJumpsNobodyIsHungUp) {
  Caller eva = call();
  log_in(eva, "eva", 7);
  for (const std::int64_t jump_ms : {86'400'000LL, -2 * 86'400'000LL}) {
    unix_ms_ += jump_ms;
    now_ns_ += 100'000'000;
    lab_->poll();
    EXPECT_TRUE(eva.peer->reason.empty());
  }
}

TEST_F(LabTest, KeysAreAcknowledgedInTheNextScreen) {
  Caller eva = call();
  log_in(eva, "eva", 7);
  press(eva, Key::AUTOMAT, 1);
  std::uint64_t handled = 0;
  for (int i = 0; i < 3; ++i) {
    for (const auto& message : eva.peer->sent) {
      if (!message.has_screen()) continue;
      handled = std::max(handled, message.screen().handled_key());
      v1::ClientMessage ack;
      ack.mutable_screen_ack()->set_number(message.screen().number());
      if (eva.visit->feed.is_waiting()) lab_->receive(eva.visit, ack);
      break;
    }
    if (!eva.peer->sent.empty()) eva.peer->sent.pop_front();
    lab_->poll();
  }
  EXPECT_EQ(handled, 1U);
}

// The wall clock of these tests stands still, so nothing but the end itself can bring the last screen.
TEST_F(LabTest, AUTH_008_TheEndOfARunShowsAtOnceWithItsStateNumber) {
  bool stored = false;
  store_->run(
      [](db::Database& database) {
        const std::string block = "N001G04H0001";
        const db::StoredBlock dwell{1, block, language::check_code(1, block)};
        database.put_block(database.person("eva")->id, 1, dwell, {.name = "eva", .station = 7, .time_ms = 1});
      },
      [&stored](const std::expected<void, db::StoreError>&) { stored = true; });
  settle_until([&] { return stored; });
  Caller eva = call();
  log_in(eva, "eva", 7);
  std::uint64_t handled = 0;
  std::vector<std::uint64_t> states;  // of the screens since START was handled
  const auto look = [&] {
    lab_->poll();
    for (; !eva.peer->sent.empty(); eva.peer->sent.pop_front()) {
      if (!eva.peer->sent.front().has_screen()) continue;
      const v1::ScreenUpdate screen = eva.peer->sent.front().screen();
      handled = screen.handled_key();
      if (handled == 4 && (states.empty() || states.back() != screen.state())) states.push_back(screen.state());
      v1::ClientMessage ack;
      ack.mutable_screen_ack()->set_number(screen.number());
      lab_->receive(eva.visit, ack);
    }
  };
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  std::uint64_t number = 0;
  for (const Key key : {Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) {
    press(eva, key, ++number);
    while (handled != number && std::chrono::steady_clock::now() < limit) look();
  }
  while (states.size() < 2 && std::chrono::steady_clock::now() < limit) look();
  EXPECT_GE(states.size(), 2U) << "after the dwell of 0.1 s no screen told that the run is over";
}

/// A driver that hangs in its exchange holds up the whole beat.
class HangingMachine final : public machine::Machine {
 public:
  machine::Inputs exchange(const machine::Outputs&) noexcept override {
    hangs.wait(true);
    return {};
  }
  void hang(bool on) {
    hangs = on;
    hangs.notify_all();
  }
  std::atomic<bool> hangs{false};
};

TEST_F(LabTest, RULE_7_ABeatThatStandsStillCutsTheMachinesCurrentUntilPowerOn) {
  HangingMachine hanging;
  const auto channel = std::make_shared<machine::Channel>(hanging, machine::MachineData{});
  ASSERT_TRUE(ticks_.add(channel));
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  const auto polls_until = [&](const char* metric) {
    while (!lab_->metrics().contains(metric) && std::chrono::steady_clock::now() < limit) lab_->poll();
    return lab_->metrics().contains(metric);
  };
  EXPECT_TRUE(lab_->metrics().contains("cnclab_machine_powered 1\n"));
  hanging.hang(true);
  EXPECT_TRUE(polls_until("cnclab_tick_stalls_total 1\n"));
  hanging.hang(false);
  EXPECT_TRUE(polls_until("cnclab_machine_powered 0\n")) << "status and console say `off`";
  while (ticks_.statistics().late == 0 && std::chrono::steady_clock::now() < limit) lab_->poll();
  EXPECT_GT(ticks_.statistics().late, 0U);
  ticks_.remove(channel);
}

}  // namespace
}  // namespace cnclab::lab
