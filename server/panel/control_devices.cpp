// What is plugged into a control: the place for files, the printer, the recorder, the serial line.
#include <utility>

#include "panel/control_impl.hpp"
#include "panel/remote_line.hpp"

namespace cnclab::panel {

namespace {
constexpr int kBaudDatum = 20;
}  // namespace

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

void Control::fit_line(LineFitting fitting) { impl_->state.port.fitting = std::move(fitting); }

void Control::set_remote(bool is_on) { impl_->state.settings.remote = is_on; }

bool Control::is_remote() const { return impl_->state.settings.remote; }

void Control::connect_line(bool is_connected, const Now& now) {
  impl_->state.now = now;
  panel::connect_line(impl_->active, impl_->state, is_connected);
}

std::size_t Control::line_received(std::string_view bytes, const Now& now) {
  impl_->state.now = now;
  return impl_->state.port.line.receive(bytes, impl_->time());
}

std::string Control::take_line_output(const Now& now, std::size_t most) {
  impl_->state.now = now;
  return impl_->state.port.line.take_output(impl_->time(), most);
}

bool Control::is_line_idle() const {
  const SerialPort& port = impl_->state.port;
  return !port.is_storing && !port.asked && port.line.is_idle();
}

int Control::line_baud() const { return static_cast<int>(impl_->state.data.get(kBaudDatum)); }

bool Control::is_line_reading() const { return impl_->state.port.line.is_reading(); }

std::optional<Armed> Control::armed() const {
  const auto* external = std::get_if<ExternalDataMode>(&impl_->active);
  return external == nullptr ? std::nullopt : external->armed;
}

Outcome Control::answer_remote_start(const std::string& refusal, const Now& now) {
  impl_->state.now = now;
  Outcome outcome;
  outcome.mode_changed = panel::answer_remote_start(impl_->active, impl_->state, refusal);
  impl_->hand_out_line(outcome);
  return outcome;
}

}  // namespace cnclab::panel
