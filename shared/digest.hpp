// What proves that two ends hold the same bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cnclab {

/// SHA-256, its 32 bytes as they are. Throws std::runtime_error where there is no memory for it.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// Whether `content` begins with the `offset` bytes, 1 or more, whose SHA-256 is `digest`. Both may come from the
/// network: whatever they are, the answer is false unless the bytes are there.
[[nodiscard]] bool begins_with(std::string_view content, std::uint64_t offset, std::string_view digest);

}  // namespace cnclab
