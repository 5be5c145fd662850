// Characters and their times.
#include "transfer/line_pace.hpp"

#include <algorithm>
#include <array>

namespace cnclab::transfer {

bool is_line_speed(long baud) {
  constexpr std::array kSpeeds{300L, 600L, 1200L, 2400L, 4800L};
  return std::ranges::find(kSpeeds, baud) != kSpeeds.end();
}

Time LineSpeed::per_character() const {
  constexpr std::int64_t kBits = 10;  // start, 8 data, stop
  return is_paced ? Time(kBits * 1'000'000 / std::max(baud, 1)) : Time(0);
}

void LinePace::put(std::string_view bytes, Time now) {
  if (bytes.empty()) return;
  if (waiting() == 0) {
    bytes_.clear();
    taken_ = 0;
    due_ = std::max(due_, now) + speed_.per_character();
  }
  bytes_ += bytes;
}

std::optional<Time> LinePace::due() const {
  if (waiting() == 0) return std::nullopt;
  return due_;
}

char LinePace::take() {
  constexpr std::size_t kForgetBehind = 4096;
  const char next = bytes_[taken_++];
  if (waiting() > 0) due_ += speed_.per_character();
  if (taken_ >= kForgetBehind) {
    bytes_.erase(0, taken_);
    taken_ = 0;
  }
  return next;
}

void LinePace::clear() {
  bytes_.clear();
  taken_ = 0;
}

}  // namespace cnclab::transfer
