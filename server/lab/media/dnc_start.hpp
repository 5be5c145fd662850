// Whether "PxxxxNxxx*" may start something now (AUTH-013, AUTH-008, DEC-35). A pure rule, one row for each reason.
//
//   lab machine        somebody sits there, has the lease and the keyboard, nobody pressed MASCHINE HALT, and the
//   student
//                      released this program and block under this lease within 60 s; once
//   training machine   only where [dnc] training_start allows it
//   both               never honoured late: the "*" came within the last second
#pragma once

#include <cstdint>
#include <optional>

#include "lab/refusal.hpp"
#include "machine/channel.hpp"
#include "panel/run/serial_port.hpp"

namespace cnclab::lab {

/// The situation when the control asks.
struct RemoteStartView {
  std::int64_t now_ns = 0;
  bool is_seated = false;
  bool is_barred = false;  ///< keyboard locked or taken over
  bool on_lab_machine = false;
  bool training_start = false;  ///< [dnc] training_start
  bool has_lease = false;       ///< the desk holds the lease, and the machine honours it still
  bool is_halted = false;       ///< MASCHINE HALT is latched
  machine::Epoch lease{};       ///< the newest
  std::optional<panel::Armed> armed;
};

enum class RemoteStartRefusal : std::uint8_t {
  nobody_there,
  barred,
  late,
  training,
  no_lease,
  halted,
  not_released,
  released_otherwise,  ///< another program or block
  release_over,        ///< older than 60 s, or of another lease
};

[[nodiscard]] std::optional<RemoteStartRefusal> refusal_of(const panel::RemoteStart& start,
                                                           const RemoteStartView& view);
/// Row 18 of the station; the English one is the journal's too.
[[nodiscard]] Refusal text_of(RemoteStartRefusal refusal);

}  // namespace cnclab::lab
