// What lies on a tape, and how it is kept (DEC-33).
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cstdlib>

#include "transfer/cassette.hpp"
#include "transfer/cassette_recording.hpp"

namespace cnclab::transfer {
namespace {

std::string text_of(std::size_t length) {
  std::string text;
  for (std::size_t i = 0; i < length; ++i) text += static_cast<char>('!' + i % 60);
  return text;
}

TEST(Recording, ComesBack) {
  for (const std::size_t length : {0U, 1U, 127U, 128U, 129U, 4096U}) {
    const Payload payload{.program = 9999, .text = text_of(length)};
    const std::string bytes = encode_recording(payload);
    EXPECT_EQ(bytes.size(), recording_length(length));
    const auto read = decode_recording(bytes);
    ASSERT_TRUE(read.has_value()) << length;
    EXPECT_EQ(*read, payload);
  }
}

TEST(Recording, TheStartMarkSaysWhatFollows) {
  const auto mark = decode_mark(encode_recording({.is_whole_memory = true, .program = 0, .text = "P0000%"}));
  ASSERT_TRUE(mark.has_value());
  EXPECT_TRUE(mark->is_whole_memory);
  EXPECT_EQ(mark->text_length, 6u);
}

/// Every single byte, hit in every bit (D-107).
TEST(Recording, EveryDamagedByteIsFound) {
  const std::string bytes = encode_recording({.program = 1, .text = text_of(300)});
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      ASSERT_FALSE(decode_recording(damaged).has_value()) << at << "." << bit;
    }
}

TEST(Recording, ACutOffEndAndExchangedBlocksAreFound) {
  std::string text(256, 'A');
  text.replace(128, 128, std::string(128, 'B'));
  const std::string bytes = encode_recording({.program = 1, .text = text});
  for (std::size_t length = 0; length < bytes.size(); ++length)
    ASSERT_FALSE(decode_recording(bytes.substr(0, length)).has_value()) << length;
  const std::string first = bytes.substr(kMarkLength, kRecordingBlockLength);
  const std::string second = bytes.substr(kMarkLength + kRecordingBlockLength);
  EXPECT_FALSE(decode_recording(bytes.substr(0, kMarkLength) + second + first).has_value());
}

/// `cnclab-tool verify` names what is damaged (DEC-33); what the tape did not take is no damage.
TEST(Recording, ItsFaultsAreTheMarkOrEachDamagedBlock_DEC_33) {
  const std::string bytes = encode_recording({.program = 1, .text = text_of(300)});  // blocks of 128, 128 and 44 bytes
  const auto with_hits = [&](const std::vector<std::size_t>& places) {
    std::string damaged = bytes;
    for (const std::size_t at : places) damaged[at] = static_cast<char>(damaged[at] ^ 1);
    return recording_faults(damaged);
  };
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const RecordingFaults faults = with_hits({at});
    EXPECT_EQ(faults.is_mark_damaged, at < kMarkLength) << at;
    const auto block = static_cast<std::uint32_t>((at - kMarkLength) / kRecordingBlockLength);
    EXPECT_EQ(faults.blocks, at < kMarkLength ? std::vector<std::uint32_t>{} : std::vector{block}) << at;
  }
  EXPECT_EQ(with_hits({kMarkLength, bytes.size() - 1}).blocks, (std::vector{0U, 2U}));
}

TEST(Recording, WhatIsCutOffHasTheFaultsOfItsRest_DEC_33) {
  std::string bytes = encode_recording({.program = 1, .text = text_of(300)});
  for (std::size_t length = 0; length <= bytes.size(); ++length) {
    const RecordingFaults faults = recording_faults(std::string_view(bytes).substr(0, length));
    EXPECT_FALSE(faults.is_mark_damaged) << length;
    EXPECT_TRUE(faults.blocks.empty()) << length;
  }
  bytes[kMarkLength + 5] ^= 1;
  EXPECT_EQ(recording_faults(bytes.substr(0, kMarkLength + kRecordingBlockLength + 9)).blocks, (std::vector{0U}));
}

TEST(Cassette, RecordingsLieWhereTheyWereMade) {
  Cassette cassette;
  EXPECT_TRUE(cassette.record(6000, std::string(480, 'a')));  // one second
  EXPECT_TRUE(cassette.record(9000, "b"));
  EXPECT_EQ(cassette.pieces()[0].end_ms(), 7000u);
  EXPECT_EQ(cassette.next_piece(6001)->start_ms, 9000u);
  EXPECT_EQ(cassette.next_piece(9001), nullptr);
}

TEST(Cassette, TheTransparentPartTakesNothing_D_105) {
  Cassette cassette;
  EXPECT_FALSE(cassette.record(4999, "a"));
  EXPECT_TRUE(cassette.pieces().empty());
  EXPECT_TRUE(cassette.record(5000, "a"));
}

