// The station at work on a terminal: the server's screen, the keyboard below it, keys and clicks to the session.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <chrono>
#include <optional>
#include <vector>

#include "station/keyboard_view.hpp"
#include "station/password_form.hpp"
#include "station/session.hpp"
#include "station/terminal.hpp"
#include "station/terminal_events.hpp"

namespace cnclab::station {

/// The window is large enough for the monitor; otherwise says on it what is needed.
[[nodiscard]] bool has_room(Terminal& terminal, Language language);

class Monitor {
 public:
  using Clock = Broadcast::Clock;
  Monitor(Terminal& terminal, TerminalEvents& events, Broadcast& changed, Session& session);

  /// Draws and obeys until the user ends while the line is lost; otherwise the session ends first.
  /// Pauses while `is_form_open` says that the login form has the terminal.
  [[nodiscard]] boost::asio::awaitable<void> run(const bool& is_form_open);

 private:
  enum class View : std::uint8_t { monitor, help, log_out_question, new_password };
  struct Release {
    Clock::time_point due;
    std::vector<Key> keys;
  };
  void handle(const Input& input);
  void handle(const Stray& stray);
  void handle(const Click& click);
  void handle_in_help(const Input& input);
  void handle_question(const Input& input);
  void handle_password(const Input& input);
  void follow_password();
  void act(const Binding& binding, bool is_repeat);
  void press(const Press& press, bool is_repeat);
  void press_latched(bool is_repeat);
  void let_go();
  void press_urgent(const Input& input);
  void turn(int percent);
  bool is_repeat(const Input& input);
  void release_due();
  void sound();
  void draw();
  void draw_keyboard();
  [[nodiscard]] Screen shown() const;
  [[nodiscard]] Clock::time_point next_deadline() const;

  Terminal& terminal_;
  TerminalEvents& events_;
  Broadcast& changed_;
  Session& session_;
  View view_ = View::monitor;
  std::size_t help_start_ = 0;
  PasswordForm password_;
  std::vector<Release> releases_;
  bool is_enter_held_ = false;  ///< → in EXTERNE DATEN, from one press to the next
  const Binding* lit_ = nullptr;
  Clock::time_point lit_until_{}, next_tone_{}, last_input_time_{};
  std::optional<Input> last_input_;
  struct Turned {
    std::uint64_t number;
    int percent;
  };
  std::optional<Turned> turned_;
  bool has_ended_ = false;
};

}  // namespace cnclab::station
