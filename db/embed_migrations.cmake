# Turns the numbered .sql files into one C++ source:  cmake -DFILES=a.sql,b.sql -DOUT=migrations.cpp -P embed_migrations.cmake
string(REPLACE "," ";" files "${FILES}")
set(entries "")
foreach(path IN LISTS files)
  get_filename_component(name "${path}" NAME)
  if(NOT name MATCHES "^([0-9][0-9][0-9][0-9])_[a-z0-9_]+\\.sql$")
    message(FATAL_ERROR "${path}: a migration is called NNNN_name.sql")
  endif()
  string(REGEX REPLACE "^0+" "" number "${CMAKE_MATCH_1}")
  file(READ "${path}" text)
  string(APPEND entries "    {${number}, \"${name}\", R\"migration(${text})migration\"},\n")
endforeach()
file(WRITE "${OUT}.new"
"// Made from db/migrations/*.sql by db/embed_migrations.cmake.
#include \"db/migrate.hpp\"

namespace cnclab::db {

std::span<const Migration> migrations() {
  static constexpr Migration kMigrations[] = {
${entries}  };
  return kMigrations;
}

}  // namespace cnclab::db
")
file(RENAME "${OUT}.new" "${OUT}")
