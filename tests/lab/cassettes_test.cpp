// Cassettes: made, put in and played behind key LABOR, and kept in the database whatever happens (DEC-33, D-107).
#include <gmock/gmock.h>

#include "language/tape.hpp"
#include "small_lab.hpp"
#include "transfer/cassette.hpp"

namespace cnclab::lab {
namespace {

using testing::HasSubstr;
using testing::Not;

class Cassettes : public testing::Test, protected SmallLab {
 protected:
  Cassettes() {
    with_database([](db::Database& database) {
      const std::string block = "N001G04H9999";
      database.put_block(database.person("eva")->id, 1, {1, block, language::check_code(1, block)},
                         {.name = "eva", .station = kSeat, .time_ms = 1});
    });
    log_in(eva_, "eva", kSeat);
  }

  void pass_ms(std::int64_t milliseconds) {
    constexpr std::int64_t kPoll_ms = 20;
    for (std::int64_t passed = 0; passed < milliseconds; passed += kPoll_ms) {
      advance_ms(kPoll_ms);
      poll();
      look(eva_);
    }
    settle();
  }
  /// Everything that was to be stored so far is.
  void settle() {
    with_database([](db::Database&) {});
    poll();
    look(eva_);
  }
  void strike_all(std::initializer_list<Key> keys) {
    for (const Key key : keys) {
      strike(eva_, key);
      settle();
    }
  }
  void hold_enter(std::int64_t milliseconds) {
    send_enter(true);
    pass_ms(milliseconds);
    send_enter(false);
  }
  [[nodiscard]] std::string picture() const {
    std::string text;
    for (int row = 0; row < Screen::kRows; ++row) text += eva_.visit->desk->view.screen.text(row) + "\n";
    return text;
  }
  void wait_for(const std::string& text) {
    constexpr int kMost = 300;
    for (int i = 0; i < kMost && picture().find(text) == std::string::npos; ++i) pass_ms(100);
    ASSERT_THAT(picture(), HasSubstr(text));
  }
  /// A cassette of the name K01, in the recorder, with the program on it.
  void record() {
    strike_all({Key::LABOR, Key::D5, Key::EINGABE, Key::D1, Key::D1, Key::LABOR, Key::EXTERNE_DATEN, Key::D2, Key::D1});
    hold_enter(5200);
    wait_for("Ausgabe beendet");
  }
  /// Rewound, then read from: the next recording.
  void rewind_and_read() {
    strike_all({Key::LABOR, Key::D5, Key::D1, Key::D2, Key::LABOR});
    pass_ms(2000);
    strike_all({Key::EXTERNE_DATEN, Key::D6, Key::CLEAR, Key::ENTER});
  }
  [[nodiscard]] std::string stored_tape() {
    std::string tape;
    with_database([&tape](db::Database& database) {
      const db::PersonId eva = database.person("eva")->id;
      tape = database.tape(eva, database.cassettes(eva).at(0).id).value();
    });
    return tape;
  }
  void put_tape(const std::string& tape) {
    with_database([tape](db::Database& database) {
      const db::PersonId eva = database.person("eva")->id;
      database.put_tape(eva, database.cassettes(eva).at(0).id, tape, 1);
    });
  }
  void log_in_again() {
    v1::ClientMessage message;
    message.mutable_logout();
    lab().receive(eva_.visit, message);
    eva_ = call();
    log_in(eva_, "eva", kSeat);
    settle();
  }

  Caller eva_ = call();

