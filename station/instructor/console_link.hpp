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

#include "instructor/bulk_file.hpp"
#include "instructor/command_line.hpp"
#include "instructor/session.hpp"
#include "shared/key.hpp"
#include "shared/screen.hpp"

namespace cnclab::instructor {

/// What the line tells the console.
struct LinkEvents {
  std::function<void(const v1::Status&)> status;
  std::function<void(const v1::InstructorRequest&, const v1::InstructorAnswer&)> answer;
  std::function<void(const Screen&)> screen;  ///< of the station that is watched
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
  /// Sends a command; an urgent one before everything that waits. Content that comes with the answer goes to its file.
  void send(Command command, bool is_urgent);
  /// Presses and releases keys at the keyboard that was taken over, in view of the screen shown last.
  void press(const std::vector<Key>& keys);
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
  void take_answer(const v1::InstructorAnswer& answer);
  void take_chunk(const v1::Chunk& chunk);
  void take_screen(const v1::ScreenUpdate& update);
  void conclude(const Command& command, const std::expected<std::string, Failure>& result);
  void enqueue(v1::ClientMessage message, bool is_urgent);

  boost::asio::io_context& context_;
  Access access_;
  Credentials credentials_;
  LinkEvents events_;
  std::shared_ptr<station::Client> client_;  ///< empty while the line is lost
  std::deque<v1::ClientMessage> outgoing_;
  boost::asio::steady_timer outgoing_signal_;
  std::map<std::uint64_t, Command> asked_;               ///< commands without an answer yet
  std::map<std::uint64_t, Command> begun_;               ///< whose tape goes on after the answer of that number
  std::map<std::uint64_t, v1::InstructorAnswer> parts_;  ///< answers of which more is to come
  std::optional<std::pair<Command, BulkFile>> content_;  ///< being received
  Screen screen_;
  std::uint64_t beat_ = 0, state_ = 0;  ///< what the user has seen (AUTH-008)
  std::uint64_t keys_ = 0;              ///< key events of this connection
  std::uint64_t number_ = 0;
  std::uint64_t status_number_ = 0;  ///< of the status that has not been answered yet, 0 none
  Clock::time_point last_heard_{};
  bool has_ended_ = false;
};

}  // namespace cnclab::instructor
