// Screens collapse to the newest one.
#include "lab/screen_feed.hpp"

#include <utility>

namespace cnclab::lab {

void ScreenFeed::offer(const View& view, int beeps) {
  newest_ = view;
  beeps_ += beeps;
}

std::optional<v1::ScreenUpdate> ScreenFeed::next(RowForm form) {
  if (in_flight_ || (newest_ == acknowledged_ && beeps_ == 0)) return std::nullopt;
  v1::ScreenUpdate update;
  update.set_number(++number_);
  write_rows(acknowledged_.screen, newest_.screen, update, form);
  update.set_handled_key(newest_.handled_key);
  update.set_state(newest_.state);
  update.set_beeps(static_cast<std::uint32_t>(std::exchange(beeps_, 0)));
  update.set_alarm_tone(newest_.alarm_tone);
  in_flight_ = newest_;
  return update;
}

bool ScreenFeed::acknowledge(std::uint64_t number) {
  if (!in_flight_ || number != number_) return false;
  acknowledged_ = *std::exchange(in_flight_, std::nullopt);
  return true;
}

}  // namespace cnclab::lab
