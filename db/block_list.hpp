// A program's blocks as one text: one line "NUMBER TEXT" for each block, ascending. Private to db/.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "db/types.hpp"

namespace cnclab::db {

/// A stored block must not be empty (that means "was not there") and must be one line.
/// errors  StoreFailure of kind `refused`
void check_storable(const StoredBlock& block);

[[nodiscard]] std::string write_list(const std::vector<StoredBlock>& ascending);

/// Reads what `write_list` wrote.
/// errors  StoreFailure of kind `damaged`
[[nodiscard]] BlockTexts read_list(std::string_view text);

}  // namespace cnclab::db
