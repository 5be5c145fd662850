// What stands at the other end of a serial line in tests: a pseudo-terminal, a socket, socat, and a sender in Python.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "harness/child_process.hpp"
#include "harness/classroom.hpp"

namespace cnclab::harness {

/// The port that the server's log names for [dnc] listen.
[[nodiscard]] std::uint16_t dnc_port(const Classroom& room);
/// "STATION 1 XXXX-XXXX-XXXX" as the screen EXTERNE DATEN shows it; the station is left there.
[[nodiscard]] std::string binding_on(StationProcess& station);

/// One end of a line as a file descriptor. Bytes in, bytes out, with limits.
class LineEnd {
 public:
  explicit LineEnd(int descriptor) : descriptor_(descriptor) {}
  ~LineEnd();
  LineEnd(const LineEnd&) = delete;
  LineEnd& operator=(const LineEnd&) = delete;

  void say(std::string_view bytes) const;
  /// Waits for exactly so many bytes; fewer when they do not come within the limit.
  [[nodiscard]] std::string hear(std::size_t count, Milliseconds limit = 5s) const;
  /// Nothing comes for so long.
  [[nodiscard]] bool is_silent_for(Milliseconds time) const;
  /// The other end closes within the limit; what comes before is dropped.
  [[nodiscard]] bool is_closed_within(Milliseconds limit) const;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// A plain connection to a loopback port.
[[nodiscard]] int connect_to(std::uint16_t port);

/// The master of a new pseudo-terminal; `path` gets the name of its slave, which a server opens as its device.
[[nodiscard]] int open_pseudo_terminal(std::string& path);

/// socat between two addresses; throws Failure unless `link` is there in time.
[[nodiscard]] ChildProcess start_socat(const std::string& one, const std::string& other,
                                       const std::filesystem::path& link);

/// What tests/system/dnc/dnc_sender.py has printed, one line for each command.
struct SenderResult {
  int exit_code = -1;
  std::vector<std::string> lines;
  std::string errors;
};
[[nodiscard]] SenderResult run_sender(const std::vector<std::string>& arguments, const TemporaryFolder& folder);

}  // namespace cnclab::harness
