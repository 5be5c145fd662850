// Looks four times per limit.
#include "machine/watchdog.hpp"

#include <utility>

namespace cnclab::machine {

bool StallDetector::look(std::uint64_t ticks, std::int64_t now_ns) {
  if (!has_looked_ || ticks_ != ticks) {
    ticks_ = ticks;
    since_ns_ = now_ns;
    has_looked_ = true;
    is_told_ = false;
    return false;
  }
  if (is_told_ || now_ns - since_ns_ < limit_.count()) return false;
  return is_told_ = true;
}

Watchdog::Watchdog(const TickThread& beat, std::chrono::milliseconds limit)
    : beat_(beat), limit_(limit), thread_([this] { run(); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

void Watchdog::guard(std::shared_ptr<Channel> channel) {
  const std::lock_guard lock(mutex_);
  guarded_.push_back(std::move(channel));
}

std::uint64_t Watchdog::stalls() const {
  const std::lock_guard lock(mutex_);
  return stalls_;
}

void Watchdog::run() {
  StallDetector detector(limit_);
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, limit_ / 4, [this] { return is_ending_; })) {
    if (!detector.look(beat_.statistics().ticks, TickThread::now_ns())) continue;
    ++stalls_;
    for (const auto& channel : guarded_) channel->cut();
  }
}

}  // namespace cnclab::machine
