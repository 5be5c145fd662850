// SQLite's own checks, in the whole.
#include "db/integrity.hpp"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include "db/inspect.hpp"

namespace cnclab::db {

std::expected<std::vector<std::string>, OpenError> integrity_faults(const std::filesystem::path& file) {
  try {
    auto database = open_read_only(file);
    std::vector<std::string> faults;
    SQLite::Statement pages(database, "PRAGMA integrity_check(100)");
    while (pages.executeStep())
      if (std::string finding = pages.getColumn(0).getString(); finding != "ok") faults.push_back(std::move(finding));
    SQLite::Statement references(database, "PRAGMA foreign_key_check");
    while (references.executeStep())
      faults.push_back("a row of " + references.getColumn(0).getString() + " belongs to a row of " +
                       references.getColumn(2).getString() + " that is not there");
    return faults;
  } catch (const SQLite::Exception& exception) {
    return std::unexpected(open_error(file, exception));
  }
}

}  // namespace cnclab::db
