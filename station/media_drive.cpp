// Chunks to files and back.
#include "station/media_drive.hpp"

#include <cnclab/v1/envelope.pb.h>

#include <utility>

#include "shared/digest.hpp"
#include "shared/frame.hpp"
#include "shared/media_name.hpp"

namespace cnclab::station {

namespace {

v1::ClientMessage acknowledgement(std::uint32_t transfer, std::uint64_t next_offset) {
  v1::ClientMessage message;
  message.mutable_chunk_ack()->set_transfer(transfer);
  message.mutable_chunk_ack()->set_next_offset(next_offset);
  return message;
}

/// Whether the transfer may go on at the request's offset in a file of `size` bytes: the receiver has the first of
/// `content` in the same form, and there are bytes left to travel.
template <class Request>
bool goes_on(const Request& request, std::string_view content, std::uint64_t size) {
  return request.offset() < size && begins_with(content, request.offset(), request.digest());
}

}  // namespace

std::optional<v1::ClientMessage> MediaDrive::take(const v1::ServerMessage& message) {
  switch (message.what_case()) {
    case v1::ServerMessage::kPutMedia:
      return put(message.put_media());
    case v1::ServerMessage::kGetMedia:
      return get(message.get_media());
    case v1::ServerMessage::kChunk:
      return write(message.chunk());
    case v1::ServerMessage::kChunkAck:
      return acknowledged(message.chunk_ack());
    case v1::ServerMessage::kWelcome:
    case v1::ServerMessage::kLogin:
    case v1::ServerMessage::kScreen:
    case v1::ServerMessage::kBeat:
    case v1::ServerMessage::kBye:
    case v1::ServerMessage::kAnswer:
    case v1::ServerMessage::kAskPassword:
    case v1::ServerMessage::kLanguageChosen:
    case v1::ServerMessage::WHAT_NOT_SET:
      break;
  }
  return std::nullopt;
}

void MediaDrive::pause() {
  transfer_.reset();
  if (std::holds_alternative<Leaving>(work_)) work_ = std::monostate{};  // it is read anew: it may have changed by then
}

v1::ClientMessage MediaDrive::put(const v1::PutMedia& request) {
  const std::uint32_t transfer = request.transfer();
  if (request.size() == 0 || request.size() > kLargestMediaWritten) return failed(transfer, v1::MEDIA_FAULT_REFUSED);
  const auto folder = MediaFolder::open(place_, user_);
  if (!folder) return failed(transfer, folder.error());
  if (const auto writable = folder->may_write(request.name()); !writable) return failed(transfer, writable.error());
  auto* const kept = std::get_if<Arriving>(&work_);
  if (kept != nullptr && kept->name == request.name() && kept->size == request.size() &&
      goes_on(request, kept->bytes, kept->size))
    kept->bytes.resize(request.offset());
  else
    work_ = Arriving{request.name(), request.size(), {}};
  transfer_ = transfer;
  return acknowledgement(transfer, std::get<Arriving>(work_).bytes.size());
}

std::optional<v1::ClientMessage> MediaDrive::write(const v1::Chunk& chunk) {
  auto* const arriving = std::get_if<Arriving>(&work_);
  if (arriving == nullptr || chunk.transfer() != transfer_) return std::nullopt;
  const std::uint64_t end = arriving->bytes.size() + chunk.data().size();
  const bool is_in_order = chunk.offset() == arriving->bytes.size() && !chunk.data().empty() &&
                           chunk.data().size() <= kLargestChunk && end <= arriving->size &&
                           chunk.is_last() == (end == arriving->size);
  if (!is_in_order) return failed(chunk.transfer(), v1::MEDIA_FAULT_REFUSED);
  arriving->bytes += chunk.data();
  if (chunk.is_last()) {
    if (const auto stored = store(*arriving); !stored) return failed(chunk.transfer(), stored.error());
    transfer_.reset();
  }
  return acknowledgement(chunk.transfer(), end);
}

std::expected<void, v1::MediaFault> MediaDrive::store(const Arriving& file) const {
  const auto folder = MediaFolder::open(place_, user_);
  if (!folder) return std::unexpected(folder.error());
  return folder->write(file.name, file.bytes);
}

v1::ClientMessage MediaDrive::get(const v1::GetMedia& request) {
  const std::uint32_t transfer = request.transfer();
  if (request.names().empty() || static_cast<std::size_t>(request.names_size()) > kMostMediaNames)
    return failed(transfer, v1::MEDIA_FAULT_REFUSED);
  const auto folder = MediaFolder::open(place_, user_);
  if (!folder) return failed(transfer, folder.error());
  for (const std::string& name : request.names()) {
    auto bytes = folder->read(name);
    if (!bytes && bytes.error() == v1::MEDIA_FAULT_NOT_FOUND) continue;
    if (!bytes) return failed(transfer, bytes.error());
    const std::uint64_t offset = goes_on(request, *bytes, bytes->size()) ? request.offset() : 0;
    transfer_ = transfer;
    return send_next(transfer, work_.emplace<Leaving>(std::move(*bytes), offset));
  }
  return failed(transfer, v1::MEDIA_FAULT_NOT_FOUND);
}

std::optional<v1::ClientMessage> MediaDrive::acknowledged(const v1::ChunkAck& ack) {
  if (ack.transfer() != transfer_) return std::nullopt;
  if (ack.abort()) {
    forget();
    return std::nullopt;
  }
  auto* const leaving = std::get_if<Leaving>(&work_);
  if (leaving == nullptr) return std::nullopt;
  if (ack.next_offset() != leaving->sent) return failed(ack.transfer(), v1::MEDIA_FAULT_REFUSED);
  if (leaving->sent < leaving->bytes.size()) return send_next(ack.transfer(), *leaving);
  forget();
  return std::nullopt;
}

v1::ClientMessage MediaDrive::send_next(std::uint32_t transfer, Leaving& file) {
  v1::ClientMessage message;
  v1::Chunk& chunk = *message.mutable_chunk();
  chunk.set_transfer(transfer);
  chunk.set_offset(file.sent);
  chunk.set_data(file.bytes.substr(file.sent, kLargestChunk));
  file.sent += chunk.data().size();
  chunk.set_is_last(file.sent == file.bytes.size());
  return message;
}

v1::ClientMessage MediaDrive::failed(std::uint32_t transfer, v1::MediaFault fault) {
  forget();
  v1::ClientMessage message;
  message.mutable_media_failed()->set_transfer(transfer);
  message.mutable_media_failed()->set_fault(fault);
  return message;
}

void MediaDrive::forget() {
  transfer_.reset();
  work_ = std::monostate{};
}

}  // namespace cnclab::station
