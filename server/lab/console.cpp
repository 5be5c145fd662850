// Which request is answered by which function; answers on their way.
#include "lab/console.hpp"

#include <algorithm>

#include "cnclab/v1/envelope.pb.h"
#include "lab/console_ask.hpp"
#include "shared/frame.hpp"

namespace cnclab::lab {

void Console::answer(const std::shared_ptr<Visit>& visit, const v1::InstructorRequest& request) {
  const Reply reply{visit, request.number(), lab_.tongue_of(visit->person)};
  if (visit->stage != Stage::at_console || visit->person.role != "instructor") {
    lab_.write_journal("refused", "instructor request without the role", 0, visit->person.name);
    return send_error(reply, lab_.say(reply.tongue, "Das darf nur die Lehrkraft.", "Only the instructor may do that."));
  }
  using R = v1::InstructorRequest;
  switch (request.what_case()) {
    case R::kStatus:
      return status(reply);
    case R::kSelect:
      return decided(reply, Select{static_cast<int>(request.select().station()), request.select().force()});
    case R::kRelease:
      return decided(reply, ReleaseIt{request.release().force()});
    case R::kHalt:
      return decided(reply, HaltPressed{kNoLogin, visit->person.name});
    case R::kClearHalt:
      return decided(reply, HaltCleared{kNoLogin});
    case R::kPowerOff:
      return decided(reply, PowerSwitched{false});
    case R::kPowerOn:
      return decided(reply, PowerSwitched{true});
    case R::kInput:
      return input(reply, request.input());
    case R::kMachineData:
      return machine_data(reply, request.machine_data());
    case R::kMessage:
      return message(reply, request.message());
    case R::kExpel:
      return expel(reply, request.expel());
    case R::kPasswd:
      return passwd(reply, request.passwd());
    case R::kStudents:
      return students(reply);
    case R::kStudentAdd:
      return student_add(reply, request.student_add());
    case R::kStudentRemove:
      return student_remove(reply, request.student_remove());
    case R::kStudentRestore:
      return student_restore(reply, request.student_restore());
    case R::kStudentRename:
      return student_rename(reply, request.student_rename());
    case R::kStudentPassword:
      return student_password(reply, request.student_password());
    case R::kPrograms:
      return programs(reply, request.programs());
    case R::kProgramShow:
      return program_show(reply, request.program_show());
    case R::kProgramVersions:
      return program_versions(reply, request.program_versions());
    case R::kProgramSend:
      return program_send(reply, request.program_send());
    case R::kRuns:
      return runs(reply, request.runs());
    case R::kRunTrace:
      return run_trace(reply, request.run_trace());
    case R::kJournal:
      return journal(reply, request.journal());
    default:
      return send_error(reply, lab_.say(reply.tongue, "Diesen Befehl kennt der Server nicht.",
                                        "This server does not know that command."));
  }
}

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
  if (reply.visit->transfer)
    return send_error(reply,
                      lab_.say(reply.tongue, "Eine Übertragung läuft schon.", "A transfer is under way already."));
  reply.visit->transfer = Visit::Transfer{++reply.visit->transfers, std::move(content), 0};
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
  if (ack.abort() ||
      (transfer->sent == transfer->content.size() && ack.next_offset() == transfer->sent && transfer->sent > 0)) {
    transfer.reset();
    return;
  }
  if (ack.next_offset() != transfer->sent) return lab_.hang_up(visit, "chunk acknowledged out of order");
  v1::ServerMessage message;
  auto& chunk = *message.mutable_chunk();
  chunk.set_transfer(transfer->number);
  chunk.set_offset(transfer->sent);
  chunk.set_data(transfer->content.substr(transfer->sent, kLargestChunk));
  transfer->sent += chunk.data().size();
  chunk.set_is_last(transfer->sent == transfer->content.size());
  visit->peer->send(message);
}

db::Person person_named(db::Database& database, const std::string& name) {
  auto person = database.person(name);
  if (!person) throw Refusal{"Unbekannter Name: " + name, "Unknown name: " + name};
  return *person;
}

}  // namespace cnclab::lab
