// A real terminal for a program: a pseudo-terminal of a given size and libvterm, which shows what a user would see.
#include "harness/terminal.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vterm.h>

#include <array>
#include <csignal>
#include <cstdint>

#include "harness/child_process.hpp"
#include "harness/failure.hpp"
#include "shared/screen.hpp"

namespace cnclab::harness {
namespace {

struct FreeTerminal {
  void operator()(VTerm* terminal) const { vterm_free(terminal); }
};

winsize size_of(int rows, int columns) {
  return {.ws_row = static_cast<unsigned short>(rows),
          .ws_col = static_cast<unsigned short>(columns),
          .ws_xpixel = 0,
          .ws_ypixel = 0};
}

/// Only calls that are allowed between fork and exec in a program with threads.
[[noreturn]] void become(const char* program, char** argv, char** envp) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  execve(program, argv, envp);
  constexpr int kNotFound = 127;
  _exit(kNotFound);
}

}  // namespace

struct Terminal::Impl {
  std::unique_ptr<VTerm, FreeTerminal> vterm;
  VTermScreen* screen = nullptr;
  int rows = 0, columns = 0;
  int master = -1;
  pid_t pid = -1;
  std::optional<int> exit_code;

  Impl(int row_count, int column_count)
      : vterm(vterm_new(row_count, column_count)), rows(row_count), columns(column_count) {
    vterm_set_utf8(vterm.get(), 1);
    screen = vterm_obtain_screen(vterm.get());
    vterm_screen_enable_altscreen(screen, 1);
    vterm_screen_reset(screen, 1);
    vterm_output_set_callback(
        vterm.get(),
        [](const char* bytes, std::size_t length, void* self) { static_cast<Impl*>(self)->send({bytes, length}); },
        this);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    constexpr auto kPatienceAfterTerm = 2s;
    if (pid > 0 && !exit_code) {
      ::kill(pid, SIGTERM);
      if (!wait_reading(kPatienceAfterTerm)) {
        ::kill(pid, SIGKILL);
        int status = 0;
        waitpid(pid, &status, 0);
      }
    }
    if (master >= 0) close(master);
  }

