// Content that comes in chunks, written to a file that appears only when it is complete.
#include "instructor/bulk_file.hpp"

#include <cstdio>
#include <system_error>

#include "shared/frame.hpp"

namespace cnclab::instructor {

BulkFile::BulkFile(std::filesystem::path target)
    : target_(std::move(target)),
      part_(target_.string() + ".part"),
      stream_(part_, std::ios::binary | std::ios::trunc) {
  std::error_code ignored;
  std::filesystem::permissions(part_, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write,
                               ignored);
}

BulkFile::~BulkFile() {
  if (is_complete_) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

std::expected<v1::ChunkAck, Failure> BulkFile::take(const v1::Chunk& chunk) {
  if (chunk.offset() != size_ || chunk.data().size() > kLargestChunk) {
    return std::unexpected(
        Failure{kRefused, own_words({"der Server hat den Inhalt durcheinander geschickt; bitte noch einmal",
                                     "the server sent the content in disorder; try again"})});
  }
  stream_.write(chunk.data().data(), static_cast<std::streamsize>(chunk.data().size()));
  size_ += chunk.data().size();
  if (chunk.is_last()) {
    stream_.close();
    is_complete_ = stream_.good() && std::rename(part_.c_str(), target_.c_str()) == 0;
  }
  if (!stream_.good() || (chunk.is_last() && !is_complete_)) {
    return std::unexpected(
        Failure{kRefused, target_.string() + own_words({": nicht zu schreiben. Ist Platz da, darf man schreiben?",
                                                        ": cannot be written. Is there space, may you write?"})});
  }
  v1::ChunkAck acknowledgement;
  acknowledgement.set_transfer(chunk.transfer());
  acknowledgement.set_next_offset(size_);
  return acknowledgement;
}

}  // namespace cnclab::instructor
