// The writer thread: takes all jobs that wait, runs them in one transaction, commits, answers.
#include "db/store.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cnclab::db {
namespace {

using Answer = std::expected<void, StoreError>;

using Clock = std::chrono::steady_clock;

struct Waiting {
  std::function<void(Database&)> job;
  std::function<void(Answer)> done;
  Clock::time_point since;
};

// A lock that one transaction has waited for in vain is no reason for the next one to wait as long again: each job is
// answered when its own patience ends.
std::chrono::milliseconds patience_of(const Waiting& oldest) {
  return patience_left(std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - oldest.since));
}

StoreError error_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const StoreFailure& failure) {
    return {std::string(explain(failure.kind(), "de")), failure.kind(), failure.what()};
  } catch (const std::exception& exception) {
    return {std::string(explain(FailureKind::refused, "de")), FailureKind::refused, exception.what()};
  }
}

// What one transaction gave: the answers of the jobs that are settled now, in order.
struct Settled {
  std::vector<Answer> answers;
  bool is_committed = false;
};

// Each job runs in a savepoint of its own, so one that fails takes nothing of the others with it.
Answer attempt(Database& database, Waiting& waiting) {
  try {
    database.transaction([&] { waiting.job(database); });
    return {};
  } catch (...) {
    return std::unexpected(error_of(std::current_exception()));
  }
}

// Runs jobs[first…] in one transaction. Where SQLite gave the whole transaction up in the middle (full disk), the jobs
// before share the error of the one that hit it, and the later ones are left for another transaction.
Settled commit_together(Database& database, std::vector<Waiting>& jobs, std::size_t first) {
  Settled settled;
  bool has_begun = false;
  database.set_patience(patience_of(jobs[first]));
  try {
    database.transaction([&] {
      has_begun = true;
      for (std::size_t i = first; i < jobs.size() && database.in_transaction(); ++i)
        settled.answers.push_back(attempt(database, jobs[i]));
    });
    settled.is_committed = true;
  } catch (...) {
    StoreError error = error_of(std::current_exception());
    if (!has_begun) settled.answers.resize(jobs.size() - first);
    if (has_begun && !settled.answers.empty() && !settled.answers.back()) error = settled.answers.back().error();
    for (Answer& answer : settled.answers)
      if (answer) answer = std::unexpected(error);
  }
  return settled;
}

}  // namespace

std::chrono::milliseconds patience_left(std::chrono::milliseconds waited) {
  constexpr std::chrono::milliseconds kLeast{100};  // for what is busy for a moment
  return std::max(kLeast, kPatience - waited);
}

struct Store::Impl {
  Impl(Database taken, Post to) : database(std::move(taken)), post(std::move(to)) {}

  // Ends when it is told to and nothing waits any more.
  void work() {
    for (std::vector<Waiting> jobs = take(); !jobs.empty(); jobs = take())
      for (std::size_t first = 0; first < jobs.size();) first += settle(jobs, first);
  }

  std::vector<Waiting> take() {
    std::unique_lock lock(mutex);
    wake.wait(lock, [this] { return is_ending || !waiting.empty(); });
    return std::exchange(waiting, {});
  }

  // Commits, counts and answers; returns how many jobs are settled.
  std::size_t settle(std::vector<Waiting>& jobs, std::size_t first) {
    Settled settled = commit_together(database, jobs, first);
    const std::size_t count = settled.answers.size();
    {
      const std::lock_guard lock(mutex);
      counts.jobs += count;
      if (settled.is_committed) ++counts.commits;
      for (const Answer& answer : settled.answers)
        if (!answer) ++counts.failures;
      counts.waiting -= count;
    }
    for (std::size_t i = 0; i < count; ++i)
      post([done = std::move(jobs[first + i].done), answer = std::move(settled.answers[i])] { done(answer); });
    return count;
  }

  Database database;  // the writer thread's alone
  Post post;
  mutable std::mutex mutex;
  std::condition_variable wake;
  std::vector<Waiting> waiting;
  Counters counts;
  bool is_ending = false;
  std::thread writer;
};

Store::Store(Database database, Post post) : impl_(std::make_unique<Impl>(std::move(database), std::move(post))) {
  impl_->writer = std::thread([impl = impl_.get()] { impl->work(); });
}

Store::~Store() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->is_ending = true;
  }
  impl_->wake.notify_one();
  impl_->writer.join();
}

void Store::enqueue(std::function<void(Database&)> job, std::function<void(Answer)> done) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->waiting.push_back({std::move(job), std::move(done), Clock::now()});
    ++impl_->counts.waiting;
  }
  impl_->wake.notify_one();
}

Store::Counters Store::counters() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->counts;
}

}  // namespace cnclab::db
