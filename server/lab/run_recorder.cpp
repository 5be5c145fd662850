// Runs and traces on their way to the database.
#include "lab/run_recorder.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <iterator>

namespace cnclab::lab {

namespace {

constexpr std::size_t kRecord_bytes = 36;
constexpr std::size_t kBatch = 1000;  ///< points per row of run_trace: one second

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

struct RunRecorder::Run {
  std::optional<std::int64_t> id;  ///< known once the store has answered
  std::uint64_t ticks = 0;
  std::uint64_t lost = 0;
};

RunRecorder::RunRecorder(db::Store& store, std::shared_ptr<machine::Channel> channel)
    : store_(store), channel_(std::move(channel)) {
  channel_->record_trace(true);
}

void RunRecorder::begin(const RunStart& start) {
  run_ = std::make_shared<Run>();
  db::RunRecord record;
  record.person = start.person;
  record.station = start.station;
  record.machine = "lab";
  record.lease = start.lease;
  record.started_ms = start.unix_ms;
  record.program = start.program;
  record.block = start.block;
  record.setup = start.setup;
  // The store is a queue, so the id is known to every later job of this run, on the store's own thread.
  store_.run(
      [run = run_, record](db::Database& database) {
        run->id = database.begin_run(record);
        database.forget_old_traces(kTracesKept);
      },
      [](const std::expected<void, db::StoreError>&) {});
}

void RunRecorder::poll() {
  points_.reserve(2 * kBatch);
  const std::size_t before = points_.size();
  const std::uint64_t lost = channel_->drain_trace(points_);
  if (!run_ || run_->ticks >= kMostTicks) {
    points_.clear();
    return;
  }
  run_->lost += lost;
  run_->ticks += points_.size() - before;
  if (points_.size() >= kBatch) flush();
}

void RunRecorder::flush() {
  if (points_.empty() || !run_) return;
  store_.run(
      [run = run_, first = static_cast<std::int64_t>(points_.front().tick),
       data = pack_trace(points_)](db::Database& database) {
        if (run->id) database.add_trace(*run->id, first, data);
      },
      [](const std::expected<void, db::StoreError>&) {});
  points_.clear();
}

void RunRecorder::end(const std::string& ended) {
  if (!run_) return;
  poll();
  flush();
  const double seconds = static_cast<double>(run_->ticks) / 1000.0;
  const std::string how = run_->lost == 0 ? ended : fmt::format("{} ({} ticks not traced)", ended, run_->lost);
  store_.run(
      [run = run_, seconds, how](db::Database& database) {
        if (run->id) database.end_run(*run->id, seconds, how);
      },
      [](const std::expected<void, db::StoreError>&) {});
  run_.reset();
}

}  // namespace cnclab::lab
