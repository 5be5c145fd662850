// Which machine a control moves: its own training machine, or the lab's.
#pragma once

#include <memory>
#include <optional>

#include "machine/channel.hpp"
#include "machine/machine_data.hpp"
#include "machine/tool_list.hpp"

namespace cnclab::panel {

/// A command given now is in the snapshot two ticks later: the tick that runs may have read the ring already.
inline constexpr std::uint64_t kAnswerTicks = 2;

struct Connection {
  std::shared_ptr<machine::Channel> channel;
  machine::Epoch epoch{};
  bool is_lab_machine = false;
  machine::MachineData lab_data;             ///< the lab machine's own, only where is_lab_machine
  bool requires_reference = false;           ///< without a reference only HANDBETRIEB moves (DEC-27)
  std::optional<machine::ToolList> tools{};  ///< as the instructor keeps it; nothing: it is not asked for (DEC-29)
};

}  // namespace cnclab::panel
