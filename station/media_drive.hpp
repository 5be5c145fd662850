// The station's end of the conversation about files (proto/README.md, "Files at the station"): what the server asks
// for is written or sent chunk by chunk, one transfer at a time. It knows no connection: messages in, messages out.
#pragma once

#include <cnclab/v1/bulk.pb.h>

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <variant>

#include "station/media_folder.hpp"

namespace cnclab::v1 {
class ClientMessage;
class ServerMessage;
}  // namespace cnclab::v1

namespace cnclab::station {

/// A file is fetched whole before anything is written, and read whole before anything is sent: of one that was cut off
/// or changes meanwhile nothing half stands anywhere. Holds the bytes of one file, at most kLargestMediaWritten, until
/// the next transfer takes its place, the server breaks it off or the drive ends. One thread.
class MediaDrive {
 public:
  MediaDrive(MediaPlace place, std::string user) : place_(std::move(place)), user_(std::move(user)) {}

  /// Whose files these are: another user needs another drive.
  [[nodiscard]] const std::string& user() const { return user_; }

  /// PutMedia, GetMedia, Chunk and ChunkAck; others, and those of a transfer that is over, are passed over.
  /// returns   what is to be sent
  [[nodiscard]] std::optional<v1::ClientMessage> take(const v1::ServerMessage& message);

  /// The connection is gone. What has come of a file is kept for the same user's next one.
  void pause();

 private:
  /// It stays when the last chunk was acknowledged: whether that arrives is not known.
  struct Arriving {
    std::string name;
    std::uint64_t size = 0;  ///< as announced
    std::string bytes;       ///< what has come of it
  };
  struct Leaving {
    std::string bytes;
    std::uint64_t sent = 0;
  };
  [[nodiscard]] v1::ClientMessage put(const v1::PutMedia& request);
  [[nodiscard]] v1::ClientMessage get(const v1::GetMedia& request);
  [[nodiscard]] std::optional<v1::ClientMessage> write(const v1::Chunk& chunk);
  [[nodiscard]] std::optional<v1::ClientMessage> acknowledged(const v1::ChunkAck& ack);
  [[nodiscard]] std::expected<void, v1::MediaFault> store(const Arriving& file) const;
  [[nodiscard]] v1::ClientMessage send_next(std::uint32_t transfer, Leaving& file);
  [[nodiscard]] v1::ClientMessage failed(std::uint32_t transfer, v1::MediaFault fault);
  void forget();

  MediaPlace place_;
  std::string user_;
  std::optional<std::uint32_t> transfer_;  ///< that is under way
  std::variant<std::monostate, Arriving, Leaving> work_;
};

}  // namespace cnclab::station
