// The tick cannot wake anybody, so the thread looks by itself, a hundred times a second.
#include "machine/workpiece_thread.hpp"

#include <algorithm>
#include <chrono>

namespace cnclab::machine {

namespace {

constexpr std::chrono::milliseconds kPause{10};
/// Points of one site before the others have their turn: a second of motion.
constexpr std::size_t kAtOnce = 1000;

}  // namespace

bool MillingSite::work(std::size_t most) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < most; ++i) {
    const auto point = feed_.ring.pop();
    if (!point) {
      milling_.flush();
      return false;
    }
    milling_.take(*point);
  }
  return true;
}

void MillingSite::set_spec(const WorkpieceSpec& spec) {
  const std::lock_guard lock(mutex_);
  milling_.set_spec(spec);
}

std::optional<Workpiece> MillingSite::piece() const {
  const std::lock_guard lock(mutex_);
  if (milling_.piece() == nullptr) return std::nullopt;
  return *milling_.piece();
}

std::vector<MillingEvent> MillingSite::events() const {
  const std::lock_guard lock(mutex_);
  return milling_.events();
}

WorkpieceThread::WorkpieceThread() : thread_([this] { run(); }) {}

WorkpieceThread::~WorkpieceThread() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

std::shared_ptr<MillingSite> WorkpieceThread::add(const WorkpieceSpec& spec) {
  const std::lock_guard lock(mutex_);
  return sites_.emplace_back(std::make_shared<MillingSite>(spec));
}

void WorkpieceThread::remove(const std::shared_ptr<MillingSite>& site) {
  const std::lock_guard lock(mutex_);
  std::erase(sites_, site);
}

void WorkpieceThread::run() {
  std::unique_lock lock(mutex_);
  while (!is_ending_) {
    const auto sites = sites_;
    lock.unlock();
    bool is_more = false;
    for (const auto& site : sites) is_more = site->work(kAtOnce) || is_more;
    lock.lock();
    if (!is_more) ended_.wait_for(lock, kPause, [this] { return is_ending_; });
  }
}

}  // namespace cnclab::machine
