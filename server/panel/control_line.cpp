// The serial line of a control: what the lab connects, brings and takes (panel/run/serial_port.hpp).
#include "panel/control_impl.hpp"
#include "panel/remote_line.hpp"

namespace cnclab::panel {

namespace {
constexpr int kBaudDatum = 20;
}  // namespace

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
