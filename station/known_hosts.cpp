// Reading, comparing and extending the known-hosts file under a lock.
#include "station/known_hosts.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "station/language.hpp"

namespace cnclab::station {
namespace {

namespace fs = std::filesystem;

// A file descriptor that is closed, and with it unlocked, at the end of its scope.
class LockedFile {
 public:
  explicit LockedFile(const fs::path& path)
      : descriptor_(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;
  ~LockedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

  [[nodiscard]] std::string content() const {
    std::string text;
    std::array<char, 4096> buffer{};
    ::lseek(descriptor_, 0, SEEK_SET);
    for (ssize_t count = 0; (count = ::read(descriptor_, buffer.data(), buffer.size())) > 0;) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

  [[nodiscard]] bool append(const std::string& line) const {
    return ::write(descriptor_, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  }

 private:
  int descriptor_;
};

ConnectError unusable(const fs::path& file, const std::string& reason) {
  return {ExitCode::cannot_connect,
          fmt::format(fmt::runtime(in_language_of_locale(
                          "Das Zertifikat des Servers lässt sich nicht merken: {}: {}. Die Datei zugänglich "
                          "machen oder --fingerprint angeben.",
                          "The server's certificate cannot be remembered: {}: {}. Make the file accessible "
                          "or give --fingerprint.")),
                      file.string(), reason)};
}

ConnectError differs_from_given(const std::string& given, const std::string& shown) {
  return {ExitCode::certificate_differs,
          fmt::format(fmt::runtime(in_language_of_locale(
                          "Das Zertifikat des Servers ist nicht das angegebene: verlangt {}, gezeigt {}. "
                          "Adresse und --fingerprint prüfen.",
                          "The server's certificate is not the given one: wanted {}, shown {}. Check the "
                          "address and --fingerprint.")),
                      given, shown)};
}

ConnectError differs_from_known(const fs::path& file, int line, const std::string& known, const std::string& shown) {
  return {ExitCode::certificate_differs,
          fmt::format(
              fmt::runtime(in_language_of_locale(
                  "Der Server zeigt ein anderes Zertifikat als bisher: bekannt {}, gezeigt {}. Entweder wurde der "
                  "Server neu eingerichtet, oder jemand gibt sich für ihn aus. Erst bei der Lehrkraft nachfragen, dann "
                  "{} Zeile {} löschen.",
                  "The server shows another certificate than before: known {}, shown {}. Either the server was "
                  "set up anew, or somebody poses as it. Ask the instructor first, then delete {} line {}.")),
              known, shown, file.string(), line)};
}

std::string address_text(const Address& address) {
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  return is_ipv6 ? fmt::format("[{}]:{}", address.host, address.port) : address.host + ":" + address.port;
}

struct Remembered {
  std::string fingerprint;
  int line = 0;
};

std::optional<Remembered> find(const std::string& content, const std::string& address) {
  std::istringstream lines(content);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string host, fingerprint;
    if (words >> host >> fingerprint && host == address) return Remembered{fingerprint, number};
  }
  return std::nullopt;
}

std::expected<Acquaintance, ConnectError> judge_by_file(const fs::path& path, const Address& address,
                                                        const std::string& fingerprint) {
  std::error_code ignored;  // a folder that cannot be made shows when the file is opened
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), ignored);
  const LockedFile file(path);
  if (!file.is_open()) return std::unexpected(unusable(path, std::strerror(errno)));
  const std::string name = address_text(address);
  const std::string content = file.content();
  if (const auto known = find(content, name)) {
    if (known->fingerprint == fingerprint) return Acquaintance::known;
    return std::unexpected(differs_from_known(path, known->line, known->fingerprint, fingerprint));
  }
  const std::string break_line = content.empty() || content.ends_with('\n') ? "" : "\n";
  if (!file.append(break_line + name + " " + fingerprint + "\n")) {
    return std::unexpected(unusable(path, std::strerror(errno)));
  }
  return Acquaintance::pinned_now;
}

}  // namespace

fs::path default_known_hosts() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  // A relative path in XDG_STATE_HOME is invalid and ignored (XDG Base Directory Specification).
  if (const fs::path state = variable("XDG_STATE_HOME"); state.is_absolute()) return state / "cnclab" / "known_hosts";
  const fs::path home = variable("HOME");
  return home.empty() ? home : home / ".local" / "state" / "cnclab" / "known_hosts";
}

std::expected<Acquaintance, ConnectError> judge(const Trust& trust, const Address& address,
                                                const std::string& fingerprint) {
  if (trust.fingerprint) {
    if (*trust.fingerprint == fingerprint) return Acquaintance::known;
    return std::unexpected(differs_from_given(*trust.fingerprint, fingerprint));
  }
  const fs::path path = trust.known_hosts.empty() ? default_known_hosts() : trust.known_hosts;
  if (path.empty()) {
    return std::unexpected(unusable("known_hosts", in_language_of_locale("HOME ist nicht gesetzt", "HOME is not set")));
  }
  return judge_by_file(path, address, fingerprint);
}

}  // namespace cnclab::station
