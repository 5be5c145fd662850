// The thread that removes material, so that neither the tick nor the lab waits for it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "machine/milling.hpp"

namespace cnclab::machine {

/// One machine's workpiece. The tick pushes into `feed()`, the thread works, anybody looks.
class MillingSite {
 public:
  explicit MillingSite(const WorkpieceSpec& spec) : milling_(spec) {}

  [[nodiscard]] CutFeed& feed() { return feed_; }
  /// Takes what waits, at most `most` points. True when more is left. One thread at a time.
  bool work(std::size_t most);

  // Any thread.
  void set_spec(const WorkpieceSpec& spec);
  /// A copy of the piece as far as it is worked; nothing before the first program start.
  [[nodiscard]] std::optional<Workpiece> piece();
  [[nodiscard]] std::vector<MillingEvent> events();
  /// The events that came since the last call. Waits for no work: nothing while there are none.
  [[nodiscard]] std::vector<MillingEvent> take_news();
  [[nodiscard]] std::uint64_t dropped() const { return feed_.dropped.load(std::memory_order_relaxed); }

 private:
  void tell_news();

  CutFeed feed_;
  std::mutex mutex_;
  Milling milling_;
  std::size_t told_ = 0;  ///< of the piece's events
  std::atomic<bool> has_news_{false};
  std::mutex news_mutex_;  ///< never held while cutting
  std::vector<MillingEvent> news_;
};

class WorkpieceThread {
 public:
  WorkpieceThread();
  ~WorkpieceThread();  ///< stops and joins

  /// The site is worked until it is removed; it lives as long as anybody holds it.
  [[nodiscard]] std::shared_ptr<MillingSite> add(const WorkpieceSpec& spec);
  void remove(const std::shared_ptr<MillingSite>& site);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable ended_;
  std::vector<std::shared_ptr<MillingSite>> sites_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace cnclab::machine
