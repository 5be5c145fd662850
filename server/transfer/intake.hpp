// What received text puts into a memory: all of it or nothing (DEC-57), and how parts join (EXT-061).
#pragma once

#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "language/tape.hpp"

namespace cnclab::transfer {

struct Intake {
  std::vector<language::Program> programs{};           ///< in the order received; at least one, or machine data
  std::vector<language::MachineDatum> machine_data{};  ///< for whoever adopts them (EXT-026)
  std::vector<std::string> notices{};                  ///< P9981 to P9989 left out (DEC-06)
};

/// Reads received text, whole.
///
/// reading   strict for what comes from the control's own devices; file for diskettes, which people write too
/// errors    the first fault, or transfer_wrong where there is nothing in it; nothing of it is to be stored then
[[nodiscard]] std::expected<Intake, language::Error> take_in(std::string_view text, language::Reading reading,
                                                             language::Tongue tongue);

/// The stored program with the blocks of a part that continues it: those of the same number are replaced.
[[nodiscard]] language::Program joined(language::Program stored, const language::Program& part);

}  // namespace cnclab::transfer
