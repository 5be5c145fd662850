// The 24×80 screen around the original's monitor: frame, header, side column, sentence and keys (DEC-01).
//
//   rows 0..17, columns 0..65   frame, monitor in rows 1..16, columns 1..64
//   rows 0..17, columns 66..79  the lab's column
//   row 18                      what the control waits for or what was wrong (row 19 too where it is long); below who
//                               bars the keyboard, where somebody does
//   rows 19..23                 the keys that work now
#pragma once

#include <functional>
#include <string>

#include "panel/control.hpp"
#include "panel/key_table.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct Lamps {
  bool start = false, single_block = false, coolant = false, limit = false, is_referenced = true;
  geometry::SpindleTurn spindle = geometry::SpindleTurn::off;
};

void draw_frame(Canvas& canvas);
/// Model, title, clock, free memory (SCR-001 to SCR-006).
void draw_header(Monitor& monitor, Mode mode, const Settings& settings, const WallClock& clock, int free_bytes);
void draw_side(Canvas& canvas, const SideView& side, const Lamps& lamps, language::Tongue tongue);

/// What rows 18 to 23 say.
struct BottomView {
  std::string bar;                         ///< who bars the keyboard: above the sentence; empty if nobody
  std::string sentence;                    ///< what the control waits for or what was wrong
  std::function<bool(Effect, Key)> lists;  ///< which keys are listed with their effects
};
void draw_bottom(Canvas& canvas, const BottomView& view, Place place, const Settings& settings);

}  // namespace cnclab::panel
