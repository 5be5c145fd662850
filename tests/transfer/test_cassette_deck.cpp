// The recorder: leader, pause, LED, search, indicator, faults (EXT-010 to EXT-026).
#include <gmock/gmock.h>

#include "transfer/cassette_deck.hpp"

namespace cnclab::transfer {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using State = CassetteDeck::State;

class Deck : public testing::Test {
 public:
  void pass(Time time) {
    now += time;
    if (auto event = deck.advance(now)) events.push_back(std::move(*event));
  }
  /// Writes with a leader of that length; ends when the motor stands still.
  void write(const Payload& payload, Time leader) {
    deck.begin_writing(payload, now);
    pass(leader);
    deck.end_leader(now);
    while (deck.motor_runs()) pass(milliseconds(50));
  }
  void rewind() {
    deck.rewind(now);
    while (deck.motor_runs()) pass(milliseconds(50));
  }
  /// Reads to the event.
  DeckEvent read(std::optional<std::uint16_t> program) {
    events.clear();
    deck.begin_reading(program, now);
    while (deck.motor_runs()) pass(milliseconds(50));
    return events.empty() ? DeckEvent{Written{}} : events.front();
  }
  void put_in(Cassette cassette) { deck = CassetteDeck(std::move(cassette), now); }

  static Payload program(std::uint16_t number, std::size_t length = 480) {
    return {.program = number, .text = std::string(length, 'X')};
  }

