// Names and lines of cassettes.
#include "lab/media/cassettes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cnclab::lab {

namespace {

/// The same for a cassette on the shelf and one in the recorder; an empty one holds 0 KB.
std::size_t kilobytes_recorded(std::size_t stored_bytes) {
  constexpr std::size_t kKilobyte = 1024;
  const std::size_t recorded = stored_bytes - std::min(stored_bytes, transfer::Cassette{}.serialized().size());
  return (recorded + kKilobyte - 1) / kKilobyte;
}

}  // namespace

std::string cassette_name(int number) { return fmt::format("K{:02}", number); }

std::string free_cassette_name(const std::vector<db::StoredCassette>& list) {
  int number = 1;
  while (std::ranges::any_of(list, [&](const auto& cassette) { return cassette.name == cassette_name(number); }))
    ++number;
  return cassette_name(number);
}

std::string cassette_line(const db::StoredCassette& cassette, const std::optional<transfer::Cassette>& deck,
                          language::Tongue tongue) {
  const bool is_german = tongue == language::Tongue::german;
  if (!cassette.is_inserted || !deck)
    return fmt::format("{:5} {:>4} KB", cassette.name, kilobytes_recorded(cassette.bytes));
  return fmt::format(fmt::runtime(is_german ? "{:5} {:>4} KB  im Rekorder, Zähler {:03}, Aufnahmen: {}"
                                            : "{:5} {:>4} KB  in the recorder, counter {:03}, recordings: {}"),
                     cassette.name, kilobytes_recorded(deck->serialized().size()), deck->counter(),
                     deck->pieces().size());
}

}  // namespace cnclab::lab
