// A data folder for one test, gone afterwards, and small values for it.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <string>
#include <vector>

#include "db/database.hpp"

namespace cnclab::db {

class LabFolder {
 public:
  LabFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cnclab-db-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~LabFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  LabFolder(const LabFolder&) = delete;
  LabFolder& operator=(const LabFolder&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return path_; }
  [[nodiscard]] std::filesystem::path file() const { return path_ / "lab.db"; }

 private:
  std::filesystem::path path_;
};

inline Database opened(const std::filesystem::path& file) {
  auto database = Database::open(file);
  if (!database) throw std::runtime_error(database.error().text);
  return std::move(*database);
}

inline PersonId add_student(Database& database, const std::string& name) {
  return database
      .add_person({.id = {},
                   .name = name,
                   .role = "student",
                   .language = "",
                   .model = "",
                   .password_hash = "hash of " + name,
                   .must_change = false,
                   .last_seen_ms = 0,
                   .archived_ms = std::nullopt},
                  1000)
      .value();
}

inline const Author kAuthor{"schueler01", 1, 5000};

/// A block in its stored form; the check code is any number that depends on the text.
inline StoredBlock block(int number, const std::string& words) {
  std::string digits = std::to_string(number);
  digits.insert(0, 3 - digits.size(), '0');
  const std::string text = "N" + digits + words;
  return {number, text, static_cast<std::uint32_t>(std::hash<std::string>{}(text))};
}

inline StoredBlock renumbered(const StoredBlock& old, int number) { return block(number, old.text.substr(4)); }

/// The blocks' texts of a version, ascending.
inline std::optional<std::vector<std::string>> texts_at(Database& database, PersonId id, int program, int version) {
  const auto texts = database.program_at(
      id, program, version, [](const std::string& text, int number) { return block(number, text.substr(4)).text; });
  if (!texts) return std::nullopt;
  const auto blocks = std::views::values(*texts);
  return std::vector<std::string>(blocks.begin(), blocks.end());
}

inline std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace cnclab::db
