// Fuzzer of frames: a stream of bytes is split and parsed as both ends do it (SEC-005, SEC-006).
#include <cnclab/v1/envelope.pb.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "shared/frame.hpp"

namespace {

// What was read must be written and read as the same again.
template <class Message>
void parse(const std::uint8_t* body, std::size_t length) {
  Message message;
  if (!message.ParseFromArray(body, static_cast<int>(length))) return;
  const std::string bytes = cnclab::frame(message);
  Message again;
  const int size = static_cast<int>(bytes.size() - cnclab::kFrameHeader);
  if (!again.ParseFromArray(bytes.data() + cnclab::kFrameHeader, size)) std::abort();
  if (again.what_case() != message.what_case()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  while (size >= cnclab::kFrameHeader) {
    const auto length =
        cnclab::body_length(std::span<const std::uint8_t, cnclab::kFrameHeader>(data, cnclab::kFrameHeader));
    if (!length) return 0;  // the connection is ended here
    if (*length == 0 || *length > cnclab::kLargestFrame) std::abort();
    data += cnclab::kFrameHeader;
    size -= cnclab::kFrameHeader;
    const std::size_t arrived = std::min(*length, size);
    parse<cnclab::v1::ClientMessage>(data, arrived);
    parse<cnclab::v1::ServerMessage>(data, arrived);
    data += arrived;
    size -= arrived;
  }
  return 0;
}
