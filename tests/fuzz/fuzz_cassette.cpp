// Feeds any bytes to the cassette's reader: what it takes must come back equal, and the recorder must be able to play
// and to record over it, whatever lies on the tape.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "transfer/cassette_deck.hpp"

namespace transfer = cnclab::transfer;

namespace {

void require(bool is_right) {
  if (!is_right) std::abort();
}

void play(const transfer::Cassette& cassette) {
  transfer::Time now{0};
  transfer::Cassette rewound = cassette;
  rewound.wind_to(0);
  transfer::CassetteDeck deck(rewound, now);
  for (std::size_t reading = 0; reading <= cassette.pieces().size(); ++reading) {
    deck.begin_reading(std::nullopt, now);
    require(deck.advance(now += std::chrono::hours(1)).has_value());
    require(!deck.motor_runs());
  }
}

void record(const transfer::Cassette& cassette) {
  transfer::Time now{0};
  transfer::CassetteDeck deck(cassette, now);
  deck.begin_writing({.program = 1, .text = "P0001N001G05%"}, now);
  deck.end_leader(now);
  require(deck.advance(now += std::chrono::hours(1)).has_value());
  const auto kept = transfer::Cassette::deserialize(deck.cassette().serialized());
  require(kept.has_value() && *kept == deck.cassette());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  static_cast<void>(transfer::decode_recording(bytes));
  const auto cassette = transfer::Cassette::deserialize(bytes);
  if (!cassette) return 0;
  require(cassette->serialized() == bytes);
  play(*cassette);
  record(*cassette);
  return 0;
}
