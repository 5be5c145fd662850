// What a run was begun with, as JSON and back (STO-007); kept in run.setup.
//
//   { "program": 1, "block": 1, "position": [x, y, z, u], "compensation": [x, y, z], "modal": {…},
//     "parameters": {"4": 25000000}, "data": {"3": 500000, …}, "model": 3300, "planned_functions": true,
//     "tools": {"in_spindle": 3, "list": {"3": [5.0, 0.0]}}, "versions": {"1": 17}, "texts": {"9999":
//     ["N001G00X+50000"]} }
//
// Programs stand there by the version that the database keeps; one that is not stored like that (the line of
// HANDEINGABE) by its text. `tools` (radius and length of each) only where the
// machine keeps a list, and "machine_mm": [x, y, z] only where it knows its place. Lengths in mm, everything else in
// the units of the structs.
#pragma once

#include <expected>
#include <nlohmann/json.hpp>
#include <string>

#include "db/database.hpp"
#include "panel/run/run.hpp"

namespace cnclab::lab {

/// Looks up the versions of the programs: on the store's thread.
[[nodiscard]] nlohmann::json order_json(const panel::RunOrder& order, db::Database& database, db::PersonId person);

/// errors  what is missing or not readable, in a few words for the instructor
[[nodiscard]] std::expected<panel::RunOrder, std::string> order_of(const nlohmann::json& json, db::Database& database,
                                                                   db::PersonId person);

}  // namespace cnclab::lab
