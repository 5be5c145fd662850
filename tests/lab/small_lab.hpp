// A lab in one process for tests: messages in, messages out, with a database in memory and a clock of our own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"
#include "shared/frame.hpp"
#include "shared/key.hpp"
#include "shared/screen.hpp"

namespace cnclab::lab {

/// The seat that tests with one student sit at.
inline constexpr std::uint32_t kSeat = 7;

/// Keeps what it is told.
struct FakePeer final : Peer {
  void send(const v1::ServerMessage& message) override { sent.push_back(message); }
  void hang_up(const std::string& why) override { reason = why; }
  [[nodiscard]] std::string address() const override { return "127.0.0.1:4711"; }
  std::deque<v1::ServerMessage> sent;
  std::string reason;
};

/// The far end of a connection: a station's or a console's program, and what it has seen.
struct Caller {
  std::shared_ptr<FakePeer> peer = std::make_shared<FakePeer>();
  std::shared_ptr<Visit> visit;
  std::uint64_t beat = 0, state = 0, handled = 0;  ///< noted by `SmallLab::look`
  std::uint64_t number = 0;                        ///< of the last key struck
  Screen screen;                                   ///< taken in by `SmallLab::look`

  [[nodiscard]] const v1::LoginAnswer* login() const;
};

/// Students eva and udo and the instructor lehrer, each with the password `geheim123`.
class SmallLab {
 public:
  explicit SmallLab(Configuration configuration = {});
  SmallLab(const SmallLab&) = delete;
  SmallLab& operator=(const SmallLab&) = delete;
  ~SmallLab();

  /// Runs answers of the lab's other threads until `done`; throws std::runtime_error after 10 s of real time.
  void settle_until(const std::function<bool()>& done);
  /// Does the work on the database and returns when it is done.
  void with_database(std::function<void(db::Database&)> work);

  [[nodiscard]] Caller call(v1::ClientKind kind = v1::CLIENT_KIND_STATION, std::uint32_t version = kProtocolVersion);
  void log_in(Caller& caller, const std::string& user, std::uint32_t station, const std::string& password = "geheim123",
              v1::Elsewhere elsewhere = v1::ELSEWHERE_UNSPECIFIED);
  /// A key going down in view of nothing.
  void press(Caller& caller, Key key, std::uint64_t number);
  /// A key going down and up in view of what the caller has seen; then `look`.
  void strike(Caller& caller, Key key);
  /// Takes in everything that came as a station's program does: beats answered, screens acknowledged.
  void look(Caller& caller);
  /// An instructor's request; returns the answer.
  v1::InstructorAnswer ask(Caller& console, v1::InstructorRequest request);

  [[nodiscard]] static const std::string& password_hash();  ///< of `geheim123`
  [[nodiscard]] Lab& lab() { return *lab_; }
  void poll() { lab_->poll(); }
  void advance_ms(std::int64_t milliseconds) { now_ns_ += milliseconds * 1'000'000; }

 protected:
  db::Post post();

  /// Ahead of the tick's own clock: when a lease expires, this one decides alone.
  std::int64_t now_ns_ = machine::TickThread::now_ns() + 3'600'000'000'000;
  std::int64_t unix_ms_ = 1'000'000'000'000;
  std::mutex mutex_;
  std::condition_variable came_;
  std::deque<std::function<void()>> jobs_;
  machine::TickThread ticks_;
  std::unique_ptr<db::Store> store_;
  std::unique_ptr<Lab> lab_;
};

}  // namespace cnclab::lab
