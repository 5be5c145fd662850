// The lab's server as a real process: started, asked for its address, ended in every way a server can end.
#include "harness/server_process.hpp"

#include <charconv>
#include <csignal>
#include <fstream>
#include <sstream>

#include "harness/temporary_folder.hpp"

namespace cnclab::harness {
namespace {

constexpr auto kStartLimit = 15s;

std::vector<std::string> arguments_of(const ServerOptions& options) {
  std::vector<std::string> arguments;
  if (!options.configuration.empty()) {
    const auto file = options.data.parent_path() / "lab.toml";
    std::ofstream(file) << options.configuration;
    arguments.insert(arguments.end(), {"--config", file.string()});
  }
  arguments.insert(arguments.end(), {"--listen", "127.0.0.1:" + std::to_string(options.port)});
  arguments.insert(arguments.end(), {"--data", options.data.string()});
  arguments.insert(arguments.end(), options.more.begin(), options.more.end());
  return arguments;
}

}  // namespace

ServerProcess::ServerProcess(ChildProcess process, std::filesystem::path log)
    : process_(std::move(process)), log_file_(std::move(log)) {}

std::expected<ServerProcess, StartFailure> ServerProcess::start(const ServerOptions& options) {
  const auto log = options.log.empty() ? options.data.parent_path() / "server.log" : options.log;
  ServerProcess server(ChildProcess({.program = programs_folder() / "cnclab-server",
                                     .arguments = arguments_of(options),
                                     .environment = {},
                                     .stderr_file = log}),
                       log);
  const Deadline deadline(kStartLimit);
  while (const auto line = server.process_.read_line(deadline)) {
    if (server.take(*line)) return server;
  }
  constexpr auto kTimeToEnd = 2s;
  return std::unexpected(StartFailure{.exit_code = server.wait(kTimeToEnd), .log = server.log()});
}

bool ServerProcess::take(const std::string& line) {
  std::istringstream words(line);
  std::string first, second, third, fourth;
  words >> first >> second >> third >> fourth;
  if (first == "instructor" && third == "one-time-password") one_time_password_ = fourth;
  if (first != "listening") return false;
  const auto colon = second.rfind(':');
  std::from_chars(second.data() + colon + 1, second.data() + second.size(), port_);
  fingerprint_ = fourth;
  return true;
}

std::string ServerProcess::address() const { return "127.0.0.1:" + std::to_string(port_); }

std::string ServerProcess::log() const { return read_file(log_file_); }

void ServerProcess::terminate() { process_.send_signal(SIGTERM); }

void ServerProcess::kill_hard() {
  process_.send_signal(SIGKILL);
  static_cast<void>(process_.wait(kLimit));
}

}  // namespace cnclab::harness
