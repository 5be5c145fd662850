// A tape cassette as a value: what was recorded where, and where the tape stands (DEC-33). The recorder is
// cassette_deck.hpp.
//
//   0 s        5 s                                                                            1800 s
//   │transparent│   leader │ recording │      blank      │ leader │ recording │      blank       │
//
// Distances on the tape are given in time of play, milliseconds. 480 bytes pass per second, as on the line at 4800
// baud; a side of 30 minutes holds 864 000 bytes. The transparent part at the beginning takes no magnetism (D-105).
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

namespace cnclab::transfer {

inline constexpr std::uint32_t kTapeLength_ms = 30 * 60 * 1000;
inline constexpr std::uint32_t kTransparent_ms = 5000;  ///< counter reading 5 (EXT-011)
inline constexpr std::uint32_t kTapeBytesPerSecond = 480;
inline constexpr std::uint32_t kCounterStep_ms = 1000;  ///< one count of the counter
inline constexpr int kCounterReadings = 1000;           ///< three digits

/// Time of play of so many bytes.
[[nodiscard]] constexpr std::uint32_t play_ms(std::size_t bytes) {
  return static_cast<std::uint32_t>((bytes * 1000 + kTapeBytesPerSecond - 1) / kTapeBytesPerSecond);
}

/// One recording on the tape.
struct TapePiece {
  std::uint32_t start_ms = 0;  ///< of its start mark, behind the leader; >= kTransparent_ms
  std::string bytes;           ///< as cassette_recording.hpp, at least 1 byte; may be damaged or cut off
  [[nodiscard]] std::uint32_t end_ms() const { return start_ms + play_ms(bytes.size()); }
  friend bool operator==(const TapePiece&, const TapePiece&) = default;
};

/// Invariant: pieces in the order of the tape, none overlaps another, all of them on the magnetic part.
class Cassette {
 public:
  [[nodiscard]] const std::vector<TapePiece>& pieces() const { return pieces_; }
  [[nodiscard]] std::uint32_t position_ms() const { return position_ms_; }
  /// Three digits, as the counter shows them since it was zeroed.
  [[nodiscard]] int counter() const;
  void zero_counter() { counter_zero_ms_ = position_ms_; }
  void wind_to(std::uint32_t position_ms);  ///< at most to the end

  /// The recording head passes from..to with the motor running: what lay there is gone. A piece that began before is
  /// cut off, one that was begun upon is lost as a whole, since its start mark is.
  void erase(std::uint32_t from_ms, std::uint32_t to_ms);
  /// Records `bytes` from `start_ms` on, as much of it as there is tape for.
  /// returns   false when it was lost on the transparent part: nothing of it can be found again
  bool record(std::uint32_t start_ms, std::string_view bytes);
  /// The first piece whose start mark lies at or behind `from_ms`, or nullptr.
  [[nodiscard]] const TapePiece* next_piece(std::uint32_t from_ms) const;

  /// One byte as it is not supposed to be: dust, creases. For tests and demonstrations; false where there is no such
  /// byte.
  bool damage(std::size_t piece, std::size_t byte);

  /// The form in which the database keeps it: "CNCK", version 1, position, counter zero (4 bytes each), number of
  /// pieces (4), then for each: start, length (4 each), bytes. Big-endian; at most kLargestCassette bytes.
  [[nodiscard]] std::string serialized() const;
  /// errors   what is wrong, in English, for the log; any bytes may be given
  [[nodiscard]] static std::expected<Cassette, std::string_view> deserialize(std::string_view bytes);

  friend bool operator==(const Cassette&, const Cassette&) = default;

 private:
  std::vector<TapePiece> pieces_;
  std::uint32_t position_ms_ = 0;
  std::uint32_t counter_zero_ms_ = 0;
};

inline constexpr std::size_t kLargestCassette = 1'048'576;  ///< DEC-33

}  // namespace cnclab::transfer
