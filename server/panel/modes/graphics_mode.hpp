// GRAFIK: a stored program is played without a machine and drawn (SYS-011, SYS-012, MOD-071, DEC-37).
//
//   program prompt ──→──▶ picture, stopped ──START──▶ playing ──┐
//                              ▲                                │ STOP, each block with EINZELSATZ, the end
//                              └────────────────────────────────┘
//
//   monitor rows 3 to 15: the picture; row 16: block, share done, way, time, findings
//
// The keys act while it plays, too: 1 to 4 the view, 5 and 6 closer and farther, directions move the picture, ↓ the
// next finding. The potentiometer sets the speed. Nothing moves, so this is no START state.
#pragma once

#include <optional>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/modes/graphic_test.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct GraphicsMode {
  DigitField program{4, {}, 0};
  std::optional<GraphicTest> test;  ///< once a program was acknowledged
  GraphicTestView view;             ///< the newest
  drawing::Window window;
  std::uint64_t pictures = 0;      ///< that have come so far: the screen is due with each
  bool is_stale = false;           ///< the picture is to be drawn anew: the window has changed
  bool is_step_due = false;        ///< START in EINZELSATZ: the next block is to be played
  bool is_awaited = false;         ///< what the newest key has changed is not in the picture yet
  bool is_picture_wanted = false;  ///< as files
  bool is_playing = false;         ///< between START and STOP
  bool single_block = false;       ///< off on entering, as in AUTOMAT
  std::size_t finding = 0;         ///< the one that row 18 tells at the end
};

[[nodiscard]] GraphicsMode open_graphics(const ControlState& state);
[[nodiscard]] Place place_of(const GraphicsMode& mode);
void press(GraphicsMode& mode, ControlState& state, Effect effect, int figure);
/// Takes over what the last portion has brought, and begins the next.
void follow(GraphicsMode& mode, ControlState& state);
/// The picture as files: a later `follow` leaves them in the state.
void order_picture(GraphicsMode& mode);
void draw(const GraphicsMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const GraphicsMode& mode, const ControlState& state);

}  // namespace cnclab::panel
