// The recorder's states, one function for each that moves the tape.
#include "transfer/cassette_deck.hpp"

#include <algorithm>
#include <string_view>

namespace cnclab::transfer {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPause{1000};         // EXT-012
constexpr std::uint32_t kWindingSpeed = 20;  // 90 s for a whole side

std::uint32_t ms_between(Time from, Time to) {
  const auto passed = std::chrono::duration_cast<milliseconds>(to - from).count();
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(passed, 0, kTapeLength_ms));
}

}  // namespace

void CassetteDeck::start(State state, Time now) {
  now_ = std::max(now_, now);
  state_ = state;
  began_ = now_;
  from_ms_ = cassette_.position_ms();
  adopts_machine_data_ = false;
}

void CassetteDeck::begin_writing(const Payload& payload, Time now) {
  if (motor_runs()) return;
  bytes_ = encode_recording(payload);
  start(State::leader, now);
}

void CassetteDeck::end_leader(Time now) {
  if (state_ != State::leader) return;
  now_ = std::max(now_, now);
  state_ = State::pause;
  data_ms_ = from_ms_ + ms_between(began_, now_) + static_cast<std::uint32_t>(kPause.count());
}

void CassetteDeck::begin_reading(std::optional<std::uint16_t> program, Time now) {
  if (motor_runs()) return;
  sought_ = program;
  start(State::searching, now);
}

void CassetteDeck::rewind(Time now) {
  if (!motor_runs()) start(State::rewinding, now);
}

void CassetteDeck::wind_on(Time now) {
  if (!motor_runs()) start(State::winding, now);
}

void CassetteDeck::stop(Time now) {
  static_cast<void>(advance(now));
  cut_off();
  state_ = State::still;
}

/// What was sent up to now is on the tape.
void CassetteDeck::cut_off() {
  if (state_ != State::sending) return;
  const std::size_t sent = std::size_t{cassette_.position_ms() - data_ms_} * kTapeBytesPerSecond / 1000;
  static_cast<void>(cassette_.record(data_ms_, std::string_view(bytes_).substr(0, sent)));
}

void CassetteDeck::adopt_machine_data() {
  if (state_ == State::searching || state_ == State::reading) adopts_machine_data_ = true;
}

std::optional<DeckEvent> CassetteDeck::advance(Time now) {
  now_ = std::max(now_, now);
  const std::uint32_t passed_ms = ms_between(began_, now_);
  switch (state_) {
    case State::still:
      return std::nullopt;
    case State::leader:
    case State::pause:
    case State::sending:
    case State::searching:
    case State::reading:
      return play_to(from_ms_ + passed_ms);
    case State::rewinding:
      cassette_.wind_to(from_ms_ - std::min(from_ms_, passed_ms * kWindingSpeed));
      if (cassette_.position_ms() == 0) state_ = State::still;
      return std::nullopt;
    case State::winding:
      cassette_.wind_to(from_ms_ + passed_ms * kWindingSpeed);
      if (cassette_.position_ms() == kTapeLength_ms) state_ = State::still;
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<DeckEvent> CassetteDeck::play_to(std::uint32_t position_ms) {
  if (state_ == State::searching) {
    if (auto event = search_to(position_ms)) return event;
  }
  if (state_ == State::reading) return read_to(position_ms);
  if (state_ == State::searching) return std::nullopt;
  return send_to(position_ms);
}

/// Leader, pause and bytes: the head erases as it goes.
std::optional<DeckEvent> CassetteDeck::send_to(std::uint32_t position_ms) {
  const std::uint32_t end_ms = data_ms_ + play_ms(bytes_.size());
  const bool has_data = state_ != State::leader;
  const std::uint32_t reached_ms = std::min({position_ms, has_data ? end_ms : kTapeLength_ms, kTapeLength_ms});
  cassette_.erase(cassette_.position_ms(), reached_ms);
  cassette_.wind_to(reached_ms);
  if (state_ == State::pause && reached_ms >= data_ms_) state_ = State::sending;
  if (has_data && reached_ms == end_ms) {
    const bool is_kept = cassette_.record(data_ms_, bytes_);
    return finish(Written{.is_lost = !is_kept}, end_ms);
  }
  if (reached_ms < kTapeLength_ms) return std::nullopt;
  cut_off();
  return finish(DeckFailed{DeckFault::end_of_tape}, kTapeLength_ms);
}

/// Passes the marks of recordings that are not the one.
std::optional<DeckEvent> CassetteDeck::search_to(std::uint32_t position_ms) {
  while (const TapePiece* piece = cassette_.next_piece(cassette_.position_ms())) {
    const std::uint32_t recognised_ms = piece->start_ms + play_ms(std::min(kMarkLength, piece->bytes.size()));
    if (recognised_ms > position_ms) break;
    const auto mark = decode_mark(piece->bytes);
    if (!mark) return finish(DeckFailed{DeckFault::damaged}, recognised_ms);
    if (!sought_ || (!mark->is_whole_memory && mark->program == *sought_)) {
      data_ms_ = piece->start_ms;
      state_ = State::reading;
      return std::nullopt;
    }
    cassette_.wind_to(recognised_ms);
  }
  // A mark that is just passing the head is still to be recognised: its beginning stays ahead.
  const TapePiece* piece = cassette_.next_piece(cassette_.position_ms());
  const std::uint32_t next_ms = piece == nullptr ? kTapeLength_ms : piece->start_ms;
  cassette_.wind_to(std::min(position_ms, next_ms));
  if (position_ms < kTapeLength_ms || piece != nullptr) return std::nullopt;
  return finish(DeckFailed{DeckFault::end_of_tape}, kTapeLength_ms);
}

std::optional<DeckEvent> CassetteDeck::read_to(std::uint32_t position_ms) {
  const TapePiece* piece = cassette_.next_piece(data_ms_);
  if (piece == nullptr) return finish(DeckFailed{DeckFault::damaged}, cassette_.position_ms());
  auto payload = decode_recording(piece->bytes);
  const std::uint32_t over_ms = payload ? piece->end_ms() : piece->start_ms + play_ms(payload.error().at);
  if (position_ms < over_ms) {
    cassette_.wind_to(position_ms);
    return std::nullopt;
  }
  if (!payload) return finish(DeckFailed{DeckFault::damaged}, over_ms);
  return finish(WasRead{.payload = std::move(*payload), .adopts_machine_data = adopts_machine_data_}, over_ms);
}

DeckEvent CassetteDeck::finish(DeckEvent event, std::uint32_t position_ms) {
  cassette_.wind_to(position_ms);
  state_ = State::still;
  return event;
}

double CassetteDeck::progress() const {
  const TapePiece* piece = state_ == State::reading ? cassette_.next_piece(data_ms_) : nullptr;
  const std::size_t bytes = state_ == State::sending ? bytes_.size() : piece != nullptr ? piece->bytes.size() : 0;
  if (bytes == 0 || cassette_.position_ms() <= data_ms_) return 0;
  return std::min(1.0, static_cast<double>(cassette_.position_ms() - data_ms_) / play_ms(bytes));
}

char reading_dash(Time now) {
  constexpr std::string_view kDashes = "|/-\\";
  constexpr milliseconds kEach{250};
  return kDashes[static_cast<std::size_t>(now / kEach) % kDashes.size()];
}

}  // namespace cnclab::transfer
