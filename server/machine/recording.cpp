// Ticks to bytes and back.
#include "machine/recording.hpp"

#include <algorithm>
#include <array>

namespace cnclab::machine {

namespace {

constexpr std::array<std::uint8_t, kRecordingHeader> kHeader{'C', 'N', 'C', 'R', 1};
constexpr std::uint8_t kOutputsChanged = 0x10, kInputsChanged = 0x20, kKnownTags = 0x3F;

/// One tick's bytes before it is known whether they fit.
class Packet {
 public:
  void byte(std::uint8_t value) { bytes_[size_++] = value; }
  void number(std::int32_t value) {
    auto bits = (static_cast<std::uint32_t>(value) << 1U) ^ (value < 0 ? 0xFFFF'FFFFU : 0U);
    for (; bits >= 0x80; bits >>= 7U) byte(static_cast<std::uint8_t>(bits | 0x80U));
    byte(static_cast<std::uint8_t>(bits));
  }
  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

 private:
  std::array<std::uint8_t, kLongestTick> bytes_{};
  std::size_t size_ = 0;
};

std::uint8_t bit(bool value, unsigned place) { return static_cast<std::uint8_t>(value ? 1U << place : 0U); }

void put(Packet& packet, const Outputs& outputs) {
  const auto turn = static_cast<unsigned>(outputs.spindle);
  packet.byte(static_cast<std::uint8_t>(bit(outputs.drives_on, 0) | bit(outputs.start, 1) | bit(outputs.coolant, 2) |
                                        bit(outputs.signal, 3) | turn << 4U));
  packet.number(outputs.spindle_rpm);
  for (const std::uint8_t card : outputs.cards) packet.byte(card);
  packet.number(outputs.s_digits);
}

void put(Packet& packet, const Inputs& inputs) {
  std::uint8_t switches = 0;
  for (unsigned axis = 0; axis < 4; ++axis) {
    switches = static_cast<std::uint8_t>(switches | bit(inputs.limit_plus[axis], axis) |
                                         bit(inputs.limit_minus[axis], axis + 4));
  }
  packet.byte(switches);
  packet.byte(static_cast<std::uint8_t>(bit(inputs.input_1, 0) | bit(inputs.fault, 1)));
  for (const std::uint8_t card : inputs.cards) packet.byte(card);
}

/// Levels differ; steps are of one tick alone and do not count.
bool differ(Outputs a, const Outputs& b) {
  a.steps = b.steps;
  return a != b;
}

}  // namespace

RecordingWriter::RecordingWriter(std::span<std::uint8_t> out) noexcept : out_(out) {
  is_full_ = out.size() < kHeader.size();
  if (is_full_) return;
  std::ranges::copy(kHeader, out.begin());
  size_ = kHeader.size();
}

bool RecordingWriter::write(const RecordedTick& tick) noexcept {
  if (is_full_) return false;
  std::uint8_t tag = 0;
  for (unsigned axis = 0; axis < 4; ++axis) {
    tag = static_cast<std::uint8_t>(tag | bit(tick.outputs.steps[axis] != 0, axis));
  }
  const bool outputs_changed = differ(tick.outputs, last_.outputs), inputs_changed = tick.inputs != last_.inputs;
  if (outputs_changed) tag |= kOutputsChanged;
  if (inputs_changed) tag |= kInputsChanged;
  Packet packet;
  packet.byte(tag);
  for (const std::int32_t steps : tick.outputs.steps) {
    if (steps != 0) packet.number(steps);
  }
  if (outputs_changed) put(packet, tick.outputs);
  if (inputs_changed) put(packet, tick.inputs);
  const auto bytes = packet.bytes();
  is_full_ = size_ + bytes.size() > out_.size();
  if (is_full_) return false;
  std::ranges::copy(bytes, out_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += bytes.size();
  last_ = tick;
  return true;
}

std::optional<std::uint8_t> RecordingReader::byte() noexcept {
  if (at_ >= bytes_.size()) return std::nullopt;
  return bytes_[at_++];
}

std::optional<std::int32_t> RecordingReader::number() noexcept {
  constexpr unsigned kLastShift = 28;
  std::uint64_t bits = 0;
  for (unsigned shift = 0; shift <= kLastShift; shift += 7) {
    const auto next = byte();
    if (!next) return std::nullopt;
    bits |= std::uint64_t{*next & 0x7FU} << shift;
    if ((*next & 0x80U) != 0) continue;
    if (bits > 0xFFFF'FFFFU) return std::nullopt;
    const auto zigzag = static_cast<std::uint32_t>(bits);
    return static_cast<std::int32_t>((zigzag >> 1U) ^ ((zigzag & 1U) != 0 ? 0xFFFF'FFFFU : 0U));
  }
  return std::nullopt;
}

std::unexpected<std::string_view> RecordingReader::fail(std::string_view why) noexcept {
  at_ = bytes_.size();
  return std::unexpected(why);
}

bool RecordingReader::read_outputs() noexcept {
  const auto flags = byte();
  const auto rpm = number();
  const auto card_1 = byte(), card_2 = byte();
  const auto digits = number();
  constexpr unsigned kMostTurn = 2;
  if (!flags || !rpm || !card_1 || !card_2 || !digits || *flags >> 4U > kMostTurn) return false;
  Outputs& outputs = tick_.outputs;
  outputs.drives_on = (*flags & 1U) != 0;
  outputs.start = (*flags & 2U) != 0;
  outputs.coolant = (*flags & 4U) != 0;
  outputs.signal = (*flags & 8U) != 0;
  outputs.spindle = static_cast<geometry::SpindleTurn>(*flags >> 4U);
  outputs.spindle_rpm = *rpm;
  outputs.cards = {*card_1, *card_2};
  outputs.s_digits = *digits;
  return true;
}

bool RecordingReader::read_inputs() noexcept {
  const auto switches = byte(), flags = byte(), card_1 = byte(), card_2 = byte();
  if (!switches || !flags || !card_1 || !card_2 || *flags > 3) return false;
  Inputs& inputs = tick_.inputs;
  for (unsigned axis = 0; axis < 4; ++axis) {
    inputs.limit_plus[axis] = (*switches >> axis & 1U) != 0;
    inputs.limit_minus[axis] = (*switches >> (axis + 4) & 1U) != 0;
  }
  inputs.input_1 = (*flags & 1U) != 0;
  inputs.fault = (*flags & 2U) != 0;
  inputs.cards = {*card_1, *card_2};
  return true;
}

std::expected<std::optional<RecordedTick>, std::string_view> RecordingReader::next() noexcept {
  if (at_ == 0) {
    const bool is_ours = bytes_.size() >= kHeader.size() && std::ranges::equal(kHeader, bytes_.first(kHeader.size()));
    if (!is_ours) return fail("not a recording of this version");
    at_ = kHeader.size();
  }
  const auto tag = byte();
  if (!tag) return std::nullopt;
  if ((*tag & ~kKnownTags) != 0) return fail("unknown tag");
  tick_.outputs.steps = {};
  for (unsigned axis = 0; axis < 4; ++axis) {
    if ((*tag >> axis & 1U) == 0) continue;
    const auto steps = number();
    if (!steps) return fail("steps cut off or too large");
    tick_.outputs.steps[axis] = *steps;
  }
  if ((*tag & kOutputsChanged) != 0 && !read_outputs()) return fail("outputs cut off or wrong");
  if ((*tag & kInputsChanged) != 0 && !read_inputs()) return fail("inputs cut off or wrong");
  return tick_;
}

}  // namespace cnclab::machine
