// A channel and a simulated machine of their own, driven by the recorded events.
#include "lab/runs/run_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "lab/runs/run_recorder.hpp"
#include "machine/simulated_machine.hpp"

namespace cnclab::lab {

namespace {

constexpr machine::Epoch kEpoch{1};
constexpr double kTick_s = 0.001;
constexpr std::int64_t kTick_ns = 1'000'000;
constexpr std::uint64_t kPollEvery = 10;     ///< ticks: as the lab does
constexpr std::uint64_t kMostIdle = 60'000;  ///< ticks without START state in a row: it will not go on

class Player {
 public:
  explicit Player(const RecordedRun& recorded)
      : recorded_(recorded),
        machine_(recorded.machine_data),
        channel_(std::make_shared<machine::Channel>(machine_, recorded.order.data)),
        between_resumptions_(std::ranges::any_of(recorded.events, [](const auto& e) { return e.kind == "resume"; })
                                 ? panel::Run::Questions::held
                                 : panel::Run::Questions::answered) {
    machine_.place(recorded.steps);
    channel_->grant(kEpoch, machine::kNeverExpires);
    channel_->record_trace(true);
  }

  ReplayResult play() {
    if (recorded_.hand_istwert_mm) name_place(*recorded_.hand_istwert_mm);
    for (std::uint64_t idle = 0; points_.size() < recorded_.ticks && idle < kMostIdle;) {
      const std::size_t before = points_.size();
      if (auto fault = act()) return {false, points_.size(), 0, "START: " + std::move(*fault)};
      tick();
      idle = points_.size() == before ? idle + 1 : 0;
    }
    return compare();
  }

 private:
  /// The place has its name before the first direction comes.
  void name_place(const std::array<double, 4>& istwert_mm) {
    const std::array<double, 3> mm{istwert_mm[0], istwert_mm[1], istwert_mm[2]};
    // U has no ISTWERT and stands still by hand: its place is added.
    u_steps_ = static_cast<std::int32_t>(
        std::lround(istwert_mm[3] * machine::motion_limits(recorded_.order.data).steps_per_mm[3]));
    static_cast<void>(channel_->command(machine::SetIstwert{kEpoch, {true, true, true}, mm}));
  }

  /// The events of the next tick, in their order. What the first START finds wrong, in English.
  std::optional<std::string> act() {
    bool has_gone_on = false;  // what the beginning of the run has gone on with by itself is in the record too
    for (; next_ < recorded_.events.size(); ++next_) {
      const db::RunEvent& event = recorded_.events[next_];
      if (static_cast<std::uint64_t>(event.tick) > points_.size()) return std::nullopt;
      if (event.kind == "override") channel_->set_override(event.value);
      if (event.kind == "single_block") channel_->set_single_block(event.value != 0);
      if (event.kind == "inputs") set_inputs(static_cast<std::uint32_t>(event.value));
      if (event.kind == "resume" && !std::exchange(has_gone_on, false))
        run_.feed_replay(panel::Run::Questions::answered, event.value != 0);
      if (event.kind == "stop") stop(static_cast<std::uint32_t>(event.value));
      const bool is_start = event.kind == "go" || event.kind == "jog" || event.kind == "reference";
      if (!is_start) continue;
      // A START at rest finds the inputs and switches as they have been: they come back from the machine a tick later.
      if (!channel_->snapshot().started) tick();
      const bool begins = event.kind == "go" && !run_.is_present();
      if (auto fault = start(event)) return fault;
      has_gone_on = begins && run_.has_gone_on();
    }
    return std::nullopt;
  }

  std::optional<std::string> start(const db::RunEvent& event) {
    if (event.kind == "jog")
      static_cast<void>(channel_->command(machine::Jog{kEpoch, hand_directions(event.value)}));
    else if (event.kind == "reference")
      static_cast<void>(channel_->command(machine::RunReference{kEpoch, hand_directions(event.value)}));
    else if (run_.is_present())
      run_.go_on();
    else if (const auto begun =
                 run_.begin({channel_, kEpoch, recorded_.is_lab_machine, recorded_.machine_data}, recorded_.order);
             !begun)
      return language::explain(begun.error(), language::Tongue::english);
    return std::nullopt;
  }

  void set_inputs(std::uint32_t inputs) {
    machine_.set_input(0, 0, (inputs & 1U) != 0);
    for (int card = 1; card <= 2; ++card)
      for (int line = 1; line <= 8; ++line)
        machine_.set_input(card, line, (inputs >> static_cast<unsigned>(8 * card + line - 1) & 1U) != 0);
  }

  void stop(std::uint32_t causes) {
    for (std::uint32_t bit = 0; bit <= static_cast<std::uint32_t>(machine::StopCause::error); ++bit)
      if ((causes >> bit & 1U) != 0) channel_->stop(static_cast<machine::StopCause>(bit));
  }

  void tick() {
    channel_->tick(++ticks_ * kTick_ns, kTick_s);
    const std::size_t before = points_.size();
    static_cast<void>(channel_->drain_trace(points_));
    for (std::size_t i = before; i < points_.size(); ++i) points_[i].steps[3] += u_steps_;
    if (static_cast<std::uint64_t>(ticks_) % kPollEvery == 0) run_.feed_replay(between_resumptions_);
  }

  [[nodiscard]] ReplayResult compare() const {
    ReplayResult result;
    result.ticks = points_.size();
    TrajectoryDigest digest;
    for (const machine::TracePoint& point : points_) digest.add(point.steps);
    result.same = points_.size() == recorded_.ticks && digest.text() == recorded_.digest;
    if (!result.same)
      result.detail = fmt::format("{} ticks, digest {}; recorded were {} ticks, digest {}", points_.size(),
                                  digest.text(), recorded_.ticks, recorded_.digest);
    measure(result);
    result.points = points_;
    return result;
  }

  /// Against the trace, where there is one.
  void measure(ReplayResult& result) const {
    const auto per_mm = machine::motion_limits(recorded_.order.data).steps_per_mm;
    const std::size_t count = std::min(points_.size(), recorded_.trace.size());
    for (std::size_t tick = 0; tick < count; ++tick)
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const int off = std::abs(points_[tick].steps[axis] - recorded_.trace[tick][axis]);
        if (off != 0 && result.largest_deviation_mm == 0)
          result.detail += fmt::format("; first at tick {}, P{:04} N{:03}", tick, points_[tick].source.program,
                                       points_[tick].source.block);
        result.largest_deviation_mm = std::max(result.largest_deviation_mm, off / per_mm[axis]);
      }
  }

  const RecordedRun& recorded_;
  machine::SimulatedMachine machine_;
  std::shared_ptr<machine::Channel> channel_;
  panel::Run run_;
  /// Records of older versions do not say when a question was answered.
  panel::Run::Questions between_resumptions_;
  std::size_t next_ = 0;
  std::int64_t ticks_ = 0;
  std::int32_t u_steps_ = 0;
  std::vector<machine::TracePoint> points_;
};

}  // namespace

ReplayResult replay(const RecordedRun& run) { return Player(run).play(); }

}  // namespace cnclab::lab
