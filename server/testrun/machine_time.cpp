// A machine without iron, in ticks of 1 ms as the real one has.
#include "testrun/machine_time.hpp"

#include <deque>

#include "geometry/path_math.hpp"
#include "motion/follower.hpp"
#include "motion/planner.hpp"

namespace cnclab::testrun {

namespace {

constexpr double kTick_s = 0.001;
/// From here on coarser ticks do: a rest may count up to 10 ms longer, which no longer matters.
constexpr double kCoarseFrom_s = 600, kCoarseTick_s = 0.01;
/// Planned anew when so many wait, followed until half of them do: far more than a braking way needs.
constexpr std::size_t kMostWaiting = 1024, kKeepWaiting = 512;
/// Ticks without motion after which the path counts as done: what rests so long is starved.
constexpr int kRestTicks = 3;

}  // namespace

struct MachineTime::Impl {
  Impl(const geometry::Point& start, const motion::Limits& limits) : planner(queue, limits), follower(queue, limits) {
    follower.begin(planner.run(), start, limits);
  }

  /// One tick, with whatever events it reaches.
  void tick() {
    const double tick_s = seconds < kCoarseFrom_s ? kTick_s : kCoarseTick_s;
    double left_s = tick_s;
    has_moved = false;
    while (left_s > 0) {
      const motion::Advance done = follower.advance(left_s, {});
      has_moved = has_moved || done.moving || done.event_reached;
      left_s = done.left_s;
      if (!done.event_reached) break;
      if (const auto* segment = follower.current())
        if (const auto* dwell = std::get_if<geometry::Dwell>(&segment->item.what)) seconds += dwell->seconds;
      static_cast<void>(follower.pass_event());
    }
    seconds += tick_s - left_s;
  }

  void follow(std::size_t until_waiting) {
    planner.plan();
    for (int rested = 0; queue.waiting() > until_waiting && rested < kRestTicks; rested = has_moved ? 0 : rested + 1)
      tick();
    queue.trim();
    for (; nominal_s.size() > queue.waiting(); nominal_s.pop_front()) waiting_s -= nominal_s.front();
    if (nominal_s.empty()) waiting_s = 0;  // no rest of rounding
  }

  void take(const geometry::PathItem& item) {
    static_cast<void>(planner.append(item));  // the window is far larger than what ever waits
    nominal_s.push_back(geometry::seconds_at_feed(item));
    waiting_s += nominal_s.back();
    if (queue.waiting() >= kMostWaiting) follow(kKeepWaiting);
  }

  motion::SegmentQueue queue;
  motion::Planner planner;
  motion::Follower follower;
  double seconds = 0;            ///< of what was followed
  std::deque<double> nominal_s;  ///< of each segment that waits
  double waiting_s = 0;          ///< their sum
  bool has_moved = false;
};

MachineTime::MachineTime(const geometry::Point& start, const motion::Limits& limits)
    : impl_(std::make_unique<Impl>(start, limits)) {}
MachineTime::~MachineTime() = default;
MachineTime::MachineTime(MachineTime&&) noexcept = default;
MachineTime& MachineTime::operator=(MachineTime&&) noexcept = default;

void MachineTime::take(const geometry::PathItem& item) { impl_->take(item); }

void MachineTime::finish() { impl_->follow(0); }

double MachineTime::seconds() const { return impl_->seconds + impl_->waiting_s; }

}  // namespace cnclab::testrun
