// Collected, written five times a second, kept where the disk is full.
#include "lab/journal_book.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace cnclab::lab {

namespace {
constexpr std::size_t kMostUnwritten = 10'000;  ///< entries that wait for a disk with room
constexpr std::int64_t kPeriod_ns = 200'000'000;
}  // namespace

void JournalBook::write(std::string kind, std::string detail, int station, std::string person, Epoch lease) {
  entries_.push_back({clock_.unix_ms(), station, std::move(person), std::move(kind), std::move(detail),
                      static_cast<std::uint64_t>(lease)});
}

void JournalBook::flush_when_due() {
  if (clock_.monotonic_ns() - flushed_ns_ >= kPeriod_ns) flush();
}

void JournalBook::flush() {
  flushed_ns_ = clock_.monotonic_ns();
  if (entries_.empty()) return;
  const auto entries = std::make_shared<const std::vector<db::JournalEntry>>(std::exchange(entries_, {}));
  store_.run([entries](db::Database& database) { database.add_journal(*entries); },
             [this, entries, alive = alive_](const std::expected<void, db::StoreError>& result) {
               if (result || !*alive) return;
               spdlog::error("journal: {}", result.error().detail);
               // Written with the next ones, when there is room again; the oldest go first where it lasts.
               const std::size_t room = kMostUnwritten - std::min(kMostUnwritten, entries_.size());
               const auto kept = static_cast<std::ptrdiff_t>(std::min(entries->size(), room));
               entries_.insert(entries_.begin(), entries->end() - kept, entries->end());
             });
}

}  // namespace cnclab::lab
