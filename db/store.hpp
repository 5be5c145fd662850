// The one thread that writes: jobs in, answers back; jobs that wait together are committed together (STO-002, STO-009).
#pragma once

#include <chrono>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "db/database.hpp"
#include "db/failure.hpp"

namespace cnclab::db {

/// Why a job was not stored; nothing of it is in the database.
struct StoreError {
  std::string text;  ///< German: what happened and what to do, for the screen that wanted to store
  FailureKind kind = FailureKind::refused;  ///< `explain(kind, "en")` says it in English
  std::string detail = {};                  ///< for the log: the failing step and SQLite's own words
};

/// How long a job that has waited so long already still waits for somebody else's lock (STO-009).
[[nodiscard]] std::chrono::milliseconds patience_left(std::chrono::milliseconds waited);

/// Runs a function on the thread that wants the answers (the lab's).
using Post = std::function<void(std::function<void()>)>;

class Store {
 public:
  /// Takes the database to its own thread.
  Store(Database database, Post post);
  /// Finishes what waits, then ends the thread.
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Queues `job` (from any thread); `done` is posted after the commit that holds it is on disk, or with the error and
  /// nothing stored.
  template <class Job, class Done>
  void run(Job job, Done done) {
    using Result = std::invoke_result_t<Job, Database&>;
    if constexpr (std::is_void_v<Result>) {
      enqueue([job = std::move(job)](Database& db) mutable { job(db); },
              [done = std::move(done)](std::expected<void, StoreError> result) mutable { done(std::move(result)); });
    } else {
      auto slot = std::make_shared<std::optional<Result>>();
      enqueue([job = std::move(job), slot](Database& db) mutable { slot->emplace(job(db)); },
              [done = std::move(done), slot](std::expected<void, StoreError> result) mutable {
                if (!result) return done(std::expected<Result, StoreError>(std::unexpected(result.error())));
                done(std::expected<Result, StoreError>(std::move(**slot)));
              });
    }
  }

  /// Jobs waiting and commits so far, for `status` and benchmarks.
  struct Counters {
    std::uint64_t jobs = 0, commits = 0, failures = 0;
    std::size_t waiting = 0;
  };
  [[nodiscard]] Counters counters() const;

 private:
  void enqueue(std::function<void(Database&)> job, std::function<void(std::expected<void, StoreError>)> done);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::db
