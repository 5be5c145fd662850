// The instructor's one-shot commands, run as processes, with their JSON already read.
#include "harness/instructor.hpp"

#include <algorithm>
#include <sstream>

#include "harness/child_process.hpp"
#include "harness/failure.hpp"
#include "harness/temporary_folder.hpp"

namespace cnclab::harness {
namespace {

std::vector<nlohmann::json> objects_of(const std::string& output) {
  std::vector<nlohmann::json> objects;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    auto object = nlohmann::json::parse(line, nullptr, false);
    if (object.is_object()) objects.push_back(std::move(object));
  }
  return objects;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

OneShot Instructor::run(const std::vector<std::string>& arguments, Milliseconds limit) const {
  const TemporaryFolder folder;
  std::vector<std::string> all{"--server", options_.server, "--user", options_.user};
  const auto add = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) all.insert(all.end(), {option, value});
  };
  add("--password-file", options_.password_file.string());
  add("--new-password-file", options_.new_password_file.string());
  add("--fingerprint", options_.fingerprint);
  all.insert(all.end(), arguments.begin(), arguments.end());
  Launch launch{.program = programs_folder() / "cnclab-instructor",
                .arguments = all,
                .environment = {},
                .stderr_file = folder.path() / "errors"};
  if (!options_.state_folder.empty()) launch.environment.emplace_back("XDG_STATE_HOME", options_.state_folder.string());
  const Deadline deadline(limit);
  ChildProcess process(launch);
  process.close_input();
  OneShot result;
  result.output = process.read_rest(deadline);
  result.exit_code = process.wait(Milliseconds(deadline.remaining_ms())).value_or(-1);
  result.objects = objects_of(result.output);
  result.errors = read_file(folder.path() / "errors");
  return result;
}

OneShot Instructor::must(const std::vector<std::string>& arguments, Milliseconds limit) const {
  OneShot result = run(arguments, limit);
  if (result.exit_code != 0) {
    throw Failure("instructor: `" + joined(arguments) + "` ended with " + std::to_string(result.exit_code) + ": " +
                  result.errors);
  }
  return result;
}

nlohmann::json Instructor::status() const {
  const OneShot result = must({"status"});
  if (result.objects.size() != 1) throw Failure("instructor: `status` printed " + result.output);
  return result.objects.front();
}

nlohmann::json Instructor::station(int number) const {
  const auto status_now = status();
  const auto& stations = status_now.at("stations");
  const auto found = std::ranges::find_if(stations, [&](const auto& entry) { return entry.at("station") == number; });
  return found == stations.end() ? nlohmann::json() : *found;
}

}  // namespace cnclab::harness
