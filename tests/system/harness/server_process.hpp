// The lab's server as a real process: started, asked for its address, ended in every way a server can end.
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/child_process.hpp"

namespace cnclab::harness {

struct ServerOptions {
  std::filesystem::path data;
  std::filesystem::path log;      ///< stderr; default: server.log beside the data folder
  std::uint16_t port = 0;         ///< 0: any free one
  std::string configuration;      ///< content of lab.toml, written beside the data folder; empty: none
  std::vector<std::string> more;  ///< further arguments
};

/// A server that ended before it listened.
struct StartFailure {
  std::optional<int> exit_code;  ///< nothing: it neither listened nor ended in time, and was ended
  std::string log;
};

class ServerProcess {
 public:
  /// Starts it and waits until it accepts connections.
  [[nodiscard]] static std::expected<ServerProcess, StartFailure> start(const ServerOptions& options);

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string address() const;                                     ///< "127.0.0.1:PORT"
  [[nodiscard]] const std::string& fingerprint() const { return fingerprint_; }  ///< "SHA256:…"
  /// What the first start with an empty data folder printed.
  [[nodiscard]] const std::optional<std::string>& one_time_password() const { return one_time_password_; }
  [[nodiscard]] std::string log() const;

  void terminate();  ///< SIGTERM
  void kill_hard();  ///< SIGKILL, and waits for its end
  [[nodiscard]] std::optional<int> wait(Milliseconds limit) { return process_.wait(limit); }
  [[nodiscard]] bool is_running() { return process_.is_running(); }
  [[nodiscard]] pid_t pid() const { return process_.pid(); }

 private:
  ServerProcess(ChildProcess process, std::filesystem::path log);
  /// Takes what an output line tells; true when it was the line that ends the start.
  bool take(const std::string& line);

  ChildProcess process_;
  std::filesystem::path log_file_;
  std::uint16_t port_ = 0;
  std::string fingerprint_;
  std::optional<std::string> one_time_password_;
};

}  // namespace cnclab::harness
