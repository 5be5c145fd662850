// The tick cannot wake anybody, so the thread looks by itself, a hundred times a second.
#include "machine/workpiece_thread.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

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
      if (i == 0) milling_.flush();  // the tool stands; else the next points are joined to these
      tell_news();
      return false;
    }
    if (point->begins_run) tell_news();
    milling_.take(*point);
    if (point->begins_run) told_ = 0;
  }
  tell_news();
  return true;
}

/// A few short records at most, so whoever takes them waits for next to nothing.
void MillingSite::tell_news() {
  const auto& events = milling_.events();
  if (told_ == events.size()) return;
  const std::lock_guard lock(news_mutex_);
  news_.insert(news_.end(), events.begin() + static_cast<std::ptrdiff_t>(told_), events.end());
  told_ = events.size();
  has_news_.store(true, std::memory_order_release);
}

std::vector<MillingEvent> MillingSite::take_news() {
  if (!has_news_.load(std::memory_order_acquire)) return {};
  const std::lock_guard lock(news_mutex_);
  has_news_.store(false, std::memory_order_relaxed);
  return std::exchange(news_, {});
}

void MillingSite::set_spec(const WorkpieceSpec& spec) {
  const std::lock_guard lock(mutex_);
  milling_.set_spec(spec);
}

std::optional<Workpiece> MillingSite::piece() {
  const std::lock_guard lock(mutex_);
  milling_.flush();
  if (milling_.piece() == nullptr) return std::nullopt;
  return *milling_.piece();
}

std::vector<MillingEvent> MillingSite::events() {
  const std::lock_guard lock(mutex_);
  milling_.flush();
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
