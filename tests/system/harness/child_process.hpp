// One program started by a test: its standard streams, its end, and the promise that it does not outlive the test.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/deadline.hpp"

namespace cnclab::harness {

/// The folder with the programs under test: build/bin, or what the environment variable CNCLAB_PROGRAMS names.
[[nodiscard]] std::filesystem::path programs_folder();

struct Launch {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>> environment;  ///< added to the test's own
  std::filesystem::path stderr_file;                             ///< empty: the test's own stderr
};

/// A running program with pipes on stdin and stdout. The destructor ends it (SIGTERM, after 2 s SIGKILL) and it also
/// ends with the test program itself; start it in a thread that lives as long as it does.
class ChildProcess {
 public:
  explicit ChildProcess(const Launch& launch);
  ChildProcess(ChildProcess&&) noexcept;
  ChildProcess& operator=(ChildProcess&&) noexcept;
  ~ChildProcess();

  [[nodiscard]] pid_t pid() const;
  /// Writes all of it; false when the program no longer reads.
  [[nodiscard]] bool write(std::string_view text);
  void close_input();
  /// The next line of its output without the newline; nothing at its end or when the limit has passed.
  [[nodiscard]] std::optional<std::string> read_line(const Deadline& deadline);
  /// Everything that is left to read until the output ends.
  [[nodiscard]] std::string read_rest(const Deadline& deadline);

  void send_signal(int signal);
  /// The exit code, 128 + signal where a signal ended it, nothing while it still runs at the limit.
  [[nodiscard]] std::optional<int> wait(Milliseconds limit);
  [[nodiscard]] bool is_running() { return !wait(0ms).has_value(); }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Waits for the end of a process of ours; as ChildProcess::wait.
[[nodiscard]] std::optional<int> wait_for_exit(pid_t pid, Milliseconds limit);

/// argv or envp for exec, built before the fork; the strings must outlive it.
[[nodiscard]] std::vector<char*> pointers_to(std::vector<std::string>& strings);
[[nodiscard]] std::vector<std::string> environment_with(const std::vector<std::pair<std::string, std::string>>& added);

}  // namespace cnclab::harness
