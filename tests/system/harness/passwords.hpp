// Random passwords in files of their own, as the programs take them.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "harness/temporary_folder.hpp"

namespace cnclab::harness {

/// One password for each name, made when it is first asked for, kept in a file with mode 0600.
class Passwords {
 public:
  /// The file with the password of `name`.
  [[nodiscard]] std::filesystem::path file_of(const std::string& name);
  [[nodiscard]] std::string password_of(const std::string& name);
  /// Replaces it by one that somebody else made, e.g. the server's one-time password.
  std::filesystem::path set(const std::string& name, const std::string& password);

 private:
  TemporaryFolder folder_;
  std::map<std::string, std::string> passwords_;
};

}  // namespace cnclab::harness
