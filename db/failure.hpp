// What goes wrong while storing: thrown by the repositories, caught once by `Store`, told to the one who stored.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cnclab::db {

/// Why something could not be stored or read.
enum class FailureKind : std::uint8_t {
  locked,   ///< another program holds the database longer than the busy time-out
  full,     ///< the disk is full, a quota spent or a limit on file sizes reached
  damaged,  ///< the file is not what was written
  disk,     ///< reading or writing failed
  refused,  ///< the value breaks a rule of the schema, or its owner is no longer there
};

/// For row 18 of a screen behind "Nicht gespeichert: " (at most 80 columns together): what happened and what to do.
/// `language`: "de" or "en".
[[nodiscard]] std::string_view explain(FailureKind kind, std::string_view language);

/// Thrown by repositories. `what()` is for the log: the failing step and SQLite's own words.
class StoreFailure : public std::runtime_error {
 public:
  StoreFailure(FailureKind kind, const std::string& detail) : std::runtime_error(detail), kind_(kind) {}
  [[nodiscard]] FailureKind kind() const { return kind_; }

 private:
  FailureKind kind_;
};

}  // namespace cnclab::db