  Time now{seconds(100)};
  CassetteDeck deck{Cassette{}, now};
  std::vector<DeckEvent> events;
};

std::uint16_t program_of(const DeckEvent& event) { return std::get<WasRead>(event).payload.program; }
DeckFault fault_of(const DeckEvent& event) { return std::get<DeckFailed>(event).fault; }

TEST_F(Deck, TheMotorRunsAsLongAsTheKeyIsHeld_EXT_011) {
  deck.begin_writing(program(1), now);
  pass(seconds(6));
  EXPECT_EQ(deck.state(), State::leader);
  EXPECT_TRUE(deck.motor_runs());
  EXPECT_FALSE(deck.led_is_on());
  EXPECT_EQ(deck.counter(), 6);
}

TEST_F(Deck, TransmissionBeginsASecondAfterTheRelease_EXT_012_EXT_013) {
  deck.begin_writing(program(1, 480), now);
  pass(seconds(6));
  deck.end_leader(now);
  pass(milliseconds(999));
  EXPECT_FALSE(deck.led_is_on());
  pass(milliseconds(1));
  EXPECT_TRUE(deck.led_is_on());
  const auto whole = milliseconds(play_ms(recording_length(480)));
  pass(whole - milliseconds(1));
  EXPECT_TRUE(deck.led_is_on());
  EXPECT_GT(deck.progress(), 0.99);
  pass(milliseconds(1));
  EXPECT_FALSE(deck.led_is_on());
  EXPECT_FALSE(deck.motor_runs());
  ASSERT_EQ(events.size(), 1u);
  EXPECT_FALSE(std::get<Written>(events[0]).is_lost);
  EXPECT_EQ(deck.cassette().pieces().front().start_ms, 7000u);
}

TEST_F(Deck, OneLateLookGivesTheSameTape) {
  deck.begin_writing(program(1), now);
  deck.end_leader(now += seconds(6));
  pass(seconds(600));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(deck.cassette().pieces().front().start_ms, 7000u);
  EXPECT_EQ(deck.cassette().position_ms(), 7000u + play_ms(recording_length(480)));
}

TEST_F(Deck, ALeaderShorterThanTheTransparentPartLosesTheRecording_D_105) {
  write(program(1), milliseconds(3999));
  EXPECT_TRUE(std::get<Written>(events.at(0)).is_lost);
  write(program(2), Time(0));  // EXT-014: behind it no leader is needed
  EXPECT_FALSE(std::get<Written>(events.at(1)).is_lost);
  rewind();
  EXPECT_EQ(program_of(read(std::nullopt)), 2);
  rewind();
  EXPECT_EQ(fault_of(read(1)), DeckFault::end_of_tape);
}

TEST_F(Deck, FourSecondsAndThePauseAreJustEnough_D_105) {
  write(program(1), seconds(4));
  EXPECT_FALSE(std::get<Written>(events.at(0)).is_lost);
}

TEST_F(Deck, TheNextRecordingIsRead_EXT_020) {
  write(program(1), seconds(6));
  write(program(2), Time(0));
  write({.is_whole_memory = true, .text = "P0000%"}, Time(0));
  rewind();
  EXPECT_EQ(program_of(read(std::nullopt)), 1);
  EXPECT_EQ(program_of(read(std::nullopt)), 2);
  const auto event = read(std::nullopt);
  EXPECT_TRUE(std::get<WasRead>(event).payload.is_whole_memory);
  EXPECT_EQ(std::get<WasRead>(event).payload.text, "P0000%");
}

TEST_F(Deck, AProgramIsSearched_EXT_022) {
  write(program(1), seconds(6));
  write({.is_whole_memory = true, .program = 7, .text = "P0007N001G05%"}, Time(0));
  write(program(7, 100), Time(0));
  rewind();
  const auto event = read(7);
  EXPECT_EQ(std::get<WasRead>(event).payload, program(7, 100));
}

TEST_F(Deck, TheIndicatorBeginsWithTheStartMark_EXT_021) {
  write(program(1), seconds(6));
  rewind();
  deck.begin_reading(1, now);
  pass(milliseconds(7000 + play_ms(kMarkLength) - 1));
  EXPECT_FALSE(deck.is_reading());
  pass(milliseconds(1));
  EXPECT_TRUE(deck.is_reading());
}

TEST_F(Deck, MachineDataAreAdoptedOnlyWithTheSignKey_EXT_026) {
  write(program(1), seconds(6));
  rewind();
  EXPECT_FALSE(std::get<WasRead>(read(1)).adopts_machine_data);
  rewind();
  deck.adopt_machine_data();  // not while the tape stands still
  EXPECT_FALSE(std::get<WasRead>(read(1)).adopts_machine_data);
  rewind();
  deck.begin_reading(1, now);
  pass(seconds(1));
  deck.adopt_machine_data();
  events.clear();
  pass(seconds(60));
  EXPECT_TRUE(std::get<WasRead>(events.at(0)).adopts_machine_data);
}

TEST_F(Deck, ADamagedByteIsFoundWhereverItIs_D_107) {
  write(program(1, 1000), seconds(6));
  write(program(2), Time(0));
  const Cassette good = deck.cassette();
  for (std::size_t byte = 0; byte < recording_length(1000); byte += 7) {
    Cassette damaged = good;
    ASSERT_TRUE(damaged.damage(0, byte));
    damaged.wind_to(0);
    put_in(damaged);
    EXPECT_EQ(fault_of(read(1)), DeckFault::damaged) << byte;
    EXPECT_EQ(program_of(read(std::nullopt)), 2) << byte;  // the tape stands behind it
  }
}

TEST_F(Deck, StopWhileWritingLeavesADamagedRecording_D_107) {
  deck.begin_writing(program(1, 4800), now);
  pass(seconds(6));
  deck.end_leader(now);
  pass(seconds(5));
  deck.stop(now);
  EXPECT_FALSE(deck.motor_runs());
  EXPECT_TRUE(events.empty());
  rewind();
  EXPECT_EQ(fault_of(read(std::nullopt)), DeckFault::damaged);
}

TEST_F(Deck, StopWhileReadingTakesNothingOver_D_107) {
  write(program(1, 4800), seconds(6));
  events.clear();
  rewind();
  deck.begin_reading(1, now);
  pass(seconds(9));
  EXPECT_TRUE(deck.is_reading());
  deck.stop(now);
  pass(seconds(60));
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(deck.counter(), 9);
}

TEST_F(Deck, RecordingOverTheBeginningOfAnotherLosesIt) {
  write(program(1, 4800), seconds(6));
  rewind();
  write(program(2, 100), seconds(8));  // the head passes the mark of P0001
  rewind();
  EXPECT_EQ(program_of(read(std::nullopt)), 2);
  EXPECT_EQ(fault_of(read(std::nullopt)), DeckFault::end_of_tape);
}

TEST_F(Deck, RecordingIntoAnotherCutsIt) {
  write(program(1, 4800), seconds(6));
  Cassette tape = deck.cassette();
  tape.wind_to(10'000);
  put_in(tape);
  write(program(2, 100), Time(0));
  rewind();
  EXPECT_EQ(fault_of(read(1)), DeckFault::damaged);
  EXPECT_EQ(program_of(read(2)), 2);
}

TEST_F(Deck, TheTapeEnds) {
  Cassette tape;
  tape.wind_to(kTapeLength_ms - 3000);
  put_in(tape);
  write(program(1, 4800), Time(0));
  EXPECT_EQ(fault_of(events.at(0)), DeckFault::end_of_tape);
  EXPECT_EQ(fault_of(read(std::nullopt)), DeckFault::end_of_tape);
  deck.begin_writing(program(1), now);  // a held key at the end
  pass(seconds(10));
  EXPECT_FALSE(deck.motor_runs());
}

TEST_F(Deck, WindingIsTwentyTimesAsFast) {
  Cassette tape;
  tape.wind_to(kTapeLength_ms);
  put_in(tape);
  deck.rewind(now);
  pass(seconds(45));
  EXPECT_EQ(deck.cassette().position_ms(), kTapeLength_ms / 2);
  pass(seconds(45));
  EXPECT_FALSE(deck.motor_runs());
  deck.wind_on(now);
  pass(seconds(1));
  deck.stop(now);
  EXPECT_EQ(deck.cassette().position_ms(), 20'000u);
}

TEST_F(Deck, ARunningMotorTakesNoOtherOrder) {
  deck.begin_writing(program(1), now);
  deck.begin_reading(1, now);
  deck.rewind(now);
  EXPECT_EQ(deck.state(), State::leader);
}

TEST(ReadingDash, ChangesFourTimesASecond_D_106) {
  std::string dashes;
  for (int quarter = 0; quarter < 5; ++quarter) dashes += reading_dash(milliseconds(250 * quarter));
  EXPECT_EQ(dashes, "|/-\\|");
  EXPECT_EQ(reading_dash(milliseconds(249)), '|');
}

}  // namespace
}  // namespace cnclab::transfer
