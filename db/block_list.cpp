// Whole programs inside program_change.
#include "db/block_list.hpp"

#include <charconv>

#include "db/failure.hpp"

namespace cnclab::db {

void check_storable(const StoredBlock& block) {
  if (block.text.empty() || block.text.find('\n') != std::string::npos)
    throw StoreFailure(FailureKind::refused,
                       "block " + std::to_string(block.number) + ": the stored form must be one line and not empty");
}

std::string write_list(const std::vector<StoredBlock>& ascending) {
  std::string text;
  for (const StoredBlock& block : ascending) text += std::to_string(block.number) + ' ' + block.text + '\n';
  return text;
}

BlockTexts read_list(std::string_view text) {
  BlockTexts blocks;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    int number = 0;
    const auto read = std::from_chars(line.data(), line.data() + line.size(), number);
    const auto digits = static_cast<std::size_t>(read.ptr - line.data());
    if (end == std::string_view::npos || read.ec != std::errc{} || digits >= line.size() || line[digits] != ' ')
      throw StoreFailure(FailureKind::damaged, "program_change: a list of blocks cannot be read");
    blocks.emplace_hint(blocks.end(), number, line.substr(digits + 1));
    text.remove_prefix(end + 1);
  }
  return blocks;
}

}  // namespace cnclab::db
