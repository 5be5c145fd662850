// The stream between the program and the machine: path elements, and the machine events between them.
#pragma once

#include <array>
#include <cstdint>
#include <variant>

namespace cnclab::geometry {

/// A point of the tool path in mm: the main axes X, Y, Z and the fourth axis U.
///
/// Coordinates are Istwert coordinates of the run's start: G68 (`SetActual`) renames the position for the operator but
/// the path itself never jumps (interfaces.md section 5).
struct Point {
  double x = 0, y = 0, z = 0, u = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Which block an item came from; errors, traces and screens name it.
struct SourceBlock {
  std::uint16_t program = 0;  ///< 0..9999
  std::uint16_t block = 0;    ///< 1..999
  friend bool operator==(const SourceBlock&, const SourceBlock&) = default;
};

/// The plane of arcs and radius compensation, named by its two axes (G17, G18, G19).
enum class Plane : std::uint8_t { xy, xz, yz };

/// Sense of an arc as seen against the positive third axis of its plane (D-128: for XZ, Z towards X is positive).
enum class Turn : std::uint8_t { clockwise, counterclockwise };

/// A straight way. G00 is a line too: `is_rapid` marks it for drawings and full stops, its feed is F MAX (DEC-22).
struct Line {
  Point from, to;
  double feed_mm_per_min = 0;  ///< path speed, > 0
  bool is_rapid = false;
};

/// A circular arc, or a helix when `to` also differs from `from` along the plane's third axis.
///
/// The sweep runs from `from` to `to` in the sense of `turn`; equal points in the plane are a full circle (DEC-04). The
/// radius at both ends may differ by the tolerance of D-55; it then changes linearly with the angle and the arc ends
/// exactly on `to`.
struct Arc {
  Point from, to;
  Point center;  ///< only the plane's two coordinates count
  Turn turn = Turn::clockwise;
  Plane plane = Plane::xy;
  double feed_mm_per_min = 0;  ///< path speed, > 0
};

using PathElement = std::variant<Line, Arc>;

// Machine events. All of them are plain values, so that they travel through the motion queue as they are.

struct Dwell {
  double seconds = 0;
};  ///< G04; a full stop
enum class SpindleTurn : std::uint8_t { off, clockwise, counterclockwise };
struct Spindle {
  SpindleTurn turn = SpindleTurn::off;
  double rpm = 0;
};  ///< M03 M04 M05 M12 M13 M14, S
struct Coolant {
  bool on = false;
};  ///< M08 M09 M12 M13 M14
struct ToolChange {
  int number = 0;
  double radius_mm = 0, length_mm = 0;
};  ///< T word
struct Output {
  int card = 1;
  int line = 0;
  bool on = false;
};  ///< M40..M88; line 0 = all eight
struct Wait {
  int card = 0;
  int line = 0;
};  ///< M16 M60..M98; card 0 = Input 1
/// G68: the named axes are called `value` from here on; nothing moves.
struct SetActual {
  std::array<bool, 3> axes{};
  std::array<double, 3> value{};
};
/// G69: the named axes run to their limit switches, direction = sign of `value`, which is then their Istwert.
struct Reference {
  std::array<bool, 3> axes{};
  std::array<double, 3> value{};
};
struct Halt {
  bool signal = false;
};  ///< M00, M01 (with signal)
struct Signal {};  ///< M15
struct SpindleDigits {
  int rpm = 0;
};  ///< S on I/O card 3 (FST-004)
struct End {};   ///< M02 or end of the main program
struct Mark {};  ///< a block without effect on the machine

// Orders to the stages that rewrite the path (path_stages.hpp). None leaves the last stage: a Mark takes its place.

/// Which side of the programmed contour the tool's centre keeps to (G41, G42), or by how much ways along the plane's
/// axes grow or shrink (G43, G44).
enum class OffsetSide : std::uint8_t { off, left, right, plus, minus };
struct RadiusOffset {
  OffsetSide side = OffsetSide::off;
  double radius_mm = 0;  ///< 0: no tool was called, the contour is run as it is (COMP-003)
  Plane plane = Plane::xy;
};  ///< G40..G44
struct LengthOffset {
  double length_mm = 0;     ///< added to the axis perpendicular to the plane; 0 under G45
  Plane plane = Plane::xy;  ///< XY: Z, XZ: Y, YZ: X (COMP-015)
};  ///< G45, G46
struct CornerRounding {
  double radius_mm = 0;  ///< > 0
  Plane plane = Plane::xy;
};  ///< G10: between the line before and the line behind it

using MachineEvent = std::variant<Dwell, Spindle, Coolant, ToolChange, Output, Wait, SetActual, Reference, Halt, Signal,
                                  SpindleDigits, End, Mark>;

/// One item of the stream, in the order in which the machine does it.
struct PathItem {
  SourceBlock source;
  std::uint64_t sequence = 0;  ///< running number of the executed block since START, from 1
  bool ends_block = false;     ///< last item of its block: EINZELSATZ stops behind it
  bool passes_single_block =
      false;  ///< EINZELSATZ does not stop behind this block: the next one is of a subprogram under M22 (KEY-046)
  bool is_fourth_axis = false;  ///< G12: a line of U alone
  bool exact_stop = false;      ///< G61..G66: ramp to F START/STOP, then creep (DEC-20)
  bool override_off = false;    ///< M23: the potentiometer does not act (taken as 100 %)
  std::uint8_t named_axes = 0;  ///< ways: axes that have a word in the block, X 1, Y 2, Z 4 (COMP-015, D-72)
  /// What has passed the stages: path minus programmed position of X, Y, Z behind it.
  std::array<double, 3> shift_mm{};
  std::variant<Line, Arc, Dwell, Spindle, Coolant, ToolChange, Output, Wait, SetActual, Reference, Halt, Signal,
               SpindleDigits, End, Mark, RadiusOffset, LengthOffset, CornerRounding>
      what = Mark{};
};

}  // namespace cnclab::geometry
