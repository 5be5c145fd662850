// Answers on their way.
#include "lab/console/console.hpp"

#include <algorithm>
#include <sstream>

#include "cnclab/v1/envelope.pb.h"
#include "lab/console/console_ask.hpp"
#include "shared/frame.hpp"

namespace cnclab::lab {

v1::InstructorItem done_item(const std::string& detail) {
  v1::InstructorItem item;
  item.mutable_done()->set_ok(true);
  item.mutable_done()->set_detail(detail);
  return item;
}

void Console::send(const Reply& reply, const Items& items) const {
  // As many items to a frame as surely fit; each is well below a frame by itself.
  constexpr std::size_t kRoom = kLargestFrame - 1024;
  v1::ServerMessage message;
  auto* answer = message.mutable_answer();
  answer->set_number(reply.number);
  std::size_t bytes = 0;
  for (const auto& item : items) {
    const std::size_t size = item.ByteSizeLong() + 8;
    if (bytes + size > kRoom) {
      answer->set_more(true);
      reply.visit->peer->send(message);
      answer->clear_items();
      answer->set_more(false);
      bytes = 0;
    }
    *answer->add_items() = item;
    bytes += size;
  }
  reply.visit->peer->send(message);
}

void Console::send_error(const Reply& reply, const std::string& error) const {
  v1::ServerMessage message;
  message.mutable_answer()->set_number(reply.number);
  message.mutable_answer()->set_error(error);
  reply.visit->peer->send(message);
}

void Console::send_done(const Reply& reply, const std::string& detail) const { send(reply, {done_item(detail)}); }

void Console::send_file(const Reply& reply, std::string content) const {
  const std::uint64_t size = content.size();
  send_file(reply, std::make_shared<std::istringstream>(std::move(content)), size);
}

void Console::send_file(const Reply& reply, std::shared_ptr<std::istream> content, std::uint64_t size) const {
  if (reply.visit->transfer)
    return send_error(reply, say(reply.tongue, "Eine Übertragung läuft schon.", "A transfer is under way already."));
  reply.visit->transfer = Visit::Transfer{++reply.visit->transfers, std::move(content), size, 0};
  v1::ServerMessage message;
  message.mutable_answer()->set_number(reply.number);
  message.mutable_answer()->set_transfer(reply.visit->transfer->number);
  reply.visit->peer->send(message);
  v1::ChunkAck first;
  first.set_transfer(reply.visit->transfer->number);
  Console(lab_).continue_transfer(reply.visit, first);
}

void Console::continue_transfer(const std::shared_ptr<Visit>& visit, const v1::ChunkAck& ack) {
  auto& transfer = visit->transfer;
  if (!transfer || ack.transfer() != transfer->number) return;  // the end of a transfer that is over
  if (ack.abort() || (transfer->sent == transfer->size && ack.next_offset() == transfer->sent && transfer->sent > 0)) {
    transfer.reset();
    return;
  }
  if (ack.next_offset() != transfer->sent) return lab_.hang_up(visit, "chunk acknowledged out of order");
  v1::ServerMessage message;
  auto& chunk = *message.mutable_chunk();
  chunk.set_transfer(transfer->number);
  chunk.set_offset(transfer->sent);
  std::string data(std::min<std::uint64_t>(kLargestChunk, transfer->size - transfer->sent), '\0');
  transfer->content->read(data.data(), static_cast<std::streamsize>(data.size()));
  if (!transfer->content->good()) return lab_.hang_up(visit, "the content of a transfer cannot be read");
  transfer->sent += data.size();
  chunk.set_data(std::move(data));
  chunk.set_is_last(transfer->sent == transfer->size);
  visit->peer->send(message);
}

db::Person person_named(db::Database& database, const std::string& name) {
  auto person = database.person(name);
  if (!person) throw Refusal{"Unbekannter Name: " + name, "Unknown name: " + name};
  return *person;
}

}  // namespace cnclab::lab