  void send(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto count = write(master, bytes.data(), bytes.size());
      if (count <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  /// Reads once what the program writes within the time; false when nothing came.
  bool fill(int wait_ms) {
    pollfd question{.fd = master, .events = POLLIN, .revents = 0};
    if (poll(&question, 1, wait_ms) <= 0) return false;
    std::array<char, 4096> bytes{};
    const auto count = read(master, bytes.data(), bytes.size());
    if (count <= 0) return false;
    vterm_input_write(vterm.get(), bytes.data(), static_cast<std::size_t>(count));
    return true;
  }

  /// Waits for the program's end and reads meanwhile, since a full terminal would keep it from ending.
  std::optional<int> wait_reading(Milliseconds limit) {
    constexpr int kLook_ms = 20;
    const Deadline deadline(limit);
    while (!exit_code) {
      exit_code = wait_for_exit(pid, 0ms);
      if (exit_code || deadline.has_passed()) break;
      if (!fill(kLook_ms)) exit_code = wait_for_exit(pid, Milliseconds(kLook_ms));
    }
    return exit_code;
  }

  [[nodiscard]] VTermScreenCell cell(int row, int column) const {
    VTermScreenCell result{};
    vterm_screen_get_cell(screen, {.row = row, .col = column}, &result);
    return result;
  }
};

Terminal::Terminal(const TerminalOptions& options) : impl_(std::make_unique<Impl>(options.rows, options.columns)) {
  std::vector<std::string> arguments{options.program.string()};
  arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
  auto added = options.environment;
  added.insert(added.end(), {{"TERM", "xterm-256color"}, {"LANG", "C.UTF-8"}, {"LC_ALL", "C.UTF-8"}});
  std::vector<std::string> environment = environment_with(added);
  auto argv = pointers_to(arguments);
  auto envp = pointers_to(environment);
  const winsize size = size_of(options.rows, options.columns);
  impl_->pid = forkpty(&impl_->master, nullptr, nullptr, &size);
  if (impl_->pid < 0) throw Failure("no pseudo-terminal");
  if (impl_->pid == 0) become(options.program.c_str(), argv.data(), envp.data());
}

Terminal::Terminal(Terminal&&) noexcept = default;

Terminal& Terminal::operator=(Terminal&& other) noexcept {
  std::swap(impl_, other.impl_);  // the former program ends with `other`
  return *this;
}

Terminal::~Terminal() = default;

void Terminal::type(std::string_view bytes) { impl_->send(bytes); }

void Terminal::click(int row, int column) {
  constexpr int kLeft = 1;
  update();
  vterm_mouse_move(impl_->vterm.get(), row, column, VTERM_MOD_NONE);
  vterm_mouse_button(impl_->vterm.get(), kLeft, true, VTERM_MOD_NONE);
  vterm_mouse_button(impl_->vterm.get(), kLeft, false, VTERM_MOD_NONE);
}

void Terminal::resize(int rows, int columns) {
  const winsize size = size_of(rows, columns);
  impl_->rows = rows;
  impl_->columns = columns;
  vterm_set_size(impl_->vterm.get(), rows, columns);
  ioctl(impl_->master, TIOCSWINSZ, &size);
}

void Terminal::update() {
  while (impl_->fill(0)) {
  }
}

std::string Terminal::row(int index) {
  std::string text;
  for (int column = 0; column < impl_->columns; ++column) {
    const auto cell = impl_->cell(index, column);
    if (cell.chars[0] == static_cast<std::uint32_t>(-1)) continue;  // right half of a wide character
    if (cell.chars[0] == 0) text += ' ';
    for (int i = 0; i < VTERM_MAX_CHARS_PER_CELL && cell.chars[i] != 0; ++i) {
      text += to_utf8(static_cast<char32_t>(cell.chars[i]));
    }
  }
  return text;
}

std::string Terminal::text() {
  std::string all;
  for (int index = 0; index < impl_->rows; ++index) all += row(index) + "\n";
  return all;
}

std::optional<std::pair<int, int>> Terminal::find(const std::string& text) { return find_below(text, 0); }

std::optional<std::pair<int, int>> Terminal::find_below(const std::string& text, int first_row) {
  for (int index = first_row; index < impl_->rows; ++index) {
    const std::string line = row(index);
    const auto position = line.find(text);
    if (position != std::string::npos) {
      return std::pair(index, static_cast<int>(from_utf8(line.substr(0, position)).size()));
    }
  }
  return std::nullopt;
}

bool Terminal::is_inverse(int row, int column) { return impl_->cell(row, column).attrs.reverse != 0; }

void Terminal::wait_for(const std::string& text, Milliseconds limit) {
  constexpr int kLook_ms = 20;
  const Deadline deadline(limit);
  while (!find(text)) {
    if (deadline.has_passed()) throw Failure("terminal: `" + text + "` did not appear:\n" + this->text());
    if (!impl_->fill(kLook_ms) && wait(0ms)) {
      throw Failure("terminal: the program ended before `" + text + "` appeared:\n" + this->text());
    }
    update();
  }
}

void Terminal::wait_gone(const std::string& text, Milliseconds limit) {
  constexpr int kLook_ms = 20;
  const Deadline deadline(limit);
  while (find(text)) {
    if (deadline.has_passed()) throw Failure("terminal: `" + text + "` is still there:\n" + this->text());
    impl_->fill(kLook_ms);
    update();
  }
}

std::optional<int> Terminal::wait(Milliseconds limit) { return impl_->wait_reading(limit); }

void Terminal::send_signal(int signal) {
  if (impl_->pid > 0 && !impl_->exit_code) ::kill(impl_->pid, signal);
}

}  // namespace cnclab::harness
