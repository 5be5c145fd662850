// Chunks to files and back.
#include "station/media_drive.hpp"

#include <cnclab/v1/envelope.pb.h>

#include <utility>

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

v1::ClientMessage MediaDrive::put(const v1::PutMedia& request) {
  work_ = std::monostate{};  // before a new file is begun aside: what was there goes with its target
  transfer_ = request.transfer();
  if (request.size() == 0 || request.size() > kLargestMediaWritten) return failed(v1::MEDIA_FAULT_REFUSED);
  const auto folder = MediaFolder::open(place_, user_);
  if (!folder) return failed(folder.error());
  auto target = folder->write(request.name());
  if (!target) return failed(target.error());
  work_.emplace<Writing>(request.size(), 0, std::move(*target));
  return acknowledgement(transfer_, 0);
}

std::optional<v1::ClientMessage> MediaDrive::write(const v1::Chunk& chunk) {
  auto* const writing = std::get_if<Writing>(&work_);
  if (writing == nullptr || chunk.transfer() != transfer_) return std::nullopt;
  const std::uint64_t end = writing->written + chunk.data().size();
  const bool is_in_order = chunk.offset() == writing->written && !chunk.data().empty() &&
                           chunk.data().size() <= kLargestChunk && end <= writing->size &&
                           chunk.is_last() == (end == writing->size);
  if (!is_in_order) return failed(v1::MEDIA_FAULT_REFUSED);
  if (const auto appended = writing->target.append(chunk.data()); !appended) return failed(appended.error());
  writing->written = end;
  if (chunk.is_last()) {
    if (const auto finished = writing->target.finish(); !finished) return failed(finished.error());
    work_ = std::monostate{};
  }
  return acknowledgement(transfer_, end);
}

v1::ClientMessage MediaDrive::get(const v1::GetMedia& request) {
  work_ = std::monostate{};
  transfer_ = request.transfer();
  if (request.names().empty() || static_cast<std::size_t>(request.names_size()) > kMostMediaNames)
    return failed(v1::MEDIA_FAULT_REFUSED);
  const auto folder = MediaFolder::open(place_, user_);
  if (!folder) return failed(folder.error());
  for (const std::string& name : request.names()) {
    auto source = folder->read(name);
    if (!source && source.error() == v1::MEDIA_FAULT_NOT_FOUND) continue;
    if (!source) return failed(source.error());
    work_.emplace<Sending>(0, std::move(*source));
    return send_next();
  }
  return failed(v1::MEDIA_FAULT_NOT_FOUND);
}

std::optional<v1::ClientMessage> MediaDrive::acknowledged(const v1::ChunkAck& ack) {
  if (ack.transfer() != transfer_) return std::nullopt;
  if (ack.abort()) {
    work_ = std::monostate{};
    return std::nullopt;
  }
  auto* const sending = std::get_if<Sending>(&work_);
  if (sending == nullptr) return std::nullopt;
  if (ack.next_offset() != sending->sent) return failed(v1::MEDIA_FAULT_REFUSED);
  if (!sending->source.is_at_end()) return send_next();
  work_ = std::monostate{};
  return std::nullopt;
}

v1::ClientMessage MediaDrive::send_next() {
  auto& sending = std::get<Sending>(work_);
  auto bytes = sending.source.next(kLargestChunk);
  if (!bytes) return failed(bytes.error());
  v1::ClientMessage message;
  v1::Chunk& chunk = *message.mutable_chunk();
  chunk.set_transfer(transfer_);
  chunk.set_offset(sending.sent);
  sending.sent += bytes->size();
  chunk.set_data(std::move(*bytes));
  chunk.set_is_last(sending.source.is_at_end());
  return message;
}

v1::ClientMessage MediaDrive::failed(v1::MediaFault fault) {
  work_ = std::monostate{};
  v1::ClientMessage message;
  message.mutable_media_failed()->set_transfer(transfer_);
  message.mutable_media_failed()->set_fault(fault);
  return message;
}

}  // namespace cnclab::station
