// Pieces end before a byte that begins a letter.
#include "instructor/tape_parts.hpp"

#include "shared/frame.hpp"

namespace cnclab::instructor {

std::optional<v1::InstructorRequest> take_part(v1::InstructorRequest& request) {
  if (!request.has_program_send() || request.program_send().tape().size() <= kLargestChunk) return std::nullopt;
  std::string& tape = *request.mutable_program_send()->mutable_tape();
  std::size_t end = kLargestChunk;
  while ((static_cast<unsigned char>(tape[end]) & 0xC0U) == 0x80U) --end;
  v1::InstructorRequest part;
  part.mutable_program_send()->set_tape(tape.substr(0, end));
  part.mutable_program_send()->set_more(true);
  tape.erase(0, end);
  return part;
}

}  // namespace cnclab::instructor
