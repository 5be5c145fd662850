// The seam to the iron: what goes out to a machine and what comes back, once per tick.
//
// A driver of a real machine implements `Machine` and needs no other file than this one. The lab owns everything above
// the seam (who may move, ramps, path, limit-switch procedure, reference runs); a driver owns the electronics below it.
//
//        tick (1 ms)                        driver                              machine
//   Outputs{steps, levels} ──exchange()──▶  queue the steps of this ms  ──────▶ pulses, relays
//   Inputs{switches, …}    ◀──────────────  the newest levels           ◀────── switches, inputs
//
// Rules for `exchange`
//  1. It is called from one thread, the tick's, every millisecond, also at rest and without current. A late tick is
//     late; it is never made up for by two in a row, so the steps of one call always belong to one millisecond.
//  2. It returns within some microseconds: no allocation, lock, log, system call that can wait. Slow electronics are
//     served from a thread of the driver's own, through a queue without locks.
//  3. Steps are whole, signed, relative: the sum since the driver was made is where the lab believes the axis to be.
//     Spread them evenly over the millisecond. The lab never asks for more than F MAX × steps/mm (+1) per millisecond,
//     nor for a change of speed beyond RAMPE and F START/STOP, stops at switches and power-off excepted: those end
//     with a tick of no steps.
//  4. `drives_on == false` takes the current from the motors (Stromnullung); steps are 0 then. Whatever is still queued
//     must be thrown away, not run later.
//  5. Inputs are levels as they are now, with polarity already taken away: true means active. `limit_plus` is the
//     switch at the positive end of the travel, and stays true while the axis is beyond it (HW-009: a switch must stay
//     damped until the motor stands). The lab stops in the tick after the one in which a switch came on, and backs off
//     by itself. connectors.hpp has the polarities of the original and tells both ends apart where an axis has one
//     line.
//  6. `fault` is for a drive that cannot follow (stall, missing supply, lost link, watchdog). It acts as a power-off:
//     no steps from the next tick on, and no PowerOn as long as it lasts. A driver that loses its electronics raises it
//     instead of throwing.
//  7. A watchdog belongs into the electronics: when no tick came for some 20 ms, take the current away. The lab has one
//     of its own (watchdog.hpp), which calls `cut`, and cannot help when the computer itself has stopped. Neither is an
//     emergency stop: that is hardware (AUTH-010).
//
// Life: made before its channel, outlives it. Nothing but `cut` is called from another thread than the tick's.
// Implementations: `SimulatedMachine` (simulated_machine.hpp), `MachineRecorder` and `ReplayMachine` (recorder.hpp).
#pragma once

#include <array>
#include <cstdint>

#include "geometry/path_item.hpp"
#include "motion/follower.hpp"

namespace cnclab::machine {

/// Signals to the machine (HW-001 to HW-006, HW-019 to HW-021), as levels: the same every tick until they change.
struct Outputs {
  motion::AxisSteps steps{};  ///< X Y Z U, signed, for this tick alone
  bool drives_on = true;      ///< false: Stromnullung
  bool start = false;         ///< external signal Start: from START until rest after STOP or the end (HW-005)
  geometry::SpindleTurn spindle = geometry::SpindleTurn::off;
  std::int32_t spindle_rpm = 0;  ///< >= 0; 0 where the program gave no S
  bool coolant = false;
  bool signal = false;                  ///< acoustic signal, one tick per tone (M01, M15)
  std::array<std::uint8_t, 2> cards{};  ///< outputs of I/O cards 1 and 2, bit 0 = line 1, 1 = active
  std::int32_t s_digits = 0;            ///< I/O card 3
  friend bool operator==(const Outputs&, const Outputs&) = default;
};

/// Signals from the machine. Polarity of switches and inputs is already taken away: true is "active".
struct Inputs {
  std::array<bool, 4> limit_plus{}, limit_minus{};  ///< X Y Z U
  bool input_1 = false;                             ///< own line of the SM interface (HW-022)
  std::array<std::uint8_t, 2> cards{};              ///< inputs of I/O cards 1 and 2, bit 0 = line 1
  bool fault = false;  ///< the drive reports that it cannot follow: handled like a power-off
  friend bool operator==(const Inputs&, const Inputs&) = default;
};

class Machine {
 public:
  Machine() = default;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  virtual ~Machine() = default;

  /// One tick: takes the outputs, returns the inputs that hold now.
  virtual Inputs exchange(const Outputs& outputs) noexcept = 0;

  /// From the watchdog's thread, while `exchange` may hang: takes the current from the motors and switches the spindle
  /// off by whatever way still works, throws queued steps away, and keeps it so until an `exchange` with `drives_on`
  /// false was seen. The lab sends that as soon as it ticks again.
  virtual void cut() noexcept {}
};

}  // namespace cnclab::machine
