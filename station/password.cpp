// Passwords from a file, or from the terminal without echo.
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <fstream>

#include "shared/credential_limits.hpp"
#include "station/options.hpp"
#include "station/utf8.hpp"

namespace cnclab::station {
namespace {

std::unexpected<Ending> refused(const Text& text, const std::string& what) {
  return std::unexpected(Ending{ExitCode::usage, what + ": " + std::string(text.in(language_of_locale()))});
}

// The controlling terminal with echo off; both are put back at the end of the scope.
class QuietTerminal {
 public:
  QuietTerminal() : descriptor_(::open("/dev/tty", O_RDWR | O_CLOEXEC)) {
    if (descriptor_ < 0 || ::tcgetattr(descriptor_, &before_) != 0) return;
    termios quiet = before_;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    is_quiet_ = ::tcsetattr(descriptor_, TCSAFLUSH, &quiet) == 0;
  }
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;
  ~QuietTerminal() {
    if (is_quiet_) ::tcsetattr(descriptor_, TCSAFLUSH, &before_);
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] bool is_quiet() const { return is_quiet_; }

  void say(const std::string& text) const {
    [[maybe_unused]] const ssize_t w = ::write(descriptor_, text.data(), text.size());
  }

  // Nothing when the user ends it (Ctrl-C, Ctrl-D).
  [[nodiscard]] std::optional<std::string> line() const {
    std::string text;
    for (char next = 0;;) {
      if (::read(descriptor_, &next, 1) != 1) return std::nullopt;
      if (next == '\n') return text;
      if (text.size() < kLongestPassword) text += next;
    }
  }

 private:
  int descriptor_;
  bool is_quiet_ = false;
  termios before_{};
};

}  // namespace

std::expected<std::string, Ending> read_password(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string password;
  if (!stream) {
    return refused({"Passwortdatei nicht lesbar. Gibt es sie, und darf man sie lesen?",
                    "cannot read the password file. Does it exist, and may it be read?"},
                   file.string());
  }
  std::getline(stream, password);
  if (password.ends_with('\r')) password.pop_back();
  if (password.empty() || password.size() > kLongestPassword) {
    return refused({"die erste Zeile muss das Passwort sein, 1 bis 256 Bytes",
                    "the first line must be the password, 1 to 256 bytes"},
                   file.string());
  }
  if (line_not_utf8(password)) return refused(kNotUtf8, file.string() + ":1");
  return password;
}

std::expected<std::string, Ending> ask_password(const std::string& prompt) {
  const QuietTerminal terminal;
  if (!terminal.is_quiet()) {
    return refused(
        {"kein Terminal für die Eingabe. --password-file angeben.", "no terminal to ask on. Give --password-file."},
        prompt);
  }
  terminal.say(prompt + ": ");
  auto password = terminal.line();
  terminal.say("\n");
  if (!password) return std::unexpected(Ending{ExitCode::ended_by_user, ""});
  if (line_not_utf8(*password)) return refused(kNotUtf8Typed, prompt);
  return std::move(*password);
}

}  // namespace cnclab::station
