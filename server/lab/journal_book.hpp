// The journal on its way to the disk: entries are collected and written together (STO-006, AUTH-015).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "lab/authority.hpp"
#include "lab/clock.hpp"

namespace cnclab::lab {

/// Lab thread.
class JournalBook {
 public:
  /// store, clock   outlive the book
  JournalBook(db::Store& store, const Clock& clock) : store_(store), clock_(clock) {}
  ~JournalBook() { *alive_ = false; }
  JournalBook(const JournalBook&) = delete;
  JournalBook& operator=(const JournalBook&) = delete;

  /// station   0: of none
  void write(std::string kind, std::string detail, int station = 0, std::string person = {}, Epoch lease = {});
  /// What was written goes to the store; what the store cannot take waits here, bounded, for the next time (STO-009).
  void flush();
  /// As `flush`, five times a second at most.
  void flush_when_due();

 private:
  db::Store& store_;
  const Clock& clock_;
  std::vector<db::JournalEntry> entries_;
  std::int64_t flushed_ns_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< a late answer of the store finds it gone
};

}  // namespace cnclab::lab
