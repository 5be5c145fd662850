// What is plugged into a control: the place for files, the printer, the recorder. The serial line: control_line.cpp.
#include <utility>

#include "panel/control_impl.hpp"

namespace cnclab::panel {

void Control::connect_media(bool is_connected) { impl_->state.has_media = is_connected; }

void Control::connect_printer(bool is_connected) { impl_->state.has_printer = is_connected; }

bool Control::awaits_media() const { return impl_->state.is_media_pending && !impl_->state.is_media_stale; }

void Control::order_picture() {
  if (auto* graphics = std::get_if<GraphicsMode>(&impl_->active)) panel::order_picture(*graphics);
}

void Control::media_done(const std::expected<std::string, std::string>& answer) {
  ControlState& state = impl_->state;
  if (!std::exchange(state.is_media_pending, false)) return;
  if (!std::exchange(state.is_media_stale, false)) impl_->media_answer = answer;
}

void Control::insert_cassette(transfer::Cassette cassette, const Now& now) {
  impl_->state.now = now;
  if (!recorder_runs()) impl_->state.recorder.emplace(std::move(cassette), impl_->time());
}

void Control::eject_cassette() {
  if (!recorder_runs()) impl_->state.recorder.reset();
}

std::optional<transfer::Cassette> Control::cassette() const {
  if (!impl_->state.recorder) return std::nullopt;
  return impl_->state.recorder->cassette();
}

bool Control::recorder_runs() const { return impl_->state.recorder && impl_->state.recorder->motor_runs(); }

void Control::press_recorder(RecorderKey key, const Now& now) {
  impl_->state.now = now;
  if (!impl_->state.recorder) return;
  transfer::CassetteDeck& recorder = *impl_->state.recorder;
  switch (key) {
    case RecorderKey::rewind:
      return recorder.rewind(impl_->time());
    case RecorderKey::wind_on:
      return recorder.wind_on(impl_->time());
    case RecorderKey::stop:
      return recorder.stop(impl_->time());
    case RecorderKey::zero_counter:
      return recorder.zero_counter();
  }
}

}  // namespace cnclab::panel
