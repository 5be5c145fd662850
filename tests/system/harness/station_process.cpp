// A student's station without a terminal: the line protocol of `cnclab-station --headless` over pipes.
#include "harness/station_process.hpp"

#include <csignal>

#include "harness/failure.hpp"

namespace cnclab::harness {
namespace {

constexpr auto kListLimit = 10s;
constexpr auto kReplyMargin = 5s;  // the station's own limit passes first

Launch launch_of(const StationOptions& options) {
  Launch launch{.program = programs_folder() / "cnclab-station",
                .arguments = station_arguments(options),
                .environment = {},
                .stderr_file = options.log};
  launch.arguments.emplace_back("--headless");
  if (!options.state_folder.empty())
    for (const char* const variable : {"XDG_STATE_HOME", "XDG_DATA_HOME"})
      launch.environment.emplace_back(variable, options.state_folder.string());
  return launch;
}

}  // namespace

std::vector<std::string> station_arguments(const StationOptions& options) {
  std::vector<std::string> arguments{"--server", options.server};
  const auto add = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {option, value});
  };
  add("--station", options.station == 0 ? "" : std::to_string(options.station));
  add("--user", options.user);
  add("--password-file", options.password_file.string());
  add("--new-password-file", options.new_password_file.string());
  add("--fingerprint", options.fingerprint);
  arguments.insert(arguments.end(), options.more.begin(), options.more.end());
  return arguments;
}

StationProcess::StationProcess(const StationOptions& options)
    : name_("station " + std::to_string(options.station) + " (" + options.user + ")"), process_(launch_of(options)) {}

std::optional<std::string> StationProcess::send(const std::string& command, Milliseconds limit) {
  const Deadline deadline(limit);
  if (!process_.write(command + "\n")) return std::nullopt;
  return process_.read_line(deadline);
}

void StationProcess::expect_ok(const std::string& command, Milliseconds limit) {
  const auto reply = send(command, limit);
  if (reply == "ok") return;
  const auto code = process_.wait(0ms);
  const std::string what = reply ? *reply : code ? "end with exit code " + std::to_string(*code) : "nothing";
  throw Failure(name_ + ": `" + command + "` answered: " + what + (reply ? "\n" + text() : ""));
}

void StationProcess::press(const std::string& names) {
  if (!process_.write("key " + names + "\n")) throw Failure(name_ + " has ended");
}

std::vector<std::string> StationProcess::lines_until_end(const std::string& command) {
  const Deadline deadline(kListLimit);
  if (!process_.write(command + "\n")) throw Failure(name_ + " has ended");
  std::vector<std::string> lines;
  while (const auto line = process_.read_line(deadline)) {
    if (*line == "end") return lines;
    if (line->starts_with("error ")) throw Failure(name_ + ": `" + command + "`: " + *line);
    lines.push_back(*line);
  }
  throw Failure(name_ + ": `" + command + "` gave no complete answer");
}

ScreenRows StationProcess::screen() {
  ScreenRows rows = lines_until_end("screen");
  for (auto& row : rows) {
    if (row.size() < 2 || row.front() != '|' || row.back() != '|') throw Failure(name_ + ": screen line: " + row);
    row = row.substr(1, row.size() - 2);
  }
  return rows;
}

std::string StationProcess::text() {
  std::string all;
  for (const auto& row : screen()) all += row + "\n";
  return all;
}

std::vector<std::string> StationProcess::marks() { return lines_until_end("marks"); }

void StationProcess::wait_for(const std::string& text, Milliseconds limit) {
  expect_ok("wait " + std::to_string(limit.count()) + " " + text, limit + kReplyMargin);
}

void StationProcess::wait_gone(const std::string& text, Milliseconds limit) {
  expect_ok("gone " + std::to_string(limit.count()) + " " + text, limit + kReplyMargin);
}

void StationProcess::quit() {
  expect_ok("quit");
  if (process_.wait(kReplyMargin) != 0) throw Failure(name_ + " did not end with 0 after quit");
}

void StationProcess::kill_hard() {
  process_.send_signal(SIGKILL);
  static_cast<void>(process_.wait(kReplyMargin));
}

}  // namespace cnclab::harness
