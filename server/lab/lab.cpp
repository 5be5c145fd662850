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

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kLoginDeadline_ns = 10 * kSecond_ns;  ///< SEC-005
constexpr std::int64_t kSilence_ns = 5 * kSecond_ns;         ///< SEAT-004
constexpr std::size_t kMostUnknown = 64;                     ///< connections that are not logged in (SEC-005)

constexpr std::size_t kMostUnwritten = 10'000;  ///< journal entries that wait for a disk with room
constexpr int kRunsKept = 1000;                 ///< of each person

AuthorityRules rules_of(const Configuration& configuration) {
  AuthorityRules rules;
  rules.accept_needed = configuration.accept;
  rules.silence_manual_ns = configuration.silence_manual_ms * 1'000'000LL;
  rules.silence_lease_ns = configuration.silence_lease_ms * 1'000'000LL;
  return rules;
}

std::array<double, 3> workpiece_of(const Configuration& configuration) {
  return {configuration.size_mm.at(0), configuration.size_mm.at(1), configuration.size_mm.at(2)};
}

/// Bits of cards 1 and 2 from numbers such as 11 (card 1, line 1) and 28.
std::array<std::uint8_t, 2> output_lines(const std::vector<int>& numbers) {
  std::array<std::uint8_t, 2> cards{};
  for (const int number : numbers)
    cards.at(static_cast<std::size_t>(number / 10 - 1)) |= static_cast<std::uint8_t>(1U << (number % 10 - 1));
  return cards;
}

/// Steps per mm of X, Y, Z.
std::array<double, 3> zero_scale(const machine::MachineData& data) {
  const auto per_mm = machine::motion_limits(data).steps_per_mm;
  return {per_mm[0], per_mm[1], per_mm[2]};
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
      machine_data_(inheritance.machine_data),
      tools_(inheritance.tools),
      workpiece_mm_(inheritance.workpiece_mm.value_or(workpiece_of(configuration_))),
      backup_(inheritance.database, post_),
      site_(workpieces_.add(workpiece())),
      machine_(machine_data_),
      channel_(std::make_shared<machine::Channel>(machine_, machine_data_)),
      watchdog_(ticks, ticks.is_real_time() ? machine::Watchdog::kLimit : machine::Watchdog::kPatientLimit),
      zeros_(zero_scale(machine_data_)),
      recorder_(store, channel_, RunRecorder::Keeps::trace) {
  use_tools(tools_);
  channel_->feed_cuts(&site_->feed());
  channel_->set_outputs_off_at_power_off(output_lines(configuration_.outputs_off_at_power_off));
  if (!ticks_.add(channel_)) throw std::runtime_error("the tick has no place for the lab's machine");
  watchdog_.guard(channel_);
  remote_.fill(configuration_.remote);
  beats_.advance(clock_.monotonic_ns());
  keep_epoch();
  write_journal("server_start", "nobody has control, position unreferenced");  // AUTH-012
}

Lab::~Lab() {
  *alive_ = false;
  for (const auto& [id, desk] : desks_) desk->leave_machines();
  desks_.clear();
  ticks_.remove(channel_);
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
  static_cast<void>(decide(Polled{}, configuration_.tongue));
  settle_machine_data();
  const std::vector<DeskPtr> desks = [this] {
    std::vector<DeskPtr> all;
    all.reserve(desks_.size());
    for (const auto& [id, desk] : desks_) all.push_back(desk);
    return all;
  }();
  for (const DeskPtr& desk : desks) {
    if (panel::Outcome followed = desk->control.poll(now(*desk)); followed.is_anything())
      outcome(desk, std::move(followed), 0);
    watch_media(desk, now_ns);
    watch_recorder(desk);
    record_run(desk);
    tell_milling(desk);
    desk->settle_machine_data();
    if (!desk->is_seated() && now_ns >= desk->keep_until_ns) dismiss(desk);
    if (now_ns - desk->last_saved_ns >= 10 * kSecond_ns) save_state(desk);
  }
  follow_lines(now_ns);
  draw_due(now_ns);
  watch_connections(now_ns);
  if (now_ns - journal_flushed_ns_ >= kSecond_ns / 5) flush_journal();
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
  write_journal("server_end", "");
  const std::vector<VisitPtr> visits = visits_;
  for (const VisitPtr& visit : visits) {
    if (visit->desk) save_state(visit->desk);
    farewell(visit, 10, say(tongue_of(visit->person), "Der Server wird beendet.", "The server is shutting down."));
  }
  recorder_.end("server_end");
  for (const auto& [id, desk] : desks_) desk->recorder->end("server_end");
  flush_journal();
}

bool Lab::at_rest() const { return machine_view().at_rest(); }

void Lab::write_journal(std::string kind, std::string detail, int station, std::string person, Epoch lease) {
  journal_.push_back({clock_.unix_ms(), station, std::move(person), std::move(kind), std::move(detail),
                      static_cast<std::uint64_t>(lease)});
}

void Lab::flush_journal() {
  journal_flushed_ns_ = clock_.monotonic_ns();
  if (journal_.empty()) return;
  const auto entries = std::make_shared<const std::vector<db::JournalEntry>>(std::exchange(journal_, {}));
  store_.run([entries](db::Database& database) { database.add_journal(*entries); },
             [this, entries, alive = alive_](const std::expected<void, db::StoreError>& result) {
               if (result || !*alive) return;
               spdlog::error("journal: {}", result.error().detail);
               // Written with the next ones, when there is room again (STO-009); the oldest go first where it lasts.
               const std::size_t room = kMostUnwritten - std::min(kMostUnwritten, journal_.size());
               const auto kept = static_cast<std::ptrdiff_t>(std::min(entries->size(), room));
               journal_.insert(journal_.begin(), entries->end() - kept, entries->end());
             });
}

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

std::string Lab::say(language::Tongue tongue, const char* german, const char* english) const {
  return tongue == language::Tongue::german ? german : english;
}

std::string Lab::sentence_for(const db::StoreError& error, language::Tongue tongue) {
  return std::string(db::explain(error.kind, tongue == language::Tongue::german ? "de" : "en"));
}

language::Tongue Lab::tongue_of(const db::Person& person) const {
  if (person.language.empty()) return configuration_.tongue;
  return person.language == "en" ? language::Tongue::english : language::Tongue::german;
}

}  // namespace cnclab::lab
