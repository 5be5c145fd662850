// The station's end of the conversation about files (proto/README.md, "Files at the station"): what the server asks
// for is written or sent chunk by chunk, one transfer at a time. It knows no connection: messages in, messages out.
#pragma once

#include <cnclab/v1/bulk.pb.h>

#include <optional>
#include <string>
#include <variant>

#include "station/media_folder.hpp"

namespace cnclab::v1 {
class ClientMessage;
class ServerMessage;
}  // namespace cnclab::v1

namespace cnclab::station {

/// Reads and writes as they are asked for, at once: a chunk is 4 KiB. A new transfer takes the place of one that is
/// under way. One thread.
class MediaDrive {
 public:
  MediaDrive(MediaPlace place, std::string user) : place_(std::move(place)), user_(std::move(user)) {}

  /// PutMedia, GetMedia, Chunk and ChunkAck; others, and those of a transfer that is over, are passed over.
  /// returns   what is to be sent
  [[nodiscard]] std::optional<v1::ClientMessage> take(const v1::ServerMessage& message);

 private:
  struct Writing {
    std::uint64_t size = 0, written = 0;
    MediaTarget target;
  };
  struct Sending {
    std::uint64_t sent = 0;
    MediaSource source;
  };
  [[nodiscard]] v1::ClientMessage put(const v1::PutMedia& request);
  [[nodiscard]] v1::ClientMessage get(const v1::GetMedia& request);
  [[nodiscard]] std::optional<v1::ClientMessage> write(const v1::Chunk& chunk);
  [[nodiscard]] std::optional<v1::ClientMessage> acknowledged(const v1::ChunkAck& ack);
  [[nodiscard]] v1::ClientMessage send_next();
  [[nodiscard]] v1::ClientMessage failed(v1::MediaFault fault);

  MediaPlace place_;
  std::string user_;
  std::uint32_t transfer_ = 0;
  std::variant<std::monostate, Writing, Sending> work_;
};

}  // namespace cnclab::station