 private:
  void send_enter(bool is_pressed) {
    v1::ClientMessage message;
    message.mutable_key()->set_number(++eva_.number);
    message.mutable_key()->add_keys(static_cast<v1::Key>(Key::ENTER));
    message.mutable_key()->set_pressed(is_pressed);
    lab().receive(eva_.visit, message);
  }
};

TEST_F(Cassettes, DEC_33_ARecordingIsKeptWhenTheMotorStopsAndReadAfterAnotherLogin) {
  record();
  const auto kept = transfer::Cassette::deserialize(stored_tape());
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->pieces().size(), 1U);
  EXPECT_THAT(kept->pieces()[0].bytes, HasSubstr("N001G04H9999"));
  EXPECT_GT(kept->position_ms(), kept->pieces()[0].end_ms() - 100) << "and where it stands";
  log_in_again();
  with_database([](db::Database& database) { database.remove_program(database.person("eva")->id, 1, {"eva", 7, 2}); });
  rewind_and_read();
  wait_for("Gelesen und gespeichert, Programme: 1.");
}

TEST_F(Cassettes, D_107_AFlippedByteInTheDatabaseIsAChecksumFault) {
  record();
  log_in_again();
  std::string tape = stored_tape();
  const std::size_t at = tape.find("G04");
  ASSERT_NE(at, std::string::npos);
  tape[at + 1] = '1';
  {
    v1::ClientMessage message;
    message.mutable_logout();
    lab().receive(eva_.visit, message);
  }
  settle();
  put_tape(tape);
  eva_ = call();
  log_in(eva_, "eva", kSeat);
  settle();
  rewind_and_read();
  wait_for("CHECKSUM FEHLER");
  EXPECT_THAT(picture(), HasSubstr("Aufnahme"));
}

TEST_F(Cassettes, SEC_006_WhatIsNoCassetteIsNotPutIn) {
  record();
  {
    v1::ClientMessage message;
    message.mutable_logout();
    lab().receive(eva_.visit, message);
  }
  settle();
  put_tape("CNCK and nothing more");
  eva_ = call();
  log_in(eva_, "eva", kSeat);
  settle();
  EXPECT_THAT(picture(), HasSubstr("Die Kassette ist beschädigt"));
  strike_all({Key::EXTERNE_DATEN, Key::D2});
  EXPECT_THAT(picture(), HasSubstr("Keine Kassette eingelegt"));
}

TEST_F(Cassettes, DEC_33_AtMostTenWithNamesThatCanBeChanged) {
  strike_all({Key::LABOR, Key::D5});
  EXPECT_THAT(picture(), HasSubstr("Es gibt noch keine."));
  for (int i = 0; i < 10; ++i) strike_all({Key::EINGABE});
  EXPECT_THAT(picture(), HasSubstr("Seite 1 von 3"));
  EXPECT_THAT(picture(), HasSubstr("1  K01"));
  strike_all({Key::EINGABE});
  strike_all({Key::D1, Key::D6, Key::D4, Key::D2, Key::ENTER});
  EXPECT_THAT(picture(), Not(HasSubstr("K01")));
  EXPECT_THAT(picture(), HasSubstr("1  K02"));
  strike_all({Key::D1, Key::D7, Key::CLEAR, Key::D7, Key::ENTER});
  EXPECT_THAT(picture(), HasSubstr("1  K03"));
  std::vector<std::string> names;
  with_database([&names](db::Database& database) {
    for (const auto& cassette : database.cassettes(database.person("eva")->id)) names.push_back(cassette.name);
  });
  EXPECT_THAT(names, testing::ElementsAre("K03", "K04", "K05", "K06", "K07", "K08", "K09", "K10", "K42"));
}

TEST_F(Cassettes, DEC_33_TheTapeIsSavedOnEjectingAndWithTheStateWhileItTurns) {
  strike_all({Key::LABOR, Key::D5, Key::EINGABE, Key::D1, Key::D1, Key::D3});
  pass_ms(11'000);
  const auto turning = transfer::Cassette::deserialize(stored_tape());
  ASSERT_TRUE(turning);
  EXPECT_GT(turning->position_ms(), 0U) << "at latest every 10 s";
  EXPECT_THAT(picture(), HasSubstr("Zähler 2")) << "the counter turns on the page";
  strike_all({Key::D1});
  EXPECT_TRUE(eva_.visit->desk->control.recorder_runs()) << "not ejected while it turns";
  strike_all({Key::D4, Key::D1});
  EXPECT_FALSE(eva_.visit->desk->control.cassette());
  const auto ejected = transfer::Cassette::deserialize(stored_tape());
  ASSERT_TRUE(ejected);
  EXPECT_GT(ejected->position_ms(), turning->position_ms());
  EXPECT_THAT(picture(), HasSubstr("1 in den Rekorder einlegen"));
}

TEST(CassetteLine, TheSameSizeOnTheShelfAndInTheRecorderAndNothingForAnEmptyOne) {
  const auto shown = [](const transfer::Cassette& cassette, bool is_inserted) {
    db::StoredCassette stored;
    stored.name = "K01";
    stored.is_inserted = is_inserted;
    stored.bytes = cassette.serialized().size();
    const std::string line =
        cassette_line(stored, is_inserted ? std::optional(cassette) : std::nullopt, language::Tongue::german);
    return line.substr(0, line.find("KB"));
  };
  transfer::Cassette cassette;
  EXPECT_EQ(shown(cassette, false), "K01      0 ");
  EXPECT_EQ(shown(cassette, true), "K01      0 ");
  constexpr std::uint32_t kBehindTheLeader_ms = 10'000;
  ASSERT_TRUE(cassette.record(kBehindTheLeader_ms, std::string(1500, 'x')));
  EXPECT_EQ(shown(cassette, false), "K01      2 ");
  EXPECT_EQ(shown(cassette, true), "K01      2 ");
}

}  // namespace
}  // namespace cnclab::lab
