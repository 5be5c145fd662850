// A thread that does one job after the other, off the lab thread.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace cnclab::lab {

class WorkerThread {
 public:
  WorkerThread();
  ~WorkerThread();  ///< finishes the job at hand, drops those that wait
  WorkerThread(const WorkerThread&) = delete;
  WorkerThread& operator=(const WorkerThread&) = delete;

  /// Any thread. Jobs run in their order; a job must not throw.
  void enqueue(std::function<void()> job);

 private:
  void work(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any waiting_;
  std::deque<std::function<void()>> jobs_;
  std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace cnclab::lab
