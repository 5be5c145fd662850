// Content that comes in chunks, written to a file that appears only when it is complete.
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <fstream>

#include "cnclab/v1/bulk.pb.h"
#include "instructor/failure.hpp"

namespace cnclab::instructor {

/// Writes beside `target` and renames at the end, so that a broken transfer leaves an older file as it was. Readable
/// by the owner alone: backups and rosters are nobody else's.
class BulkFile {
 public:
  explicit BulkFile(std::filesystem::path target);
  ~BulkFile();  ///< removes what is incomplete
  BulkFile(const BulkFile&) = delete;
  BulkFile& operator=(const BulkFile&) = delete;

  /// Takes the next chunk and gives its acknowledgement. errors: wrong place or size, cannot be written.
  [[nodiscard]] std::expected<v1::ChunkAck, Failure> take(const v1::Chunk& chunk);
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  std::filesystem::path target_, part_;
  std::ofstream stream_;
  std::uint64_t size_ = 0;
  bool is_complete_ = false;
};

}  // namespace cnclab::instructor
