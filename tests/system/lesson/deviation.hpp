// Was the part made as drawn? Each tick of a trace against the ideal curves of the drawing, in order.
//
//   1. A marker walks along the drawing. For each tick it looks for the nearest point of the drawing from a little
//      behind the marker (rounding to steps lets the projection waver) to as far ahead as one tick at F MAX can lead.
//   2. The tick's deviation in space is the distance to that point; per axis it is the smallest that holds for all axes
//      at one and the same point of the drawing near it.
//   3. Where the drawing runs back over itself both ways are equally near: the earlier one counts.
//   4. Since the marker moves at most one tick's way at a time, a marker that has come to the end has passed every
//      corner in order; what was cut off or left out makes the marker stay behind and the deviation grow.
#pragma once

#include <string>
#include <vector>

#include "drawing.hpp"
#include "trace.hpp"

namespace cnclab::lesson {

struct Tolerance {
  double step_mm = 0.005;            ///< MD 14 to 16: 200 steps/mm
  double noise_mm = 1e-6;            ///< six decimals in the trace
  double way_per_tick_mm = 0.051;    ///< F MAX 3000 mm/min in 1 ms, and a little for late ticks' rounding
  double length_share = 0.003;       ///< length measured along the trace against the drawing's
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

}  // namespace cnclab::lesson
