// From text to programs, or to the first fault.
#include "transfer/intake.hpp"

#include <algorithm>
#include <utility>

namespace cnclab::transfer {

std::expected<Intake, language::Error> take_in(std::string_view text, language::Reading reading,
                                               language::Tongue tongue) {
  language::Tape tape = language::read_tape(text, reading, tongue);
  if (!tape.errors.empty()) return std::unexpected(std::move(tape.errors.front()));
  if (tape.programs.empty() && tape.machine_data.empty()) {
    if (!tape.notices.empty()) return Intake{.notices = std::move(tape.notices)};
    return std::unexpected(language::Error{.code = language::ErrorCode::transfer_wrong, .expected = "P0001N001"});
  }
  Intake intake{.machine_data = std::move(tape.machine_data), .notices = std::move(tape.notices)};
  for (language::ReadProgram& read : tape.programs) intake.programs.push_back(std::move(read.program));
  return intake;
}

language::Program joined(language::Program stored, const language::Program& part) {
  for (const language::Block& block : part.blocks) {
    const auto place = std::ranges::lower_bound(stored.blocks, block.number, {}, &language::Block::number);
    if (place != stored.blocks.end() && place->number == block.number)
      *place = block;
    else
      stored.blocks.insert(place, block);
  }
  return stored;
}

}  // namespace cnclab::transfer
