// Is a database file still what was written? For whoever looks at one without a server.
#pragma once

#include <expected>
#include <filesystem>
#include <string>
#include <vector>

#include "db/database.hpp"

namespace cnclab::db {

/// Reads the whole file once (pages, indexes, rules of the tables, references between them), also while a server
/// writes, and changes nothing.
///
/// returns  a sentence for each fault, at most 100; none where all is well
/// errors   it cannot be read, or is no database of ours; `damaged` where it is broken so far that nothing can be said
[[nodiscard]] std::expected<std::vector<std::string>, OpenError> integrity_faults(const std::filesystem::path& file);

}  // namespace cnclab::db
