// The server's data folder: database opened, certificate and first instructor made, values read for the lab.
#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

#include "db/database.hpp"
#include "lab/lab.hpp"
#include "shared/tls.hpp"

namespace cnclab {

struct DataFolder {
  db::Database database;
  Certificate certificate;
  lab::Inheritance inheritance;
  /// Set when there was nobody on the roster: the password of "lehrer", to be changed at the first login.
  std::optional<std::string> first_password;
};

/// errors: what is wrong with the folder or the database, and what to do
[[nodiscard]] std::expected<DataFolder, std::string> open_data_folder(const std::filesystem::path& folder);

/// Gives the instructor "lehrer" a new one-time password; the server must be stopped.
[[nodiscard]] std::expected<std::string, std::string> renew_instructor_password(const std::filesystem::path& folder);

/// Puts a backup in the place of the database; what it replaces is kept aside (STO-008).
[[nodiscard]] std::expected<std::string, std::string> restore_backup(const std::filesystem::path& folder,
                                                                     const std::filesystem::path& backup);

}  // namespace cnclab
