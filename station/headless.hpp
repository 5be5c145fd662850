// The station without a terminal: commands on stdin, one reply each on stdout (interfaces.md section 3).
#pragma once

#include <boost/asio/awaitable.hpp>
#include <functional>
#include <optional>
#include <string>

#include "station/broadcast.hpp"
#include "station/headless_command.hpp"
#include "station/line_reader.hpp"
#include "station/session.hpp"

namespace cnclab::station {

/// What `screen` prints: 24 lines `|` + 80 columns + `|`, then `end`.
[[nodiscard]] std::string screen_reply(const Screen& screen, bool is_ascii);
/// What `marks` prints: `ROW COL LENGTH` of each stretch of inverse cells, then `end`.
[[nodiscard]] std::string marks_reply(const Screen& screen, bool is_ascii);
/// TEXT stands in one row of the screen.
[[nodiscard]] bool contains(const Screen& screen, const std::string& text);

class Headless {
 public:
  /// Writes a reply, newline included, and flushes; false when nobody reads any more.
  using Output = std::function<bool(const std::string&)>;

  /// Old and new password, with which a wish for a new one is answered (key LABOR); nothing: it is passed over.
  struct PasswordChange {
    std::string old_password, new_password;
  };

  Headless(Session& session, Broadcast& changed, bool is_ascii, Output output,
           std::optional<PasswordChange> change = std::nullopt)
      : session_(session),
        changed_(changed),
        is_ascii_(is_ascii),
        output_(std::move(output)),
        change_(std::move(change)) {}

  /// Converses with `lines` until `quit`, the end of the input or the end of the session.
  [[nodiscard]] boost::asio::awaitable<Ending> run(LineReader& lines);

 private:
  boost::asio::awaitable<void> obey_all(LineReader& lines);
  boost::asio::awaitable<void> answer_password_questions();
  boost::asio::awaitable<std::string> reply_to(HeadlessCommand command);
  boost::asio::awaitable<std::string> press(std::vector<Chord> chords);
  boost::asio::awaitable<std::string> hold(HoldCommand command);
  boost::asio::awaitable<std::string> turn(std::uint32_t percent);
  boost::asio::awaitable<std::string> wait_for(WaitCommand command);
  boost::asio::awaitable<std::string> handled(std::optional<std::uint64_t> number);
  [[nodiscard]] std::string refusal() const;

  Session& session_;
  Broadcast& changed_;
  bool is_ascii_;
  Output output_;
  std::optional<PasswordChange> change_;
  bool owes_reply_ = false;
};

}  // namespace cnclab::station
