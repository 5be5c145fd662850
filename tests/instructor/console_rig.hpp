// A console to press keys at, and what it then asks of the server.
#pragma once

#include <string>

#include "instructor/console_model.hpp"

namespace cnclab::instructor {

/// Connected, the machine at rest, seat 7 chosen.
inline ConsoleModel connected(std::uint32_t selected = 0) {
  ConsoleModel model;
  model.status.emplace();
  model.status->set_selected(selected);
  model.status->mutable_machine()->set_state("standstill");
  model.chosen = 7;
  return model;
}

/// The request in text format, "-" if there is none.
inline std::string asked(const Reaction& reaction) {
  return reaction.request ? reaction.request->ShortDebugString() : "-";
}

}  // namespace cnclab::instructor
