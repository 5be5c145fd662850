// The beat: absolute 1 ms waits, channels in places that are swapped without locks.
#include "machine/tick_thread.hpp"

#include <fmt/core.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace cnclab::machine {

namespace {

constexpr std::int64_t kPeriod_ns = TickThread::kPeriod.count();
constexpr std::int64_t kVeryLate_ns = 5 * kPeriod_ns;  // LOAD-003
constexpr double kPeriod_s = static_cast<double>(kPeriod_ns) / 1e9;
constexpr int kPriority = 60;  // above ordinary threads, below the kernel's own interrupt threads

void wait_until(std::int64_t time_ns) {
  const timespec time{.tv_sec = time_ns / 1'000'000'000, .tv_nsec = time_ns % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

/// 0, or the error.
int take_real_time_priority(std::thread& thread) {
  const sched_param parameter{.sched_priority = kPriority};
  return pthread_setschedparam(thread.native_handle(), SCHED_FIFO, &parameter);
}

std::string describe_priority(int error) {
  if (error == 0) return fmt::format("SCHED_FIFO {}", kPriority);
  return fmt::format("ordinary scheduling ({})", std::strerror(error));
}

struct LockedMemory {
  bool is_locked = false;
  std::string description;
};

/// Pages stay once they were touched; untouched ones stay unused (MCL_ONFAULT), so lazily used memory costs nothing.
/// Only without a limit: with one, later allocations of the whole server would fail.
LockedMemory lock_memory() {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) {
    return {false, "memory not locked (RLIMIT_MEMLOCK)"};
  }
  if (mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0) return {true, "memory locked when used"};
  return {false, fmt::format("memory not locked ({})", std::strerror(errno))};
}

}  // namespace

struct TickThread::Impl {
  std::array<std::atomic<Channel*>, kMostChannels> places{};
  std::array<std::shared_ptr<Channel>, kMostChannels> owners;  ///< lab thread
  std::atomic<std::uint64_t> rounds_begun{0}, rounds_done{0};
  std::atomic<bool> is_ending{false};
  std::atomic<std::uint64_t> ticks{0}, late{0}, very_late{0};
  std::atomic<std::int64_t> longest_delay_ns{0};
  std::string privileges;
  bool is_real_time = false, has_locked_memory = false;
  std::thread thread;

  void run();
  void count(std::int64_t delay_ns);
};

void TickThread::Impl::count(std::int64_t delay_ns) {
  ticks.fetch_add(1, std::memory_order_relaxed);
  if (delay_ns > kPeriod_ns) late.fetch_add(1, std::memory_order_relaxed);
  if (delay_ns > kVeryLate_ns) very_late.fetch_add(1, std::memory_order_relaxed);
  if (delay_ns > longest_delay_ns.load(std::memory_order_relaxed)) {
    longest_delay_ns.store(delay_ns, std::memory_order_relaxed);
  }
}

void TickThread::Impl::run() {
  prctl(PR_SET_NAME, "cnclab-tick");
  prctl(PR_SET_TIMERSLACK, 1);
  std::int64_t due_ns = now_ns() + kPeriod_ns;
  while (!is_ending.load(std::memory_order_relaxed)) {
    wait_until(due_ns);
    const std::int64_t began_ns = now_ns();
    count(began_ns - due_ns);
    rounds_begun.fetch_add(1, std::memory_order_seq_cst);
    for (auto& place : places) {
      Channel* channel = place.load(std::memory_order_seq_cst);
      if (channel != nullptr) channel->tick(began_ns, kPeriod_s);
    }
    rounds_done.fetch_add(1, std::memory_order_seq_cst);
    // Lost time is not made up for: a burst of ticks would be motion above the programmed speed.
    due_ns = std::max(due_ns, began_ns - kPeriod_ns) + kPeriod_ns;
  }
}

TickThread::TickThread() : impl_(std::make_unique<Impl>()) {
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
  const int error = take_real_time_priority(impl_->thread);
  impl_->is_real_time = error == 0;
  const LockedMemory memory = lock_memory();
  impl_->has_locked_memory = memory.is_locked;
  impl_->privileges = describe_priority(error) + ", " + memory.description;
}

TickThread::~TickThread() {
  impl_->is_ending.store(true, std::memory_order_relaxed);
  impl_->thread.join();
}

const std::string& TickThread::privileges() const { return impl_->privileges; }

bool TickThread::is_real_time() const { return impl_->is_real_time; }

bool TickThread::has_locked_memory() const { return impl_->has_locked_memory; }

bool TickThread::add(std::shared_ptr<Channel> channel) {
  for (std::size_t i = 0; i < kMostChannels; ++i) {
    if (impl_->owners[i] != nullptr) continue;
    impl_->owners[i] = std::move(channel);
    impl_->places[i].store(impl_->owners[i].get(), std::memory_order_seq_cst);
    return true;
  }
  return false;
}

void TickThread::remove(const std::shared_ptr<Channel>& channel) {
  const auto owner = std::ranges::find(impl_->owners, channel);
  if (channel == nullptr || owner == impl_->owners.end()) return;
  impl_->places[static_cast<std::size_t>(owner - impl_->owners.begin())].store(nullptr, std::memory_order_seq_cst);
  // A round that begins from here on does not see the channel; one that is under way is waited for.
  const std::uint64_t begun = impl_->rounds_begun.load(std::memory_order_seq_cst);
  while (impl_->rounds_done.load(std::memory_order_seq_cst) < begun) {
    constexpr timespec kShortWhile{.tv_sec = 0, .tv_nsec = 50'000};
    nanosleep(&kShortWhile, nullptr);
  }
  owner->reset();
}

TickStatistics TickThread::statistics() const {
  return {impl_->ticks.load(std::memory_order_relaxed), impl_->late.load(std::memory_order_relaxed),
          impl_->very_late.load(std::memory_order_relaxed), impl_->longest_delay_ns.load(std::memory_order_relaxed)};
}

std::int64_t TickThread::now_ns() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace cnclab::machine
