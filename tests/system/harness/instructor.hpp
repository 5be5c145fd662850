// The instructor's one-shot commands, run as processes, with their JSON already read.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/deadline.hpp"

namespace cnclab::harness {

/// What a one-shot command left behind.
struct OneShot {
  int exit_code = -1;                   ///< -1: it did not end within the limit
  std::vector<nlohmann::json> objects;  ///< one for each line of output that is JSON
  std::string output;
  std::string errors;
};

/// Who asks, and whom.
struct InstructorOptions {
  std::string server;
  std::string fingerprint;
  std::string user = "lehrer";
  std::filesystem::path password_file;
  std::filesystem::path new_password_file;
  std::filesystem::path state_folder;  ///< XDG_STATE_HOME of the processes
};

class Instructor {
 public:
  explicit Instructor(InstructorOptions options) : options_(std::move(options)) {}

  /// Runs `cnclab-instructor … arguments` to its end.
  [[nodiscard]] OneShot run(const std::vector<std::string>& arguments, Milliseconds limit = 20s) const;
  /// As `run`, but throws Failure with its error text unless it exits 0.
  OneShot must(const std::vector<std::string>& arguments, Milliseconds limit = 20s) const;
  /// The object of `status`; throws where there is none.
  [[nodiscard]] nlohmann::json status() const;
  /// The entry of `status` for a station; null where nobody is logged in there.
  [[nodiscard]] nlohmann::json station(int number) const;

  [[nodiscard]] InstructorOptions& options() { return options_; }

 private:
  InstructorOptions options_;
};

}  // namespace cnclab::harness
