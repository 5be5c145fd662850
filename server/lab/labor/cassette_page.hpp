// The page of one cassette in the menu behind key LABOR: what its keys do, and its rows.
//
//   CassettePage ── 1 to 5 ──▶ put in, take out, the recorder's own keys
//        ├── 6 ──▶ number ── → ──▶ another name
//        └── 7 ──▶ question ── → ──▶ removed
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "language/units.hpp"
#include "shared/key.hpp"

namespace cnclab::lab {

enum class CassetteAct : std::uint8_t { insert, eject, rewind, wind_on, stop, zero_counter, rename, remove };

struct CassettePage {
  std::size_t index = 0;  ///< in the list of cassettes
  std::string line;       ///< as it stands in the list
  bool is_inserted = false;
  enum class Step : std::uint8_t { acts, renaming, removing };
  Step step = Step::acts;
  std::string digits{};  ///< of the number that it is to have, at most two
};

/// The act that the key asks for; `number` is the page's digits where it is `rename`.
[[nodiscard]] std::optional<CassetteAct> press(CassettePage& page, Key key);
/// C: one step back; false where the page itself is to be left.
[[nodiscard]] bool step_back(CassettePage& page);

/// Heading, lines and keys as the menu writes them.
struct CassetteRows {
  std::string heading{};
  std::vector<std::string> lines{};
  std::string keys{};
};
[[nodiscard]] CassetteRows rows_of(const CassettePage& page, language::Tongue tongue);

}  // namespace cnclab::lab
