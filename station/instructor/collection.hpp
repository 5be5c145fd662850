// Everybody's programs as they come from the server, cut into one tape file for each student (INS-003).
//
//   collection = { "(" name ")" LF { line LF } }        the lines are tape text, which has no other line with a bracket
#pragma once

#include <expected>
#include <filesystem>
#include <vector>

#include "instructor/failure.hpp"

namespace cnclab::instructor {

/// Writes NAME.tape into `folder` for each student of the collection, replacing files of these names, and removes the
/// collection. errors: a name that is no file name, a file that cannot be written; nothing but whole files is left.
[[nodiscard]] std::expected<std::vector<std::filesystem::path>, Failure> split_collection(
    const std::filesystem::path& collection, const std::filesystem::path& folder);

}  // namespace cnclab::instructor
