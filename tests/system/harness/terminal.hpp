// A real terminal for a program: a pseudo-terminal of a given size and libvterm, which shows what a user would see.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/deadline.hpp"

namespace cnclab::harness {

inline constexpr int kScreenRows = 24, kScreenColumns = 80;  ///< the smallest window that a station takes (DEC-01)

struct TerminalOptions {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>> environment;
  int rows = kScreenRows;
  int columns = kScreenColumns;
};

/// The program ends with the Terminal. One thread.
class Terminal {
 public:
  explicit Terminal(const TerminalOptions& options);
  Terminal(Terminal&&) noexcept;
  Terminal& operator=(Terminal&&) noexcept;
  ~Terminal();

  /// Bytes as a keyboard sends them, e.g. "q", "\r", "\x1b[A".
  void type(std::string_view bytes);
  /// Left button down and up at a cell (0-based), as the program asked to be told about it.
  void click(int row, int column);
  void resize(int rows, int columns);

  /// Takes in what the program has written so far.
  void update();
  /// One row as UTF-8, blanks at its end included.
  [[nodiscard]] std::string row(int index);
  /// All rows, each ended by a newline.
  [[nodiscard]] std::string text();
  /// Row and column (in cells) where `text` stands; nothing where it does not.
  [[nodiscard]] std::optional<std::pair<int, int>> find(const std::string& text);
  /// As `find`, from a row downwards.
  [[nodiscard]] std::optional<std::pair<int, int>> find_below(const std::string& text, int first_row);
  [[nodiscard]] bool is_inverse(int row, int column);

  /// Waits until `text` stands somewhere; throws Failure with the screen when it does not come.
  void wait_for(const std::string& text, Milliseconds limit = 8s);
  void wait_gone(const std::string& text, Milliseconds limit = 8s);
  [[nodiscard]] std::optional<int> wait(Milliseconds limit);  ///< exit code, as ChildProcess::wait
  void send_signal(int signal);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::harness
