// What happens to the recordings on a tape, and how a cassette is kept.
#include "transfer/cassette.hpp"

#include <algorithm>

#include "transfer/big_endian.hpp"

namespace cnclab::transfer {

namespace {

constexpr std::string_view kMagic = "CNCK";
constexpr std::uint32_t kVersion = 1;

/// Bytes that have passed the head after so long.
constexpr std::size_t bytes_in(std::uint32_t ms) {
  return static_cast<std::size_t>(std::uint64_t{ms} * kTapeBytesPerSecond / 1000);
}

/// Takes numbers and bytes from the front; once something is missing everything is.
class Source {
 public:
  explicit Source(std::string_view bytes) : rest_(bytes) {}

  std::string_view take(std::size_t length) {
    if (length > rest_.size()) is_short_ = true;
    const std::string_view taken = rest_.substr(0, is_short_ ? 0 : length);
    rest_.remove_prefix(taken.size());
    return taken;
  }
  std::uint32_t number() { return big_endian(take(4)); }
  [[nodiscard]] bool is_short() const { return is_short_; }
  [[nodiscard]] bool is_empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  bool is_short_ = false;
};

}  // namespace

int Cassette::counter() const {
  const int counts =
      static_cast<int>(position_ms_ / kCounterStep_ms) - static_cast<int>(counter_zero_ms_ / kCounterStep_ms);
  return (counts % kCounterReadings + kCounterReadings) % kCounterReadings;
}

void Cassette::wind_to(std::uint32_t position_ms) { position_ms_ = std::min(position_ms, kTapeLength_ms); }

void Cassette::erase(std::uint32_t from_ms, std::uint32_t to_ms) {
  if (from_ms >= to_ms) return;
  std::erase_if(pieces_, [&](const TapePiece& piece) { return piece.start_ms >= from_ms && piece.start_ms < to_ms; });
  for (TapePiece& piece : pieces_)
    if (piece.start_ms < from_ms && piece.end_ms() > from_ms)
      piece.bytes.resize(std::min(piece.bytes.size(), bytes_in(from_ms - piece.start_ms)));
  std::erase_if(pieces_, [](const TapePiece& piece) { return piece.bytes.empty(); });
}

bool Cassette::record(std::uint32_t start_ms, std::string_view bytes) {
  const std::uint32_t begin_ms = std::min(start_ms, kTapeLength_ms);
  const std::string_view kept = bytes.substr(0, bytes_in(kTapeLength_ms - begin_ms));
  erase(begin_ms, begin_ms + play_ms(kept.size()));
  if (begin_ms < kTransparent_ms || kept.empty()) return false;
  const auto behind = std::ranges::find_if(pieces_, [&](const TapePiece& piece) { return piece.start_ms > begin_ms; });
  pieces_.insert(behind, TapePiece{.start_ms = begin_ms, .bytes = std::string(kept)});
  return true;
}

const TapePiece* Cassette::next_piece(std::uint32_t from_ms) const {
  const auto found = std::ranges::find_if(pieces_, [&](const TapePiece& piece) { return piece.start_ms >= from_ms; });
  return found == pieces_.end() ? nullptr : &*found;
}

bool Cassette::damage(std::size_t piece, std::size_t byte) {
  if (piece >= pieces_.size() || byte >= pieces_[piece].bytes.size()) return false;
  char& hit = pieces_[piece].bytes[byte];
  hit = static_cast<char>(hit ^ 0x10);
  return true;
}

std::string Cassette::serialized() const {
  std::string bytes(kMagic);
  append_big_endian(bytes, kVersion, 4);
  append_big_endian(bytes, position_ms_, 4);
  append_big_endian(bytes, counter_zero_ms_, 4);
  append_big_endian(bytes, static_cast<std::uint32_t>(pieces_.size()), 4);
  for (const TapePiece& piece : pieces_) {
    append_big_endian(bytes, piece.start_ms, 4);
    append_big_endian(bytes, static_cast<std::uint32_t>(piece.bytes.size()), 4);
    bytes += piece.bytes;
  }
  return bytes;
}

std::expected<Cassette, std::string_view> Cassette::deserialize(std::string_view bytes) {
  if (bytes.size() > kLargestCassette) return std::unexpected("larger than a cassette");
  Source source(bytes);
  if (source.take(kMagic.size()) != kMagic) return std::unexpected("no cassette");
  if (source.number() != kVersion) return std::unexpected("version unknown");
  Cassette cassette;
  cassette.position_ms_ = source.number();
  cassette.counter_zero_ms_ = source.number();
  if (cassette.position_ms_ > kTapeLength_ms || cassette.counter_zero_ms_ > kTapeLength_ms)
    return std::unexpected("stands behind the end");
  std::uint32_t free_from_ms = kTransparent_ms;
  for (std::uint32_t left = source.number(); left > 0 && !source.is_short(); --left) {
    const std::uint32_t start_ms = source.number();
    const std::string_view content = source.take(source.number());
    if (source.is_short()) break;
    if (start_ms < free_from_ms || start_ms >= kTapeLength_ms || content.empty() ||
        content.size() > bytes_in(kTapeLength_ms - start_ms))
      return std::unexpected("recordings do not lie one behind the other");
    free_from_ms = cassette.pieces_.emplace_back(start_ms, std::string(content)).end_ms();
  }
  if (source.is_short() || !source.is_empty()) return std::unexpected("length is wrong");
  return cassette;
}

}  // namespace cnclab::transfer
