// Names and passwords: from files, or asked for on the terminal.
#include "instructor/prompts.hpp"

#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <memory>

#include "station/client.hpp"
#include "station/utf8.hpp"

namespace cnclab::instructor {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Terminal = std::unique_ptr<std::FILE, CloseFile>;

/// Switches the echo off while it lives.
class Silence {
 public:
  explicit Silence(int terminal) : terminal_(terminal) {
    if (tcgetattr(terminal_, &before_) != 0) return;
    termios silent = before_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    is_on_ = tcsetattr(terminal_, TCSADRAIN, &silent) == 0;
  }
  ~Silence() {
    if (is_on_) tcsetattr(terminal_, TCSADRAIN, &before_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int terminal_;
  termios before_{};
  bool is_on_ = false;
};

std::optional<std::string> read_line(std::FILE* terminal) {
  std::string line;
  for (int c = std::fgetc(terminal); c != '\n'; c = std::fgetc(terminal)) {
    if (c == EOF) return std::nullopt;
    line += static_cast<char>(c);
  }
  return line;
}

void write(std::FILE* terminal, const std::string& text) {
  std::fputs(text.c_str(), terminal);
  std::fflush(terminal);
}

}  // namespace

std::expected<std::string, Failure> password_in(const std::filesystem::path& file) {
  constexpr int kUsage = static_cast<int>(station::ExitCode::usage);
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  if (line.ends_with('\r')) line.pop_back();
  if (line.empty()) {
    return std::unexpected(Failure{kUsage, file.string() + own_words({": kein Passwort in der ersten Zeile",
                                                                      ": no password in the first line of the file"})});
  }
  if (station::line_not_utf8(line)) {
    return std::unexpected(Failure{kUsage, file.string() + ":1: " + own_words(station::kNotUtf8)});
  }
  return line;
}

std::optional<std::string> ask(const std::string& question) {
  const Terminal terminal(std::fopen("/dev/tty", "r+e"));
  if (!terminal) return std::nullopt;
  write(terminal.get(), question);
  std::fseek(terminal.get(), 0, SEEK_CUR);  // from writing to reading, as the C library demands
  return read_line(terminal.get());
}

std::optional<std::string> ask_secret(const std::string& question) {
  const Terminal terminal(std::fopen("/dev/tty", "r+e"));
  if (!terminal) return std::nullopt;
  const Silence silence(fileno(terminal.get()));
  write(terminal.get(), question);
  std::fseek(terminal.get(), 0, SEEK_CUR);
  auto secret = read_line(terminal.get());
  std::fseek(terminal.get(), 0, SEEK_CUR);
  write(terminal.get(), "\n");
  if (!secret || !station::line_not_utf8(*secret)) return secret;
  write(terminal.get(), own_words(station::kNotUtf8Typed) + "\n");
  return std::nullopt;
}

std::optional<std::string> ask_new_password() {
  for (;;) {
    auto first = ask_secret("Neues Passwort (mindestens 8 Zeichen) / new password: ");
    if (!first || first->empty()) return std::nullopt;
    const auto second = ask_secret("Noch einmal / again: ");
    if (!second) return std::nullopt;
    if (first == second) return first;
    const Terminal terminal(std::fopen("/dev/tty", "r+e"));
    if (!terminal) return std::nullopt;
    write(terminal.get(), "Die beiden sind verschieden / they differ.\n");
  }
}

}  // namespace cnclab::instructor
