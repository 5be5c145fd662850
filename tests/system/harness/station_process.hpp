// A student's station without a terminal: the line protocol of `cnclab-station --headless` over pipes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/child_process.hpp"

namespace cnclab::harness {

struct StationOptions {
  std::string server;       ///< HOST:PORT
  std::string fingerprint;  ///< empty: the known-hosts file judges
  int station = 0;          ///< 0: the option is left out
  std::string user;
  std::filesystem::path password_file;
  std::filesystem::path new_password_file;  ///< answers a forced change
  std::filesystem::path state_folder;       ///< XDG_STATE_HOME and XDG_DATA_HOME of the process
  std::filesystem::path log;                ///< its stderr; empty: the test's own
  std::vector<std::string> more;            ///< further arguments, e.g. --take-over
};

/// 24 lines of 80 columns, UTF-8.
using ScreenRows = std::vector<std::string>;

/// The arguments for `options`, without --headless: the same for a station in a terminal.
[[nodiscard]] std::vector<std::string> station_arguments(const StationOptions& options);

class StationProcess {
 public:
  explicit StationProcess(const StationOptions& options);

  /// One command, one reply line ("ok", "timeout", "error …"); nothing when the station has ended or said nothing
  /// within the limit.
  [[nodiscard]] std::optional<std::string> send(const std::string& command, Milliseconds limit = 15s);
  /// As `send`, but anything except "ok" throws Failure with the screen.
  void expect_ok(const std::string& command, Milliseconds limit = 15s);
  /// `key` with one or several names; throws unless the server has handled them.
  void key(const std::string& names) { expect_ok("key " + names); }
  /// As `key`, without waiting for the reply: what came of it shows only elsewhere (a server that is killed now).
  void press(const std::string& names);
  /// The reply that `press` did not wait for; nothing when it has not come within the limit.
  [[nodiscard]] std::optional<std::string> reply(Milliseconds limit) { return process_.read_line(Deadline(limit)); }
  void type(const std::string& text) { expect_ok("type " + text); }

  /// The screen now; throws when the station answers otherwise (offline).
  [[nodiscard]] ScreenRows screen();
  /// The screen as one text, for messages and searches.
  [[nodiscard]] std::string text();
  /// The inverse cells as "ROW COL LENGTH".
  [[nodiscard]] std::vector<std::string> marks();
  /// Waits until `text` stands on the screen; throws Failure with the screen when it does not come.
  void wait_for(const std::string& text, Milliseconds limit = 8s);
  void wait_gone(const std::string& text, Milliseconds limit = 8s);
  [[nodiscard]] bool shows(const std::string& text) { return this->text().find(text) != std::string::npos; }

  void quit();  ///< logs out; throws unless it ends with 0
  void kill_hard();
  void send_signal(int signal) { process_.send_signal(signal); }
  [[nodiscard]] std::optional<int> wait(Milliseconds limit) { return process_.wait(limit); }
  [[nodiscard]] bool is_running() { return process_.is_running(); }
  [[nodiscard]] pid_t pid() const { return process_.pid(); }

 private:
  [[nodiscard]] std::vector<std::string> lines_until_end(const std::string& command);

  std::string name_;  ///< for messages
  ChildProcess process_;
};

}  // namespace cnclab::harness
