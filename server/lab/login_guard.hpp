// Growing delays after wrong passwords, per name and per address (SEC-003).
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace cnclab::lab {

/// After five wrong passwords for a name each further one doubles the delay, from 1 s to 30 s; for an address, which a
/// class may share behind a router, after as many as fifteen students have free together. A right password forgives
/// what was wrong for that name; an address is forgiven one wrong password a minute and nothing else, so that who logs
/// in between cannot go on trying others' names. Knows nothing of whether a name exists, so unknown names are treated
/// alike. Bounded: the oldest entries are forgotten first.
class LoginGuard {
 public:
  static constexpr int kFreeTries = 5;
  static constexpr int kFreeTriesOfAddress = 15 * kFreeTries;
  static constexpr std::int64_t kForgivenEach_s = 60;  ///< one wrong password from an address
  static constexpr std::int64_t kLongestDelay_s = 30;
  static constexpr std::size_t kMostEntries = 4096;

  /// Seconds to wait before this name or this address may try again; 0 = now.
  [[nodiscard]] int wait_seconds(const std::string& name, const std::string& address, std::int64_t now_ns) const;
  void failed(const std::string& name, const std::string& address, std::int64_t now_ns);
  void succeeded(const std::string& name);

 private:
  struct Record {
    int failures = 0;
    std::int64_t last_ns = 0;
    std::int64_t blocked_until_ns = 0;
  };
  Record& record_of(const std::string& key);
  static void count(Record& record, int free_tries, std::int64_t now_ns);
  std::map<std::string, Record> records_;
};

}  // namespace cnclab::lab
