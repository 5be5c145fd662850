// Passwords: Argon2id through libsodium, one at a time on a thread of its own (SEC-002, architecture.md rule 7).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "db/store.hpp"

namespace cnclab::lab {

/// Random, readable, 16 characters in groups of four without those that look alike.
[[nodiscard]] std::string one_time_password();

/// As `one_time_password`, 12 characters: 60 bits that a student reads off a screen, for one login.
[[nodiscard]] std::string line_token();

/// 32 random bytes, for session tickets.
[[nodiscard]] std::string random_ticket();

/// 19 MiB, 2 passes. Takes some 30 ms: off the lab thread, but for the very first start.
[[nodiscard]] std::string hash_password(const std::string& password);

class PasswordWorker {
 public:
  explicit PasswordWorker(db::Post post);
  ~PasswordWorker();  ///< drops what waits
  PasswordWorker(const PasswordWorker&) = delete;
  PasswordWorker& operator=(const PasswordWorker&) = delete;

  /// An empty hash stands for an unknown name: it costs the same time and never fits (SEC-003).
  void verify(std::string password, std::string hash, std::function<void(bool fits)> done);
  void hash(std::string password, std::function<void(std::string hash)> done);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::lab
