// Feeds any text to the reader of the roster: errors with their lines, or names that can be written and read again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lab/console/roster_csv.hpp"

using cnclab::language::Tongue;

namespace {

void require(bool is_right) {
  if (!is_right) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = cnclab::lab::read_roster(text, Tongue::german);
  require(cnclab::lab::read_roster(text, Tongue::english).errors.size() == read.errors.size());
  if (!read.errors.empty()) return 0;
  const auto again = cnclab::lab::read_roster(cnclab::lab::write_roster(read.entries), Tongue::german);
  require(again.errors.empty() && again.entries.size() == read.entries.size());
  for (std::size_t i = 0; i < read.entries.size(); ++i) {
    require(cnclab::lab::is_name(read.entries[i].name));
    require(again.entries[i].name == read.entries[i].name && again.entries[i].language == read.entries[i].language);
  }
  return 0;
}
