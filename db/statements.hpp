// What stands behind `Database`: its connection. Private to db/.
#pragma once

#include "db/connection.hpp"
#include "db/database.hpp"

namespace cnclab::db {

struct Database::Statements : Connection {
  using Connection::Connection;
};

}  // namespace cnclab::db
