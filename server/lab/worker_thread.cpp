// Jobs from a queue, one at a time.
#include "lab/worker_thread.hpp"

#include <utility>

namespace cnclab::lab {

WorkerThread::WorkerThread() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

WorkerThread::~WorkerThread() = default;

void WorkerThread::enqueue(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  waiting_.notify_one();
}

void WorkerThread::work(const std::stop_token& stop) {
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      if (!waiting_.wait(lock, stop, [this] { return !jobs_.empty(); })) return;
      if (stop.stop_requested()) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
  }
}

}  // namespace cnclab::lab
