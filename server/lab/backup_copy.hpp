// A consistent copy of the database while the lab works, made on a thread of its own (STO-008).
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <thread>

#include "db/store.hpp"

namespace cnclab::lab {

/// The copy's bytes. Its file has no name any more: it is gone with the stream, also after a crash.
struct BackupContent {
  std::shared_ptr<std::istream> stream;
  std::uint64_t size = 0;
};

class BackupCopy {
 public:
  using Result = std::expected<BackupContent, std::string>;

  /// database  the file to copy; the copy is made beside it, where there is room for it
  BackupCopy(std::filesystem::path database, db::Post post) : database_(std::move(database)), post_(std::move(post)) {}
  ~BackupCopy();  ///< waits for a copy under way
  BackupCopy(const BackupCopy&) = delete;
  BackupCopy& operator=(const BackupCopy&) = delete;

  /// `done` is posted. False while another copy is under way: nothing is done then.
  [[nodiscard]] bool make(std::function<void(Result)> done);

 private:
  std::filesystem::path database_;
  db::Post post_;
  std::shared_ptr<bool> busy_ = std::make_shared<bool>(false);  ///< the posting thread's own
  std::thread thread_;
};

}  // namespace cnclab::lab
