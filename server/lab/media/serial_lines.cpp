// Serial lines: bound by token or device, followed, cut.
#include "lab/media/serial_lines.hpp"

#include <fmt/format.h>
#include <sodium.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "lab/passwords.hpp"

namespace cnclab::lab {

namespace {

/// So much may wait at the far end; what is more waits in the control, where STOP can still take it back.
constexpr std::size_t kMostUnsent = 256;
constexpr std::int64_t kDash_ns = 250'000'000;  ///< D-106

/// As people type it: capitals or not, with or without hyphens.
std::string plain(std::string_view token) {
  std::string letters;
  for (const char c : token)
    if (c != '-') letters += (c >= 'a' && c <= 'z') ? static_cast<char>(c - 'a' + 'A') : c;
  return letters;
}

bool is_same_token(std::string_view told, std::string_view right) {
  const std::string a = plain(told), b = plain(right);
  return !b.empty() && a.size() == b.size() && sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

std::string guard_name(int station) { return "station " + std::to_string(station); }

}  // namespace

SerialLines::SerialLines(const Configuration& configuration, const Clock& clock, JournalBook& journal,
                         const Seats& seats)
    : configuration_(configuration), clock_(clock), journal_(journal), seats_(seats) {
  remote_.fill(configuration.remote);
}

panel::Now SerialLines::time_of(const Desk& desk) const {
  return control_time(clock_, configuration_.clock, desk.made_ns);
}

SerialLines::LinePtr SerialLines::of(const Desk& desk) const {
  const auto line = std::ranges::find_if(lines_, [&](const auto& one) { return one->desk.lock().get() == &desk; });
  return line == lines_.end() ? nullptr : *line;
}

panel::LineFitting SerialLines::fitting(const Desk& desk) const {
  const bool is_device = !configuration_.dnc_device.empty() && configuration_.dnc_station == desk.station;
  if (is_device) return {.is_fitted = true, .is_paced = false, .binding = configuration_.dnc_device};
  if (configuration_.dnc_listen.empty()) return {};
  return {.is_fitted = true,
          .is_paced = configuration_.dnc_pacing,
          .binding = fmt::format("STATION {} {}", desk.station, desk.dnc_token)};
}

void SerialLines::fit(Desk& desk, bool is_new_login) {
  if (is_new_login || desk.dnc_token.empty()) desk.dnc_token = line_token();
  desk.control.fit_line(fitting(desk));
  desk.control.set_remote(remote_.at(static_cast<std::size_t>(desk.station)));
}

void SerialLines::set_remote(int station, bool is_on, const std::string& who) {
  remote_.at(static_cast<std::size_t>(station)) = is_on;
  journal_.write("remote", is_on ? "on" : "off", station, who);
  for (const DeskPtr& desk : seats_.all()) {
    if (desk->station != station) continue;
    desk->control.set_remote(is_on);
    desk->is_dirty = true;
  }
}

std::expected<SerialLines::LinePtr, std::string> SerialLines::bind(const std::shared_ptr<LinePeer>& peer,
                                                                   const transfer::Binding& binding) {
  const std::string name = guard_name(binding.station), address = peer->address();
  const std::int64_t now_ns = clock_.monotonic_ns();
  const auto refused = [&](const std::string& why) {
    journal_.write("dnc_refused", address + ": " + why, binding.station);
    return std::unexpected(why);
  };
  if (const int wait = guard_.wait_seconds(name, address, now_ns); wait > 0)
    return refused(fmt::format("too many wrong tokens, {} s to wait", wait));
  const DeskPtr desk = seats_.at(binding.station);
  if (!desk || !is_same_token(binding.token, desk->dnc_token)) {
    guard_.failed(name, address, now_ns);
    return refused("wrong token");
  }
  guard_.succeeded(name);
  if (!configuration_.dnc_device.empty() && configuration_.dnc_station == binding.station)
    return refused("this station has the serial device");
  if (std::ranges::any_of(lines_, [&](const auto& other) { return other->station == binding.station; }))
    return refused("the station has a line already");
  auto line = std::make_shared<DncLine>(peer, binding.station, false);
  lines_.push_back(line);
  connect(*line, desk);
  return line;
}

void SerialLines::refuse(const std::string& address, const std::string& why) {
  journal_.write("dnc_refused", address + ": " + why);
}

SerialLines::LinePtr SerialLines::attach_device(const std::shared_ptr<LinePeer>& peer) {
  auto line = std::make_shared<DncLine>(peer, configuration_.dnc_station, true);
  lines_.push_back(line);
  connect(*line, seats_.at(line->station));
  return line;
}

std::size_t SerialLines::received(const LinePtr& line, std::string_view bytes) {
  const DeskPtr desk = line->desk.lock();
  return desk ? desk->control.line_received(bytes, time_of(*desk)) : bytes.size();
}

bool SerialLines::is_idle(const LinePtr& line) const {
  const DeskPtr desk = line->desk.lock();
  return !desk || desk->control.is_line_idle();
}

void SerialLines::lost(const LinePtr& line) {
  if (std::erase(lines_, line) > 0) connect(*line, nullptr);
}

void SerialLines::connect(DncLine& line, const DeskPtr& desk) {
  const DeskPtr former = line.desk.lock();
  if (former == desk) return;
  if (former) {
    former->control.connect_line(false, time_of(*former));
    former->is_dirty = true;
    journal_.write("dnc_line", "off " + line.peer->address(), line.station, former->person.name);
  }
  line.desk = desk;
  line.baud = 0;
  if (!desk) return;
  desk->control.connect_line(true, time_of(*desk));
  desk->is_dirty = true;
  journal_.write("dnc_line", "on " + line.peer->address(), line.station, desk->person.name);
  spdlog::info("dnc: station {}: line {}", line.station, line.peer->address());
}

void SerialLines::cut_of(const Desk& desk) {
  const std::vector<LinePtr> lines = lines_;
  for (const LinePtr& line : lines) {
    if (line->desk.lock().get() != &desk) continue;
    connect(*line, nullptr);
    if (line->is_device) continue;
    std::erase(lines_, line);
    line->peer->hang_up("the login has ended");
  }
}

void SerialLines::follow(std::int64_t now_ns) {
  const std::vector<LinePtr> lines = lines_;
  for (const LinePtr& line : lines) {
    if (line->is_device) connect(*line, seats_.at(line->station));
    const DeskPtr desk = line->desk.lock();
    if (!desk) continue;
    if (const int baud = desk->control.line_baud(); baud != line->baud) line->peer->set_baud(line->baud = baud);
    const std::size_t room = kMostUnsent - std::min(kMostUnsent, line->peer->unsent());
    if (std::string bytes = desk->control.take_line_output(time_of(*desk), room); !bytes.empty())
      line->peer->send(std::move(bytes));
    if (desk->control.is_line_reading() && now_ns - desk->last_drawn_ns >= kDash_ns) desk->is_dirty = true;
  }
}

}  // namespace cnclab::lab
