// Runs the numbered schema files.
#include "db/migrate.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>

#include <string>

#include "db/backup.hpp"

namespace cnclab::db {

int schema_version(SQLite::Database& database) { return database.execAndGet("PRAGMA user_version").getInt(); }

void migrate(SQLite::Database& database, const std::filesystem::path& file, std::span<const Migration> steps) {
  const int version = schema_version(database);
  if (version > 0 && !steps.empty() && version < steps.back().number && file != ":memory:")
    copy_connection(database, file.string() + ".version-" + std::to_string(version));
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
