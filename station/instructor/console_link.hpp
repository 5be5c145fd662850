// The console's line to the server: status five times a second, commands as they come, a new line when it is lost.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "instructor/command_line.hpp"
#include "instructor/session.hpp"

namespace cnclab::instructor {

/// What the line tells the console.
struct LinkEvents {
  std::function<void(const v1::Status&)> status;
  std::function<void(const v1::InstructorRequest&, const v1::InstructorAnswer&)> answer;
  std::function<void(bool is_connected)> line;
  std::function<void(const Failure&)> ended;  ///< for good: expelled, password changed, other certificate
};

/// Keeps one connection alive and makes a new one when it is lost, after pauses that grow up to 5 s. What was asked
/// on a lost line is never asked again (SEAT-005). One thread: the context's.
class ConsoleLink {
 public:
  ConsoleLink(boost::asio::io_context& context, Access access, Credentials credentials, LinkEvents events);

  /// Takes over the connection on which the user has logged in.
  void start(station::Client client);
  /// Sends a command; an urgent one before everything that waits.
  void send(v1::InstructorRequest request, bool is_urgent);
  /// Logs out; the context has nothing more to do soon after.
  void stop();

 private:
  using Clock = std::chrono::steady_clock;

  boost::asio::awaitable<void> keep_connected(station::Client client);
  boost::asio::awaitable<std::optional<station::Client>> reconnect();
  boost::asio::awaitable<void> talk(std::shared_ptr<station::Client> client);
  boost::asio::awaitable<void> write_all(std::shared_ptr<station::Client> client);
  boost::asio::awaitable<void> watch(std::shared_ptr<station::Client> client);
  boost::asio::awaitable<void> pause(std::chrono::milliseconds time);
  void take(const v1::ServerMessage& message);
  void enqueue(v1::ClientMessage message, bool is_urgent);

  boost::asio::io_context& context_;
  Access access_;
  Credentials credentials_;
  LinkEvents events_;
  std::shared_ptr<station::Client> client_;  ///< empty while the line is lost
  std::deque<v1::ClientMessage> outgoing_;
  boost::asio::steady_timer outgoing_signal_;
  std::map<std::uint64_t, v1::InstructorRequest> asked_;  ///< commands without an answer yet
  std::uint64_t number_ = 0;
  std::uint64_t status_number_ = 0;  ///< of the status that has not been answered yet, 0 none
  Clock::time_point last_heard_{};
  bool has_ended_ = false;
};

}  // namespace cnclab::instructor
