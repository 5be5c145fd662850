// Serial lines and the stations that they belong to: bound, followed, cut; who may start what over them (AUTH-013).
#include <fmt/format.h>
#include <sodium.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "lab/lab.hpp"
#include "lab/media/dnc_start.hpp"
#include "shared/station_id.hpp"

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

panel::LineFitting Lab::line_fitting(const Desk& desk) const {
  const bool is_device = !configuration_.dnc_device.empty() && configuration_.dnc_station == desk.station;
  if (is_device) return {.is_fitted = true, .is_paced = false, .binding = configuration_.dnc_device};
  if (configuration_.dnc_listen.empty()) return {};
  return {.is_fitted = true,
          .is_paced = configuration_.dnc_pacing,
          .binding = fmt::format("STATION {} {}", desk.station, desk.dnc_token)};
}

void Lab::fit_line(Desk& desk, bool is_new_login) {
  if (is_new_login || desk.dnc_token.empty()) desk.dnc_token = line_token();
  desk.control.fit_line(line_fitting(desk));
  desk.control.set_remote(remote_.at(static_cast<std::size_t>(desk.station)));
}

void Lab::set_remote(int station, bool is_on, const std::string& who) {
  remote_.at(static_cast<std::size_t>(station)) = is_on;
  write_journal("remote", is_on ? "on" : "off", station, who);
  for (const auto& [id, desk] : desks_) {
    if (desk->station != station) continue;
    desk->control.set_remote(is_on);
    desk->is_dirty = true;
  }
}

std::expected<Lab::LinePtr, std::string> Lab::bind_line(const std::shared_ptr<LinePeer>& peer,
                                                        const transfer::Binding& binding) {
  const std::string name = guard_name(binding.station), address = peer->address();
  const std::int64_t now_ns = clock_.monotonic_ns();
  const auto refuse = [&](const std::string& why) {
    write_journal("dnc_refused", address + ": " + why, binding.station);
    return std::unexpected(why);
  };
  if (const int wait = line_guard_.wait_seconds(name, address, now_ns); wait > 0)
    return refuse(fmt::format("too many wrong tokens, {} s to wait", wait));
  const DeskPtr desk = seated_at(binding.station);
  if (!desk || !is_same_token(binding.token, desk->dnc_token)) {
    line_guard_.failed(name, address, now_ns);
    return refuse("wrong token");
  }
  line_guard_.succeeded(name, address);
  if (!configuration_.dnc_device.empty() && configuration_.dnc_station == binding.station)
    return refuse("this station has the serial device");
  if (std::ranges::any_of(lines_, [&](const auto& other) { return other->station == binding.station; }))
    return refuse("the station has a line already");
  auto line = std::make_shared<DncLine>(peer, binding.station, false);
  lines_.push_back(line);
  connect_line(*line, desk);
  return line;
}

void Lab::refuse_line(const std::string& address, const std::string& why) {
  write_journal("dnc_refused", address + ": " + why);
}

Lab::LinePtr Lab::attach_device(const std::shared_ptr<LinePeer>& peer) {
  auto line = std::make_shared<DncLine>(peer, configuration_.dnc_station, true);
  lines_.push_back(line);
  connect_line(*line, seated_at(line->station));
  return line;
}

std::size_t Lab::line_received(const LinePtr& line, std::string_view bytes) {
  const DeskPtr desk = line->desk.lock();
  return desk ? desk->control.line_received(bytes, now(*desk)) : bytes.size();
}

bool Lab::is_line_idle(const LinePtr& line) const {
  const DeskPtr desk = line->desk.lock();
  return !desk || desk->control.is_line_idle();
}

void Lab::line_lost(const LinePtr& line) {
  if (std::erase(lines_, line) > 0) connect_line(*line, nullptr);
}

void Lab::connect_line(DncLine& line, const DeskPtr& desk) {
  const DeskPtr former = line.desk.lock();
  if (former == desk) return;
  if (former) {
    former->control.connect_line(false, now(*former));
    former->is_dirty = true;
    write_journal("dnc_line", "off " + line.peer->address(), line.station, former->person.name);
  }
  line.desk = desk;
  line.baud = 0;
  if (!desk) return;
  desk->control.connect_line(true, now(*desk));
  desk->is_dirty = true;
  write_journal("dnc_line", "on " + line.peer->address(), line.station, desk->person.name);
  spdlog::info("dnc: station {}: line {}", line.station, line.peer->address());
}

void Lab::cut_lines_of(const Desk& desk) {
  const std::vector<LinePtr> lines = lines_;
  for (const LinePtr& line : lines) {
    if (line->desk.lock().get() != &desk) continue;
    connect_line(*line, nullptr);
    if (line->is_device) continue;
    std::erase(lines_, line);
    line->peer->hang_up("the login has ended");
  }
}

void Lab::follow_lines(std::int64_t now_ns) {
  const std::vector<LinePtr> lines = lines_;
  for (const LinePtr& line : lines) {
    if (line->is_device) connect_line(*line, seated_at(line->station));
    const DeskPtr desk = line->desk.lock();
    if (!desk) continue;
    if (const int baud = desk->control.line_baud(); baud != line->baud) line->peer->set_baud(line->baud = baud);
    const std::size_t room = kMostUnsent - std::min(kMostUnsent, line->peer->unsent());
    if (std::string bytes = desk->control.take_line_output(now(*desk), room); !bytes.empty())
      line->peer->send(std::move(bytes));
    if (desk->control.is_line_reading() && now_ns - desk->last_drawn_ns >= kDash_ns) desk->is_dirty = true;
  }
}

void Lab::judge_remote_start(const DeskPtr& desk, const panel::RemoteStart& start) {
  const RemoteStartView view{.now_ns = clock_.monotonic_ns(),
                             .is_seated = desk->is_seated(),
                             .is_barred = bar(*desk).has_value(),
                             .on_lab_machine = desk->on_lab_machine,
                             .training_start = configuration_.dnc_training_start,
                             .has_lease = authority_.holder() == desk->login && !machine_view().lease_dead,
                             .is_halted = authority_.is_halted(),
                             .lease = authority_.newest(),
                             .armed = desk->control.armed()};
  const auto refusal = refusal_of(start, view);
  const std::string place = fmt::format("P{:04} N{:03}", start.program, start.block);
  write_journal(refusal ? "remote_start_refused" : "remote_start",
                refusal ? place + ": " + text_of(*refusal).english : place, desk->station, desk->person.name,
                desk->on_lab_machine ? authority_.newest() : Epoch{});
  const std::string sentence = refusal ? text_of(*refusal).in(tongue_of(desk->person)) : std::string();
  outcome(desk, desk->control.answer_remote_start(sentence, now(*desk)), 0);
}

}  // namespace cnclab::lab
