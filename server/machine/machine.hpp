// The seam to the iron: what goes out to a machine and what comes back, once per tick.
//
// A driver implements `Machine` and nothing else. It is called from the tick thread, 1000 times a second, and must
// return within some microseconds: no allocation, lock, log or system call that can wait.
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
  bool start = false;         ///< external signal Start
  geometry::SpindleTurn spindle = geometry::SpindleTurn::off;
  std::int32_t spindle_rpm = 0;
  bool coolant = false;
  bool signal = false;                  ///< acoustic signal, one tick per tone (M01, M15)
  std::array<std::uint8_t, 2> cards{};  ///< outputs of I/O cards 1 and 2, bit 0 = line 1, 1 = active
  std::int32_t s_digits = 0;            ///< I/O card 3
};

/// Signals from the machine. Polarity of switches and inputs is already taken away: true is "active".
struct Inputs {
  std::array<bool, 4> limit_plus{}, limit_minus{};  ///< X Y Z U
  bool input_1 = false;
  std::array<std::uint8_t, 2> cards{};
  bool fault = false;  ///< the drive reports that it cannot follow: handled like a power-off
};

class Machine {
 public:
  Machine() = default;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  virtual ~Machine() = default;

  /// One tick: takes the outputs, returns the inputs that hold now.
  virtual Inputs exchange(const Outputs& outputs) noexcept = 0;
};

}  // namespace cnclab::machine
