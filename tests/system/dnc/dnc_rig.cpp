// Sockets, pseudo-terminals and programs at the other end of a serial line.
#include "dnc/dnc_rig.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <regex>

#include "harness/failure.hpp"

namespace cnclab::harness {

std::uint16_t dnc_port(const Classroom& room) {
  const std::string log = read_file(room.folder().path() / "server.log");
  std::smatch found;
  if (!std::regex_search(log, found, std::regex("dnc: listening [^ ]*:([0-9]+)")))
    throw Failure("the log names no port of the serial line:\n" + log);
  return static_cast<std::uint16_t>(std::stoi(found[1]));
}

std::string binding_on(StationProcess& station) {
  station.key("MENU EXTERNE_DATEN");
  const std::string screen = station.text();
  std::smatch found;
  if (!std::regex_search(screen, found, std::regex("STATION [0-9]+ [A-Z0-9-]+")))
    throw Failure("no STATION line on the screen:\n" + screen);
  return found[0];
}

LineEnd::~LineEnd() { close(descriptor_); }

void LineEnd::say(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
    if (written <= 0) throw Failure("the line takes no bytes");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string LineEnd::hear(std::size_t count, Milliseconds limit) const {
  const Deadline deadline(limit);
  std::string bytes;
  while (bytes.size() < count) {
    pollfd question{.fd = descriptor_, .events = POLLIN, .revents = 0};
    if (poll(&question, 1, deadline.remaining_ms()) <= 0) break;
    std::string more(count - bytes.size(), '\0');
    const ssize_t got = read(descriptor_, more.data(), more.size());
    if (got <= 0) break;
    bytes += more.substr(0, static_cast<std::size_t>(got));
  }
  return bytes;
}

bool LineEnd::is_silent_for(Milliseconds time) const {
  pollfd question{.fd = descriptor_, .events = POLLIN, .revents = 0};
  return poll(&question, 1, static_cast<int>(time.count())) == 0;
}

bool LineEnd::is_closed_within(Milliseconds limit) const {
  const Deadline deadline(limit);
  char byte = 0;
  pollfd question{.fd = descriptor_, .events = POLLIN, .revents = 0};
  while (poll(&question, 1, deadline.remaining_ms()) > 0)
    if (read(descriptor_, &byte, 1) <= 0) return true;
  return false;
}

int connect_to(std::uint16_t port) {
  const int descriptor = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    throw Failure("no connection to port " + std::to_string(port));
  return descriptor;
}

int open_pseudo_terminal(std::string& path) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) throw Failure("no pseudo-terminal");
  termios raw{};
  tcgetattr(master, &raw);
  cfmakeraw(&raw);
  tcsetattr(master, TCSANOW, &raw);
  path = ptsname(master);
  return master;
}

ChildProcess start_socat(const std::string& one, const std::string& other, const std::filesystem::path& link) {
  ChildProcess socat(
      {.program = "/usr/bin/env", .arguments = {"socat", one, other}, .environment = {}, .stderr_file = {}});
  if (!eventually(kLimit, [&] { return std::filesystem::exists(link); }))
    throw Failure("socat made no " + link.string());
  return socat;
}

SenderResult run_sender(const std::vector<std::string>& arguments, const TemporaryFolder& folder) {
  std::vector<std::string> all{"python3", CNCLAB_DNC_SENDER};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const auto errors = folder.path() / "sender.log";
  ChildProcess sender({.program = "/usr/bin/env", .arguments = all, .environment = {}, .stderr_file = errors});
  const Deadline deadline(60s);
  SenderResult result;
  while (auto line = sender.read_line(deadline)) result.lines.push_back(std::move(*line));
  result.exit_code = sender.wait(5s).value_or(-1);
  result.errors = read_file(errors);
  return result;
}

}  // namespace cnclab::harness
