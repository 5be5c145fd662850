// What stands at the connectors of the original: levels instead of meanings (HW-001 to HW-023, M-904, MD-119).
//
//   SM interface       all signals low active (HW-006)
//   I/O cards 1, 2     outputs low active, they pull to ground; inputs high active, 24 V (M-904)
//   I/O card 3         the four decimal digits of S, units first (FST-004)
//   limit switches     one line per axis (HW-008); MD 19 says which level means "damped"
//
// For drivers of real electronics. The lab itself deals in meanings: `Outputs` and `Inputs` of machine.hpp.
#pragma once

#include <array>
#include <cstdint>

#include "machine/machine.hpp"

namespace cnclab::machine {

/// true = high.
struct OutputLevels {
  bool no_current = true;  ///< Stromnullung
  bool coolant = true;
  bool spindle_on = true;
  bool spindle_left = true;  ///< Links/Rechts: low = counterclockwise
  bool start = true;
  std::array<std::uint8_t, 2> cards{0xFF, 0xFF};  ///< bit 0 = line 1
};

struct InputLevels {
  bool input_1 = true;
  std::array<std::uint8_t, 2> cards{};
  std::array<bool, 4> limit_lines{true, true, true, true};  ///< X Y Z U
};

[[nodiscard]] OutputLevels levels_of(const Outputs& outputs);

/// The digits of `Outputs::s_digits` in the order in which card 3 gives them out: units, tens, hundreds, thousands.
[[nodiscard]] std::array<std::uint8_t, 4> digits_of_s(std::int32_t rpm);

/// MD 19: 201 = a damped switch gives 0 V, 51503 = it gives 24 V.
enum class SwitchPolarity : std::uint8_t { damped_is_low, damped_is_high };
[[nodiscard]] SwitchPolarity switch_polarity(std::int64_t endschalter_pol);
[[nodiscard]] bool is_damped(bool is_high, SwitchPolarity polarity);

/// Levels into meanings. One line per axis does not tell which end of the travel it is: that is the side towards which
/// the axis moved when the line became active, kept until it is free again. An axis that stands on a switch before it
/// has ever moved is reported on both, so that nothing drives it further in.
class InputReader {
 public:
  explicit InputReader(SwitchPolarity polarity) : polarity_(polarity) {}

  /// Once per tick. steps   what was sent in this tick
  [[nodiscard]] Inputs read(const InputLevels& levels, const motion::AxisSteps& steps) noexcept;

 private:
  enum class Side : std::uint8_t { none, plus, minus, unknown };

  SwitchPolarity polarity_;
  std::array<std::int8_t, 4> last_direction_{};
  std::array<Side, 4> side_{};
};

}  // namespace cnclab::machine
