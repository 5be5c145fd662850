// Runs and traces on their way to the database.
#include "lab/runs/run_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "lab/runs/run_order_json.hpp"
#include "lab/software.hpp"

namespace cnclab::lab {

namespace {

constexpr std::size_t kRecord_bytes = 36;
constexpr std::size_t kBatch = 1000;  ///< points per row of run_trace: one second

nlohmann::json data_json(const machine::MachineData& data) {
  nlohmann::json json;
  for (const auto& form : machine::datum_forms()) json[std::to_string(form.number)] = data.get(form.number);
  return json;
}

template <class Value>
void put(std::string& out, Value value) {
  static_assert(std::endian::native == std::endian::little);
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

template <class Value>
Value get(const char*& at) {
  Value value;
  std::memcpy(&value, at, sizeof value);
  at += sizeof value;
  return value;
}

}  // namespace

std::string pack_trace(const std::vector<machine::TracePoint>& points) {
  std::string out;
  out.reserve(points.size() * kRecord_bytes);
  for (const auto& point : points) {
    put(out, point.tick);
    for (const std::int32_t steps : point.steps) put(out, steps);
    put(out, point.speed_mm_per_min);
    put(out, point.spindle_rpm);
    put(out, point.source.program);
    put(out, point.source.block);
  }
  return out;
}

std::string trace_csv(const std::string& packed, const std::array<double, 4>& steps_per_mm) {
  std::string csv = "t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block\n";
  const std::size_t records = packed.size() / kRecord_bytes;
  csv.reserve(records * 72);
  const char* at = packed.data();
  std::optional<std::uint64_t> first;
  for (std::size_t i = 0; i < records; ++i) {
    const auto tick = get<std::uint64_t>(at);
    if (!first) first = tick;
    fmt::format_to(std::back_inserter(csv), "{:.3f}", static_cast<double>(tick - *first + 1) / 1000.0);
    for (const double per_mm : steps_per_mm)
      fmt::format_to(std::back_inserter(csv), ",{:.6f}", static_cast<double>(get<std::int32_t>(at)) / per_mm);
    const auto feed = get<float>(at);
    const auto rpm = get<std::int32_t>(at);
    const auto program = get<std::uint16_t>(at);
    const auto block = get<std::uint16_t>(at);
    fmt::format_to(std::back_inserter(csv), ",{:.6f},{},{},{}\n", feed, rpm, program, block);
  }
  return csv;
}

std::vector<std::array<std::int32_t, 4>> trace_steps(const std::string& packed) {
  std::vector<std::array<std::int32_t, 4>> all(packed.size() / kRecord_bytes);
  const char* record = packed.data();
  for (auto& steps : all) {
    const char* at = record + sizeof(std::uint64_t);
    for (std::int32_t& axis : steps) axis = get<std::int32_t>(at);
    record += kRecord_bytes;
  }
  return all;
}

void TrajectoryDigest::add(const std::array<std::int32_t, 4>& steps) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (const std::int32_t axis : steps)
    for (int shift = 0; shift < 32; shift += 8)
      state_ = (state_ ^ (static_cast<std::uint32_t>(axis) >> shift & 0xFFU)) * kPrime;
}

std::string TrajectoryDigest::text() const { return fmt::format("{:016x}", state_); }

double hand_value(const std::array<std::int8_t, 3>& directions) {
  return (directions[0] + 1) + 3 * (directions[1] + 1) + 9 * (directions[2] + 1);
}

std::array<std::int8_t, 3> hand_directions(double value) {
  const int code = static_cast<int>(value);
  return {static_cast<std::int8_t>(code % 3 - 1), static_cast<std::int8_t>(code / 3 % 3 - 1),
          static_cast<std::int8_t>(code / 9 % 3 - 1)};
}

namespace {

bool begins_by_hand(const machine::TracePoint& point) { return point.levels.by_hand != std::array<std::int8_t, 3>{}; }

}  // namespace

struct RunRecorder::Run {
  std::optional<std::int64_t> id;  ///< known once the store has answered
  std::uint64_t ticks = 0;
  std::uint64_t lost = 0;
  std::size_t noted = 0;  ///< events so far
  TrajectoryDigest digest;
  machine::TickLevels levels;  ///< of the last tick
  std::vector<db::RunEvent> events;
  std::function<void(const db::StoreError&)> on_loss;  ///< empty once it was called
};

std::function<void(const RunRecorder::Answer&)> RunRecorder::watching(const std::shared_ptr<Run>& run) {
  return [run](const Answer& answer) {
    if (answer) return;
    if (const auto tell = std::exchange(run->on_loss, nullptr)) tell(answer.error());
  };
}

RunRecorder::RunRecorder(db::Store& store, std::shared_ptr<machine::Channel> channel, Keeps keeps)
    : store_(store), channel_(std::move(channel)), keeps_(keeps) {
  channel_->record_trace(true);
}

void RunRecorder::begin(const RunStart& start) {
  run_ = std::make_shared<Run>();
  run_->on_loss = start.on_loss;
  order_ = start.order;
  db::RunRecord record;
  record.person = start.person;
  record.station = start.station;
  record.machine = keeps_ == Keeps::trace ? "lab" : "training";
  record.lease = start.lease;
  record.started_ms = start.unix_ms;
  record.program = start.program;
  record.block = start.block;
  const machine::Snapshot now = channel_->snapshot();
  is_by_hand_ = start.hand.has_value();
  const bool has_started = now.started || is_by_hand_;
  nlohmann::json setup{{"software", kSoftware},
                       {"steps", has_started ? now.start_steps : now.steps},
                       {"machine_data", data_json(start.machine_data)}};
  if (start.hand) setup["hand"] = {{"istwert", start.hand->istwert_mm}, {"data", data_json(start.hand->data)}};
  const auto first = std::ranges::find_if(
      arrived_, [this](const auto& point) { return is_by_hand_ ? begins_by_hand(point) : point.levels.go; });
  arrived_.erase(arrived_.begin(), first);
  // The store is a queue, so the id is known to every later job of this run, on the store's own thread; and the
  // versions found there are those at START.
  store_.run(
      [run = run_, record, setup, order = order_](db::Database& database) mutable {
        if (order) setup["order"] = order_json(*order, database, record.person);
        record.setup = setup.dump();
        run->id = database.begin_run(record);
        database.forget_old_traces(kTracesKept);
      },
      watching(run_));
}

bool RunRecorder::has_hand_start() const { return std::ranges::any_of(arrived_, begins_by_hand); }

void RunRecorder::pass_over() { arrived_.clear(); }

/// By hand each START is a record of its own.
bool RunRecorder::is_of_next_run(const machine::TracePoint& point) const {
  return run_->ticks > 0 && (begins_by_hand(point) || (is_by_hand_ && point.levels.go));
}

void RunRecorder::poll() {
  const std::uint64_t lost = channel_->drain_trace(arrived_);
  if (!run_) return;
  points_.reserve(2 * kBatch);
  run_->lost += lost;
  auto next = arrived_.begin();
  for (; next != arrived_.end() && !is_of_next_run(*next); ++next) {
    take(*next);
    points_.push_back(*next);
  }
  arrived_.erase(arrived_.begin(), next);
  if (keeps_ == Keeps::digest || run_->ticks > kMostTicks) points_.clear();
  if (points_.size() >= kBatch) flush();
  if (run_->events.size() >= kBatch) flush_events();
}

void RunRecorder::take(const machine::TracePoint& point) {
  const machine::TickLevels& now = point.levels;
  const machine::TickLevels& was = run_->levels;
  const bool is_first = run_->ticks == 0;
  // Levels before what they act on: a replay sets them in this order, then lets the tick pass.
  if (is_first || now.override_ratio != was.override_ratio) note("override", static_cast<double>(now.override_ratio));
  if (is_first || now.single_block != was.single_block) note("single_block", now.single_block ? 1 : 0);
  if (is_first || now.inputs_found != was.inputs) note("inputs", now.inputs_found);
  if (now.stops != 0) note("stop", now.stops);
  if (now.go) note("go", 1);
  for (std::uint64_t number = now.resumption - now.resumptions; number < now.resumption; ++number)
    note("resume", channel_->answer_at_resumption(number + 1) ? 1 : 0);
  if (begins_by_hand(point)) note(now.is_reference ? "reference" : "jog", hand_value(now.by_hand));
  if (now.inputs != now.inputs_found) note("inputs", now.inputs);
  run_->levels = now;
  run_->digest.add(point.steps);
  ++run_->ticks;
}

void RunRecorder::note(const char* kind, double value) {
  if (++run_->noted <= kMostEvents) run_->events.push_back({static_cast<std::int64_t>(run_->ticks), kind, value});
}

void RunRecorder::flush() {
  if (points_.empty() || !run_) return;
  store_.run(
      [run = run_, first = static_cast<std::int64_t>(points_.front().tick),
       data = pack_trace(points_)](db::Database& database) {
        if (run->id) database.add_trace(*run->id, first, data);
      },
      watching(run_));
  points_.clear();
}

void RunRecorder::flush_events() {
  if (run_->events.empty()) return;
  store_.run(
      [run = run_, events = std::exchange(run_->events, {})](db::Database& database) {
        if (run->id) database.add_run_events(*run->id, events);
      },
      watching(run_));
}

void RunRecorder::end(const std::string& ended) {
  if (!run_) return;
  poll();
  flush();
  flush_events();
  db::RunRecord record;
  record.seconds = static_cast<double>(run_->ticks) / 1000.0;
  if (run_->ticks == 0)
    record.ended = kNotStarted;
  else
    record.ended = run_->lost == 0 ? ended : fmt::format("{} ({} ticks not traced)", ended, run_->lost);
  record.ticks = static_cast<std::int64_t>(run_->ticks);
  const bool is_whole = (order_ != nullptr || is_by_hand_) && run_->lost == 0 && run_->noted <= kMostEvents;
  if (is_whole) record.digest = run_->digest.text();
  store_.run(
      [run = run_, record, noted = run_->noted](db::Database& database) mutable {
        if (!run->id) return;
        if (record.digest.empty() || database.run_events(*run->id).size() == noted)
          return database.end_run(*run->id, record);
        record.digest.clear();
        record.ended += " (not recorded wholly)";
        database.end_run(*run->id, record);
      },
      watching(run_));
  run_.reset();
  order_.reset();
}

}  // namespace cnclab::lab
