// One change of a program with its inverse. Private to db/.
#pragma once

#include <string>

#include "db/connection.hpp"
#include "db/types.hpp"

namespace cnclab::db {

/// A row of program_change; what `before` and `after` hold for each kind stands in 0001_first.sql.
struct Change {
  PersonId person{};
  int program = 0;
  const char* kind = "";
  int block = 0;
  std::string before;
  std::string after;
  const Author& author;
};

/// Writes the change as the program's next version and brings the program's own row up to date, making it where there
/// is none. The count of versions goes on after a program was removed.
void record_change(Connection& connection, const Change& change);

}  // namespace cnclab::db
