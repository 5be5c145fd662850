// Finding a block in a program by its number.
#include "language/block.hpp"

#include <algorithm>

namespace cnclab::language {

std::optional<std::size_t> Program::find(std::uint16_t n) const {
  const auto at = std::ranges::lower_bound(blocks, n, {}, &Block::number);
  if (at == blocks.end() || at->number != n) return std::nullopt;
  return static_cast<std::size_t>(at - blocks.begin());
}

}  // namespace cnclab::language
