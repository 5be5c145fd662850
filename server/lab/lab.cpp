// Connections come, speak and go; the time passes.
#include "lab/lab.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "cnclab/v1/envelope.pb.h"
#include "lab/console/console.hpp"
#include "shared/frame.hpp"

namespace cnclab::lab {

namespace {

constexpr std::int64_t kLoginDeadline_ns = 10 * kSecond_ns;  ///< SEC-005
constexpr std::int64_t kSilence_ns = 5 * kSecond_ns;         ///< SEAT-004
constexpr std::size_t kMostUnknown = 64;                     ///< connections that are not logged in (SEC-005)

constexpr int kRunsKept = 1000;  ///< of each person

AuthorityRules rules_of(const Configuration& configuration) {
  AuthorityRules rules;
  rules.accept_needed = configuration.accept;
  rules.silence_manual_ns = configuration.silence_manual_ms * 1'000'000LL;
  rules.silence_lease_ns = configuration.silence_lease_ms * 1'000'000LL;
  return rules;
}

}  // namespace

Lab::Lab(Configuration configuration, db::Store& store, machine::TickThread& ticks, db::Post post, Clock clock,
         const Inheritance& inheritance)
    : configuration_(std::move(configuration)),
      store_(store),
      ticks_(ticks),
      post_(std::move(post)),
      clock_(std::move(clock)),
      passwords_(post_),
      authority_(rules_of(configuration_), inheritance.newest_epoch),
      kept_epoch_(static_cast<std::uint64_t>(inheritance.newest_epoch)),
      backup_(inheritance.database, post_),
      journal_(store_, clock_),
      machine_(configuration_, store, ticks, workpieces_, inheritance.machine),
      lines_(configuration_, clock_, journal_, seats_) {
  beats_.advance(clock_.monotonic_ns());
  keep_epoch();
  journal_.write("server_start", "nobody has control, position unreferenced");  // AUTH-012
  if (machine_.damaged_data().empty()) return;
  const std::string damage = damage_sentence(machine_.damaged_data(), language::Tongue::english);
  spdlog::error("{}; nobody is given the machine until then", damage);
  journal_.write("checksum", damage);
}

Lab::~Lab() {
  *alive_ = false;
  for (const DeskPtr& desk : seats_.all()) desk->leave_machines();
  seats_.clear();
}

std::shared_ptr<Visit> Lab::welcome(std::shared_ptr<Peer> peer) {
  auto visit = std::make_shared<Visit>(std::move(peer), clock_.monotonic_ns());
  const auto unknown = std::ranges::count_if(visits_, [](const auto& other) { return !other->is_logged_in(); });
  visits_.push_back(visit);
  if (static_cast<std::size_t>(unknown) >= kMostUnknown) hang_up(visit, "too many connections that are not logged in");
  return visit;
}

void Lab::receive(const VisitPtr& visit, const v1::ClientMessage& message) {
  if (visit->stage == Stage::gone) return;
  visit->heard_ns = clock_.monotonic_ns();
  if (!visit->is_logged_in()) return greet(visit, message);
  switch (message.what_case()) {
    case v1::ClientMessage::kKey:
      return take_key(visit, message.key());
    case v1::ClientMessage::kPotentiometer:
      return take_potentiometer(visit, message.potentiometer());
    case v1::ClientMessage::kScreenAck:
      if (!visit->feed.acknowledge(message.screen_ack().number())) return hang_up(visit, "unknown screen acknowledged");
      return push(visit);
    case v1::ClientMessage::kAlive:
      return heard(visit, message.alive().beat());
    case v1::ClientMessage::kLogout:
      return log_out(visit, "log-out");
    case v1::ClientMessage::kRequest:
      return Console(*this).answer(visit, message.request());
    case v1::ClientMessage::kChunkAck:
      if (visit->desk) return take_media(visit, message);
      return Console(*this).continue_transfer(visit, message.chunk_ack());
    case v1::ClientMessage::kChunk:
    case v1::ClientMessage::kMediaFailed:
      if (!visit->desk) return hang_up(visit, "message out of order");
      return take_media(visit, message);
    case v1::ClientMessage::kChangePassword:
      return change_password(visit, message.change_password());
    case v1::ClientMessage::kHello:
    case v1::ClientMessage::kLogin:
    case v1::ClientMessage::kResume:
    case v1::ClientMessage::WHAT_NOT_SET:
      return hang_up(visit, "message out of order");
  }
}

void Lab::lost(const VisitPtr& visit) {
  if (visit->stage == Stage::at_desk) vacate(visit, "line lost");
  let_go_of_keyboard(visit);
  visit->stage = Stage::gone;
  std::erase(visits_, visit);
}

void Lab::hang_up(const VisitPtr& visit, const std::string& reason) {
  spdlog::info("{}: connection ended: {}", visit->peer->address(), reason);
  if (visit->stage == Stage::at_desk) vacate(visit, reason);
  let_go_of_keyboard(visit);
  visit->stage = Stage::gone;
  visit->peer->hang_up(reason);
  std::erase(visits_, visit);
}

void Lab::farewell(const VisitPtr& visit, int exit_code, const std::string& text) {
  v1::ServerMessage message;
  message.mutable_bye()->set_exit_code(static_cast<std::uint32_t>(exit_code));
  message.mutable_bye()->set_text(text);
  visit->peer->send(message);
  hang_up(visit, text);
}

void Lab::poll() {
  const std::int64_t now_ns = clock_.monotonic_ns();
  send_beats(now_ns);
  heed_watchdog();
  tell_late_ticks();
  static_cast<void>(decide(Polled{}, configuration_.tongue));
  settle_machine_data();
  for (const DeskPtr& desk : seats_.list()) {
    const bool is_settled = !desk->awaits_effect();  // asked first: the control follows what is no older
    if (panel::Outcome followed = desk->control.poll(now(*desk)); followed.is_anything())
      outcome(desk, std::move(followed), 0);
    if (is_settled) heed_switched(desk);
    watch_media(desk, now_ns);
    watch_recorder(desk);
    record_run(desk);
    tell_milling(desk);
    desk->settle_machine_data();
    if (!desk->is_seated() && now_ns >= desk->keep_until_ns) dismiss(desk);
    if (now_ns - desk->last_saved_ns >= 10 * kSecond_ns) save_state(desk);
  }
  lines_.follow(now_ns);
  draw_due(now_ns);
  watch_connections(now_ns);
  journal_.flush_when_due();
  keep_house(now_ns);
}

void Lab::watch_connections(std::int64_t now_ns) {
  const std::vector<VisitPtr> visits = visits_;
  for (const VisitPtr& visit : visits) {
    if (!visit->is_logged_in() && now_ns - visit->opened_ns > kLoginDeadline_ns &&
        now_ns - visit->heard_ns > kLoginDeadline_ns)
      hang_up(visit, "no login in time");
    else if (visit->is_logged_in() && now_ns - visit->heard_ns > kSilence_ns)
      hang_up(visit, "silent for 5 s");
  }
}

void Lab::send_beats(std::int64_t now_ns) {
  if (!beats_.advance(now_ns)) return;
  for (const VisitPtr& visit : visits_) {
    const DeskPtr desk = typed_at(*visit);
    const bool has_lease = desk && desk->login == authority_.holder();
    if (!visit->is_logged_in() || (!has_lease && now_ns - visit->last_beat_ns < kSecond_ns)) continue;
    visit->last_beat_ns = now_ns;
    send_beat(visit);
  }
}

void Lab::send_beat(const VisitPtr& visit) {
  v1::ServerMessage message;
  message.mutable_beat()->set_number(beats_.number());
  visit->peer->send(message);
}

void Lab::release_machine() { static_cast<void>(decide(ReleaseIt{true}, configuration_.tongue)); }

void Lab::close() {
  journal_.write("server_end", "");
  const std::vector<VisitPtr> visits = visits_;
  for (const VisitPtr& visit : visits) {
    if (visit->desk) save_state(visit->desk);
    farewell(visit, 10, say(tongue_of(visit->person), "Der Server wird beendet.", "The server is shutting down."));
  }
  machine_.recorder().end("server_end");
  for (const DeskPtr& desk : seats_.all()) desk->recorder->end("server_end");
  journal_.flush();
}

bool Lab::at_rest() const { return machine_view().at_rest(); }

void Lab::keep_house(std::int64_t now_ns) {
  constexpr std::int64_t kHour_ns = 3600 * kSecond_ns;
  constexpr std::int64_t kDay_ms = 86'400'000;
  if (house_kept_ns_ != 0 && now_ns - house_kept_ns_ < kHour_ns) return;
  house_kept_ns_ = now_ns;
  const std::int64_t oldest_entry_ms = clock_.unix_ms() - configuration_.journal_days * kDay_ms;
  const std::int64_t oldest_archive_ms = clock_.unix_ms() - configuration_.undo_days * kDay_ms;
  store_.run(
      [oldest_entry_ms, oldest_archive_ms](db::Database& database) {
        database.forget_journal_before(oldest_entry_ms);
        database.forget_old_runs(oldest_entry_ms, kRunsKept);
        for (const db::Person& person : database.people(true))
          if (person.archived_ms && *person.archived_ms < oldest_archive_ms) database.erase(person.id);
      },
      [](const std::expected<void, db::StoreError>& result) {
        if (!result) spdlog::error("housekeeping: {}", result.error().text);
      });
}

language::Tongue Lab::tongue_with(const Visit& visit) const {
  return visit.is_logged_in() ? tongue_of(visit.person) : configuration_.tongue;
}

language::Tongue Lab::tongue_of(const db::Person& person) const {
  if (person.language.empty()) return configuration_.tongue;
  return person.language == "en" ? language::Tongue::english : language::Tongue::german;
}

}  // namespace cnclab::lab
