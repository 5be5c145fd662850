// The tick waits for nothing (architecture.md rule 6): it allocates nothing, takes no lock, makes no system call.
//
// operator new and pthread_mutex_lock are replaced and count; system calls are caught by the kernel's own filter, which
// holds for the thread that ticks alone.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>
#include <thread>

#include "channel_rig.hpp"
#include "machine/milling.hpp"
#include "machine/recorder.hpp"

namespace {
std::atomic<bool> counting{false};
std::atomic<std::uint64_t> allocations{0}, locks{0}, system_calls{0};

void* counted(std::size_t size) {
  if (counting.load()) allocations.fetch_add(1);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* counted(std::size_t size, std::align_val_t alignment) {
  if (counting.load()) allocations.fetch_add(1);
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return counted(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return counted(size, alignment); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

/// Every std::mutex of the process comes by here.
extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  using Lock = int (*)(pthread_mutex_t*);
  static const auto kReal = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  if (counting.load()) locks.fetch_add(1);
  return kReal(mutex);
}

namespace cnclab::machine {
namespace {

/// What a system call of the filtered thread leads to; the call itself is not made.
void count_call(int) {
  if (counting.load()) system_calls.fetch_add(1);
}

/// From here on every system call of this thread but its end is a signal. False where the kernel has no filters.
bool forbid_system_calls() {
  struct sigaction action{};
  action.sa_handler = count_call;
  sigaction(SIGSYS, &action, nullptr);
  constexpr std::uint32_t kNumber = offsetof(seccomp_data, nr);
  std::array<sock_filter, 5> filter{
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kNumber), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigreturn, 2, 0),
       BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit, 1, 0), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// A thread that may do nothing but calculate; jobs are handed to it without locks.
class SilentThread {
 public:
  SilentThread() : thread_([this] { run(); }) {
    while (state_.load() == State::starting) std::this_thread::yield();
  }
  ~SilentThread() {
    state_.store(State::ending);
    thread_.join();
  }
  [[nodiscard]] bool is_filtered() const { return is_filtered_; }

  /// Does it there, counting, and waits for its end.
  template <class Job>
  void watch(Job& job) {
    job_ = [](void* what) { (*static_cast<Job*>(what))(); };
    what_ = &job;
    state_.store(State::busy);
    while (state_.load() == State::busy) std::this_thread::yield();
  }

 private:
  enum class State { starting, idle, busy, ending };

  void run() {
    void* volatile place =
        std::malloc(64);  // the allocator's own place for this thread, which the first `new` would ask for
    std::free(place);
    is_filtered_ = forbid_system_calls();
    state_.store(State::idle);
    for (;;) {
      const State state = state_.load();
      if (state == State::ending) return;
      if (state != State::busy) continue;
      counting = true;
      job_(what_);
      counting = false;
      state_.store(State::idle);
    }
  }

  std::atomic<State> state_{State::starting};
  bool is_filtered_ = false;
  void (*job_)(void*) = nullptr;
  void* what_ = nullptr;
  std::thread thread_;
};

/// The sanitizers' own code allocates, locks and calls wherever it likes.
constexpr bool kHasSanitizer =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

void forget_counts() { allocations = locks = system_calls = 0; }

/// Ticks in the silent thread, a job that does nothing else.
struct Ticks {
  ChannelRig& rig;
  int count;
  void operator()() const {
    for (int i = 0; i < count; ++i) rig.channel.tick(rig.now_ns += kTick_ns, kTick_s);
  }
};

TEST(TickCost, RULE_6_TheCountersCount) {
  if (kHasSanitizer) GTEST_SKIP() << "under a sanitizer, whose own code allocates, locks and calls";
  SilentThread thread;
  if (!thread.is_filtered()) GTEST_SKIP() << "this kernel filters no system calls";
  forget_counts();
  std::mutex mutex;
  auto loud = [&mutex] {
    delete new int(2);
    const std::lock_guard lock(mutex);
    static_cast<void>(syscall(SYS_getppid));
  };
  thread.watch(loud);
  EXPECT_EQ(allocations, 1U);
  EXPECT_EQ(locks, 1U);
  EXPECT_EQ(system_calls, 1U);
}

TEST(TickCost, RULE_6_NoTickOfAnyKindAllocatesLocksOrCallsTheSystem) {
  if (kHasSanitizer) GTEST_SKIP() << "under a sanitizer, whose own code allocates, locks and calls";
  SilentThread thread;
  if (!thread.is_filtered()) GTEST_SKIP() << "this kernel filters no system calls";
  ChannelRig rig(data_with({{3, 60'000}}));
  rig.channel.record_trace(true);
  const auto cuts = std::make_unique<CutFeed>();
  rig.channel.feed_cuts(cuts.get());
  const auto ticks = [&](int count) {
    Ticks job{rig, count};
    thread.watch(job);
  };
  Items items;
  items.line_to({5, 5, 0, 0}).add(geometry::Spindle{geometry::SpindleTurn::clockwise, 100}).add(geometry::Dwell{0.1});
  items.add(
      geometry::Arc{{5, 5, 0, 0}, {5, 5, 0, 0}, {0, 5, 0, 0}, geometry::Turn::clockwise, geometry::Plane::xy, 900});
  items.add(geometry::Wait{1, 1}).add(geometry::Reference{{true, false, false}, {1, 0, 0}});
  items.add(geometry::Halt{true}).line_to({60, 5, 0, 0});
  rig.begin(items);
  rig.go();
  forget_counts();
  ticks(3000);
  rig.go();
  ticks(5000);  // wait cancelled, reference, halt
  rig.channel.stop(StopCause::operator_stop);
  ticks(500);
  rig.go();
  rig.channel.set_override(0.7);
  ticks(4000);  // onto the switch and back
  (void)rig.channel.command(Jog{kLease, {-1, 0, 1}});
  ticks(300);
  rig.channel.revoke(StopCause::lease_ended);
  ticks(500);
  EXPECT_EQ(allocations, 0U);
  EXPECT_EQ(locks, 0U);
  EXPECT_EQ(system_calls, 0U);
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::lease_ended);
  EXPECT_GT(rig.machine.moving_ticks, 2000);
  EXPECT_TRUE(cuts->ring.pop()) << "the workpiece was fed";
}

TEST(TickCost, RecordingAndReplayingAllocateNothing) {
  SimulatedMachine simulated({});
  MachineRecorder recorder(simulated, 4000);
  Outputs outputs;
  allocations = 0;
  counting = true;
  for (int i = 0; i < 2000; ++i) {
    outputs.steps = {i % 9, -i, 0, 0};
    (void)recorder.exchange(outputs);
  }
  counting = false;
  EXPECT_EQ(allocations, 0U);
  EXPECT_GT(recorder.ticks_lost(), 0U) << "also when it is full";
  const auto bytes = recorder.bytes();
  ReplayMachine replay(bytes);
  counting = true;
  for (int i = 0; i < 2000; ++i) (void)replay.exchange(outputs);
  counting = false;
  EXPECT_EQ(allocations, 0U);
}

}  // namespace
}  // namespace cnclab::machine
