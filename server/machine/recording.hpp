// A run as it went over the seam to the machine: the outputs and inputs of every tick, packed into bytes.
//
// Format, version 1; numbers without a size are varints (7 bits per byte, low ones first, top bit = more follows),
// signed ones zigzag (0 −1 1 −2 → 0 1 2 3)
//
//   recording = "CNCR" version:u8 tick
//   tick      = tag:u8 [steps] [outputs] [inputs]
//   tag         bit 0..3 axis X Y Z U has steps in this tick, bit 4 outputs changed, bit 5 inputs changed; 6, 7 zero
//   steps     = signed for each axis that has some, X first
//   outputs   = flags:u8 rpm:signed card_1:u8 card_2:u8 s_digits:signed
//     flags     bit 0 drives on, 1 start, 2 coolant, 3 signal, 4..5 spindle (0 off, 1 clockwise, 2 counterclockwise)
//   inputs    = plus_minus:u8 flags:u8 card_1:u8 card_2:u8
//     plus_minus  bit 0..3 limit_plus X..U, 4..7 limit_minus;   flags  bit 0 Input 1, 1 fault
//
// Example: one tick with 3 steps of X and −1 of Z, nothing else changed: 05 06 01. A tick at rest is one byte, a moving
// one two to five; ten minutes are some 2 MB. Before the first tick the outputs and inputs are those of a new `Outputs`
// and `Inputs`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string_view>

#include "machine/machine.hpp"

namespace cnclab::machine {

/// What passed in one tick.
struct RecordedTick {
  Outputs outputs;
  Inputs inputs;
  friend bool operator==(const RecordedTick&, const RecordedTick&) = default;
};

inline constexpr std::size_t kRecordingHeader = 5;
/// No tick is longer than this.
inline constexpr std::size_t kLongestTick = 40;

/// Writes ticks one after the other into memory of the caller's. Allocates nothing.
class RecordingWriter {
 public:
  /// out   at least kRecordingHeader bytes; the header is written at once
  explicit RecordingWriter(std::span<std::uint8_t> out) noexcept;
  /// False when the tick did not fit: nothing was written, and nothing more will be.
  [[nodiscard]] bool write(const RecordedTick& tick) noexcept;
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
  RecordedTick last_;
  bool is_full_ = false;
};

/// Reads them again. The bytes may come from anywhere.
class RecordingReader {
 public:
  /// bytes   outlive the reader
  explicit RecordingReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  /// The next tick; nothing at the end.
  /// errors   what is wrong, in a few words; the reader stays at its end
  [[nodiscard]] std::expected<std::optional<RecordedTick>, std::string_view> next() noexcept;

 private:
  [[nodiscard]] std::optional<std::uint8_t> byte() noexcept;
  [[nodiscard]] std::optional<std::int32_t> number() noexcept;
  [[nodiscard]] bool read_outputs() noexcept;
  [[nodiscard]] bool read_inputs() noexcept;
  [[nodiscard]] std::unexpected<std::string_view> fail(std::string_view why) noexcept;

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  RecordedTick tick_;
};

}  // namespace cnclab::machine
