// Growing delays after wrong passwords, per name and per address (SEC-003).
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace cnclab::lab {

/// After five wrong passwords each further one doubles the delay, from 1 s to 30 s. Knows nothing of whether a name
/// exists, so unknown names are treated alike. Bounded: the oldest entries are forgotten first.
class LoginGuard {
 public:
  static constexpr int kFreeTries = 5;
  static constexpr std::int64_t kLongestDelay_s = 30;
  static constexpr std::size_t kMostEntries = 4096;

  /// Seconds to wait before this name or this address may try again; 0 = now.
  [[nodiscard]] int wait_seconds(const std::string& name, const std::string& address, std::int64_t now_ns) const;
  void failed(const std::string& name, const std::string& address, std::int64_t now_ns);
  void succeeded(const std::string& name, const std::string& address);

 private:
  struct Record {
    int failures = 0;
    std::int64_t last_ns = 0;
    std::int64_t blocked_until_ns = 0;
  };
  void count(const std::string& key, std::int64_t now_ns);
  std::map<std::string, Record> records_;
};

}  // namespace cnclab::lab
