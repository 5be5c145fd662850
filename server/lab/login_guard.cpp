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
  count(name_key(name), now_ns);
  count(address_key(address), now_ns);
}

void LoginGuard::succeeded(const std::string& name, const std::string& address) {
  records_.erase(name_key(name));
  records_.erase(address_key(address));
}

void LoginGuard::count(const std::string& key, std::int64_t now_ns) {
  if (records_.size() >= kMostEntries && !records_.contains(key)) {
    const auto oldest = std::ranges::min_element(records_, {}, [](const auto& entry) { return entry.second.last_ns; });
    records_.erase(oldest);
  }
  Record& record = records_[key];
  ++record.failures;
  record.last_ns = now_ns;
  // A class shares one address behind a router: addresses may fail as often as fifteen students together.
  const int free_tries = key.front() == 'a' ? kFreeTries * 15 : kFreeTries;
  if (record.failures < free_tries) return;
  const int doublings = std::min(record.failures - free_tries, 5);
  record.blocked_until_ns = now_ns + std::min(std::int64_t{1} << doublings, kLongestDelay_s) * kSecond_ns;
}

}  // namespace cnclab::lab
