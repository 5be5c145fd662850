// Growing delays after wrong passwords.
#include "lab/login_guard.hpp"

#include <algorithm>

#include "lab/clock.hpp"

namespace cnclab::lab {

namespace {
std::string name_key(const std::string& name) { return "n" + name; }
std::string address_key(const std::string& address) { return "a" + address.substr(0, address.rfind(':')); }
}  // namespace

int LoginGuard::wait_seconds(const std::string& name, const std::string& address, std::int64_t now_ns) const {
  std::int64_t until_ns = 0;
  for (const std::string& key : {name_key(name), address_key(address)})
    if (const auto record = records_.find(key); record != records_.end())
      until_ns = std::max(until_ns, record->second.blocked_until_ns);
  if (until_ns <= now_ns) return 0;
  return static_cast<int>((until_ns - now_ns + kSecond_ns - 1) / kSecond_ns);
}

void LoginGuard::failed(const std::string& name, const std::string& address, std::int64_t now_ns) {
  count(record_of(name_key(name)), kFreeTries, now_ns);
  Record& from_there = record_of(address_key(address));
  const std::int64_t forgiven = (now_ns - from_there.last_ns) / (kForgivenEach_s * kSecond_ns);
  from_there.failures -= static_cast<int>(std::clamp<std::int64_t>(forgiven, 0, from_there.failures));
  count(from_there, kFreeTriesOfAddress, now_ns);
}

void LoginGuard::succeeded(const std::string& name) { records_.erase(name_key(name)); }

LoginGuard::Record& LoginGuard::record_of(const std::string& key) {
  if (records_.size() >= kMostEntries && !records_.contains(key)) {
    const auto oldest = std::ranges::min_element(records_, {}, [](const auto& entry) { return entry.second.last_ns; });
    records_.erase(oldest);
  }
  return records_[key];
}

void LoginGuard::count(Record& record, int free_tries, std::int64_t now_ns) {
  ++record.failures;
  record.last_ns = now_ns;
  if (record.failures < free_tries) return;
  const int doublings = std::min(record.failures - free_tries, 5);
  record.blocked_until_ns = now_ns + std::min(std::int64_t{1} << doublings, kLongestDelay_s) * kSecond_ns;
}

}  // namespace cnclab::lab
