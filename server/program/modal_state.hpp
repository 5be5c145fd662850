// What stays in force from block to block (MOD-003, FST-013): the status line of the screens shows it.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/path_item.hpp"
#include "language/units.hpp"
#include "program/fixed_point.hpp"

namespace cnclab::program {

enum class RadiusCompensation : std::uint8_t { off, left, right, plus, minus };  ///< G40 G41 G42 G43 G44
enum class Dimension : std::uint8_t { incremental, absolute };                   ///< G91 G90

/// Power-on values: G17 G40 G45 G74 G91 F0000 S0000 T00 M12 (SCR-031), M20.
struct ModalState {
  geometry::Plane plane = geometry::Plane::xy;
  RadiusCompensation radius = RadiusCompensation::off;
  bool length_compensation = false;  ///< G46
  /// Of the tool that was active at G41 to G44, G46: a later T acts with the next of them (D-74). 0 while off.
  language::Micrometres tool_radius, tool_length;
  bool scale_on = false;  ///< G75
  /// Factors of X, Y, Z in 1/1000; 1000 is 1 (G-754).
  std::array<std::int64_t, 3> scale{1000, 1000, 1000};
  Dimension dimension = Dimension::incremental;
  int feed_mm_per_min = 0;
  int spindle_rpm = 0;
  int tool = 0;
  int m = 12;  ///< the M shown in the status line: the last executed one
  geometry::SpindleTurn spindle = geometry::SpindleTurn::off;
  bool coolant = false;
  bool blocks_hidden = false;             ///< M21
  bool subprogram_blocks_hidden = false;  ///< M22
  bool potentiometer_off = false;         ///< M23
  bool test_run = false;                  ///< M24
  friend bool operator==(const ModalState&, const ModalState&) = default;
};

/// The result register of parametric functions (D-92).
struct ResultFlags {
  bool zero = false, positive = false, negative = false, carry = false;
  friend bool operator==(const ResultFlags&, const ResultFlags&) = default;
};

/// Parameters #00..#69 in 1/1 000 000 mm (DEC-52). #64..#68 are read from the state, not from here.
using Parameters = std::array<std::int64_t, 70>;

}  // namespace cnclab::program
