// Runs the numbered schema files.
#include "db/migrate.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>

#include <string>

#include "db/backup.hpp"

namespace cnclab::db {

int schema_version(SQLite::Database& database) { return database.execAndGet("PRAGMA user_version").getInt(); }

namespace {

// The copy of another database that lay here before is nobody's to overwrite.
std::filesystem::path free_name(const std::string& name) {
  std::filesystem::path free = name;
  for (int number = 2; std::filesystem::exists(free); ++number) free = name + "-" + std::to_string(number);
  return free;
}

}  // namespace

void migrate(SQLite::Database& database, const std::filesystem::path& file, std::span<const Migration> steps) {
  const int version = schema_version(database);
  if (version > 0 && !steps.empty() && version < steps.back().number && file != ":memory:")
    copy_connection(database, free_name(file.string() + ".version-" + std::to_string(version)));
  for (const Migration& step : steps) {
    if (step.number <= version) continue;
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec(step.sql);
    database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
    database.exec("PRAGMA user_version = " + std::to_string(step.number));
    transaction.commit();
  }
}

}  // namespace cnclab::db