TEST(Cassette, WhatIsRecordedOverIsGone) {
  Cassette cassette;
  EXPECT_TRUE(cassette.record(10'000, std::string(4800, 'a')));  // 10 s
  EXPECT_TRUE(cassette.record(30'000, std::string(4800, 'b')));
  EXPECT_TRUE(cassette.record(15'000, std::string(9600, 'c')));  // cuts a, takes the beginning of b
  ASSERT_EQ(cassette.pieces().size(), 2u);
  EXPECT_EQ(cassette.pieces()[0].bytes, std::string(2400, 'a'));
  EXPECT_EQ(cassette.pieces()[1].bytes[0], 'c');
}

TEST(Cassette, TheTapeHasAnEnd) {
  Cassette cassette;
  EXPECT_TRUE(cassette.record(kTapeLength_ms - 1000, std::string(1000, 'a')));
  EXPECT_EQ(cassette.pieces()[0].bytes.size(), 480u);
  EXPECT_FALSE(cassette.record(kTapeLength_ms, "a"));
  cassette.wind_to(kTapeLength_ms + 5);
  EXPECT_EQ(cassette.position_ms(), kTapeLength_ms);
}

TEST(Cassette, TheCounterHasThreeDigits) {
  Cassette cassette;
  cassette.wind_to(12'900);
  EXPECT_EQ(cassette.counter(), 12);
  cassette.zero_counter();
  EXPECT_EQ(cassette.counter(), 0);
  cassette.wind_to(0);
  EXPECT_EQ(cassette.counter(), 988);
  cassette.wind_to(1'500'000);
  EXPECT_EQ(cassette.counter(), 488);
}

TEST(Cassette, AFullSideFitsIntoTheDatabasesForm) {
  Cassette cassette;
  EXPECT_TRUE(cassette.record(kTransparent_ms, std::string(2'000'000, 'a')));
  EXPECT_LE(cassette.serialized().size(), kLargestCassette);
  EXPECT_TRUE(Cassette::deserialize(cassette.serialized()).has_value());
}

/// After any recordings, erasures and damages the invariant holds, and the cassette comes back from its kept form.
TEST(Cassette, AnyHistoryKeepsItsInvariant) {
  setenv("RC_PARAMS", "seed=3300 max_success=300", 0);
  EXPECT_TRUE(rc::check([](const std::vector<std::pair<std::uint32_t, std::uint16_t>>& history) {
    Cassette cassette;
    for (const auto& [place, length] : history) {
      const std::uint32_t at_ms = place % 40'000;
      if (length % 3 == 0)
        cassette.erase(at_ms, at_ms + length % 5000);
      else
        static_cast<void>(cassette.record(at_ms, std::string(length % 5000, 'x')));
      if (length % 7 == 0) static_cast<void>(cassette.damage(place % 4, length % 100));
      cassette.wind_to(at_ms);
      if (length % 5 == 0) cassette.zero_counter();
      std::uint32_t free_from_ms = kTransparent_ms;
      for (const TapePiece& piece : cassette.pieces()) {
        RC_ASSERT(piece.start_ms >= free_from_ms && !piece.bytes.empty());
        free_from_ms = piece.end_ms();
      }
      RC_ASSERT(free_from_ms <= kTapeLength_ms);
    }
    const auto kept = Cassette::deserialize(cassette.serialized());
    RC_ASSERT(kept.has_value());
    RC_ASSERT(*kept == cassette);
  }));
}

TEST(Cassette, AMalformedFormIsRefused) {
  Cassette cassette;
  EXPECT_TRUE(cassette.record(6000, "abc"));
  EXPECT_TRUE(cassette.record(9000, "def"));
  const std::string good = cassette.serialized();
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_FALSE(Cassette::deserialize(good.substr(0, length)).has_value()) << length;
  EXPECT_FALSE(Cassette::deserialize(good + "x").has_value());
  const auto with = [&](std::size_t at, std::string_view bytes) {
    std::string changed = good;
    changed.replace(at, bytes.size(), bytes);
    return Cassette::deserialize(changed);
  };
  EXPECT_EQ(with(0, "CNCX").error(), "no cassette");
  EXPECT_EQ(with(7, "\x02").error(), "version unknown");
  EXPECT_EQ(with(8, "\xFF").error(), "stands behind the end");
  EXPECT_EQ(with(16, "\xFF").error(), "length is wrong");
  EXPECT_EQ(with(24, "\xFF\xFF\xFF\xFF").error(), "length is wrong");
  EXPECT_EQ(with(20, std::string_view("\0\0\x13\x87", 4)).error(), "recordings do not lie one behind the other");
  EXPECT_EQ(Cassette::deserialize(std::string(kLargestCassette + 1, 'C')).error(), "larger than a cassette");
}

}  // namespace
}  // namespace cnclab::transfer
