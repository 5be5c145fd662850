// Was the part made as drawn? Each tick of a trace against the ideal curves of the drawing, in order.
//
//   1. A marker walks along the drawing and never goes back. For each tick it looks at the piece of the drawing from a
//      little behind the furthest place it came to (rounding to steps lets the projection waver) to some ticks' way at
//      F MAX ahead.
//   2. The tick's deviation in space is the distance to the nearest point of that piece; per axis it is the smallest
//      that holds for all axes at one and the same point of it.
//   3. The marker moves to the nearest point; where the drawing runs back over itself, or leaves a point in the
//   direction
//      from which it came, the earlier curve counts as long as the tick lies beside it.
//   4. From tick to tick the tool goes no further than F MAX allows. So a marker that has come to the end has passed
//   every
//      corner in order; what was cut off or left out makes the marker stay behind and the deviation grow.
#pragma once

#include <string>
#include <vector>

#include "drawing.hpp"
#include "trace.hpp"

namespace cnclab::lesson {

struct Tolerance {
  double step_mm = 0.005;          ///< MD 14 to 16: 200 steps/mm
  double noise_mm = 1e-6;          ///< six decimals in the trace
  double way_per_tick_mm = 0.051;  ///< F MAX 3000 mm/min in 1 ms, and a little for late ticks' rounding
  double length_share = 0.003;     ///< length measured along the trace against the drawing's
};

struct Comparison {
  double largest_axis_mm = 0;   ///< of all ticks, per axis
  double largest_space_mm = 0;  ///< of all ticks, in space
  double drawn_mm = 0;          ///< length of the drawing
  double reached_mm = 0;        ///< how far along the drawing the trace came
  double measured_mm = 0;       ///< length measured along the trace itself, in chords
  double seconds = 0;           ///< first to last tick
  std::string fault;            ///< empty: as drawn; else what is wrong, with time, block and place

  [[nodiscard]] bool is_as_drawn() const { return fault.empty(); }
};

enum class Expect {
  whole,  ///< the drawing from its start to its end
  part,   ///< the run was broken off: right as far as it came
};

/// trace   seen from the point where the tool stood at START
[[nodiscard]] Comparison compare(const Drawing& drawing, const std::vector<TraceRow>& trace, const Tolerance& tolerance,
                                 Expect expect = Expect::whole);

/// How long the tool rested within half a step of a point, in all.
[[nodiscard]] double rested_s(const std::vector<TraceRow>& trace, const Point& at, const Tolerance& tolerance);

}  // namespace cnclab::lesson
