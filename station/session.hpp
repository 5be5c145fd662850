// A login that lasts: keys out, screens in, signs of life, and coming back after a cut line (SEAT-004, SEAT-005).
#pragma once

#include <algorithm>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>

#include "shared/key.hpp"
#include "shared/screen.hpp"
#include "station/broadcast.hpp"
#include "station/login.hpp"
#include "station/media_drive.hpp"

namespace cnclab::v1 {
class ClientMessage;
class ScreenUpdate;
class ServerMessage;
class Seen;
}  // namespace cnclab::v1

namespace cnclab::station {

/// Times of the conversation; tests shorten them.
struct Pace {
  std::chrono::milliseconds alive{1000};          ///< a sign of life at latest after this
  std::chrono::milliseconds silence{5000};        ///< a server silent for longer counts as lost
  std::chrono::milliseconds first_pause{200};     ///< before the first attempt to come back; doubles …
  std::chrono::milliseconds longest_pause{5000};  ///< … up to this
  std::chrono::milliseconds farewell{2000};       ///< how long a Logout may take
};

/// The station's side of one login. Holds at all times: what it shows was confirmed by a living connection, keys are
/// accepted only then, and a key that was not handled before a cut is never sent again. One thread.
class Session {
 public:
  using Clock = std::chrono::steady_clock;
  /// Logs in anew where the ticket has become void.
  using Relogin = std::function<boost::asio::awaitable<std::expected<LoggedIn, Ending>>(v1::LoginAnswer)>;

  /// `changed` is notified whenever anything below has changed.
  Session(Door door, LoggedIn login, Broadcast& changed, Relogin relogin, Pace pace = {});
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  /// Converses until the server says Bye, the user has logged out or coming back is refused.
  [[nodiscard]] boost::asio::awaitable<Ending> run();

  /// A screen of this connection is shown and keys are accepted.
  [[nodiscard]] bool is_online() const { return is_online_; }
  /// No connection, since `lost_since`.
  [[nodiscard]] bool is_lost() const { return !is_connected_; }
  [[nodiscard]] Clock::time_point lost_since() const { return lost_since_; }
  [[nodiscard]] const Screen& screen() const { return screen_; }
  [[nodiscard]] std::uint64_t handled_key() const { return handled_key_; }
  /// Inputs on their way to the control or waiting there.
  [[nodiscard]] std::uint64_t unhandled() const { return last_number_ - std::min(last_number_, handled_key_); }
  /// Counts the connections, so that a waiter sees that the line was cut in between.
  [[nodiscard]] std::uint64_t connection() const { return connection_; }
  /// A login without a ticket only looks on (SEAT-003, SEAT-006).
  [[nodiscard]] bool may_press() const { return !ticket_.empty(); }
  /// 1..15: where the user sits, or what is looked at.
  [[nodiscard]] std::uint32_t station() const { return station_; }
  [[nodiscard]] Language language() const { return language_; }
  [[nodiscard]] bool has_alarm_tone() const { return has_alarm_tone_; }
  /// Short tones since the last call.
  [[nodiscard]] std::uint32_t take_beeps();
  /// The user has chosen a new password in the lab's menu: ask for it, then `change_password`. True once.
  [[nodiscard]] bool take_password_question();
  /// The server's answer to `change_password`, once.
  [[nodiscard]] std::optional<v1::LoginAnswer> take_password_answer();
  /// A password was changed within this session: the one it began with holds no more.
  [[nodiscard]] bool has_new_password() const { return has_new_password_; }
  /// Why the last attempt to come back failed; empty at first.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

  /// Keys going down or up together, 1..3. returns the event's number, nothing while the line is lost or for observers.
  std::optional<std::uint64_t> send_keys(std::span<const Key> keys, bool pressed, bool is_repeat = false);
  /// The potentiometer at 0..100 %.
  std::optional<std::uint64_t> send_potentiometer(std::uint32_t percent);
  void change_password(const std::string& old_password, const std::string& new_password);
  /// Asks the server to end; `run` returns soon after.
  void log_out();

 private:
  boost::asio::awaitable<std::optional<Ending>> converse();
  boost::asio::awaitable<std::optional<Ending>> read_all();
  boost::asio::awaitable<void> write_all();
  boost::asio::awaitable<void> keep_alive();
  boost::asio::awaitable<std::optional<Ending>> come_back();
  boost::asio::awaitable<std::optional<Ending>> come_back_once();
  boost::asio::awaitable<std::optional<Ending>> log_in_anew(v1::LoginAnswer why);
  void begin(LoggedIn login);
  void apply(const v1::ScreenUpdate& update);
  void take(const v1::ServerMessage& message);
  void take_answer(const v1::LoginAnswer& answer);
  void lose();
  void take_media(const v1::ServerMessage& message);
  void queue(v1::ClientMessage message);
  void queue_alive();
  void fill_seen(v1::Seen& seen) const;

  Door door_;
  Client client_;
  Broadcast& changed_;
  Relogin relogin_;
  Pace pace_;
  std::string ticket_, trouble_;
  Language language_ = Language::german;
  std::uint32_t station_ = 0;
  Screen screen_;
  bool is_connected_ = true, is_online_ = false, has_alarm_tone_ = false, is_logging_out_ = false;
  bool is_password_wanted_ = false, has_new_password_ = false;
  std::optional<v1::LoginAnswer> password_answer_;
  std::uint64_t last_number_ = 0, handled_key_ = 0, last_beat_ = 0, state_ = 0, connection_ = 1;
  std::uint32_t beeps_ = 0;
  Clock::time_point lost_since_{}, last_received_{}, last_alive_{}, log_out_limit_{};
  std::optional<MediaDrive> media_;
  std::deque<v1::ClientMessage> outgoing_;
  Broadcast to_write_;
};

}  // namespace cnclab::station
