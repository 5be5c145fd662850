// One block while it is being executed: what a function may read, and where it leaves what it does.
#pragma once

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "program/interpreter.hpp"

namespace cnclab::program {

/// Where execution goes on after the block.
struct Flow {
  enum class Kind : std::uint8_t { next, jump, call, end };
  Kind kind = Kind::next;
  const language::Program* program = nullptr;  ///< jump, call: target
  std::size_t index = 0;                       ///< jump, call: index of the target block
  int repeats = 0;                             ///< call: how often again after the first time
};

/// The bench on which a function works. It changes `state`, appends to `out` and sets `flow`; the interpreter keeps
/// all of that only if the whole block succeeds, so a function may return an error at any point. Parameters and result
/// register are not copied for that: who changes them has checked everything before.
struct BlockRun {
  const language::Block& block;  ///< parameters already replaced by their values
  geometry::SourceBlock source;
  std::uint64_t sequence = 0;
  bool override_off = false;  ///< as PathItem has it
  const Settings& settings;
  const ProgramSet& programs;
  std::span<const Frame> levels;  ///< active calls; the last one runs
  bool exact_stop = false;        ///< its ways end with an exact stop
  bool input_is_active = false;   ///< Input 1 as it was two blocks before (D-56)
  ExecutionState& state;
  Parameters& parameters;  ///< #64..#68 are read by `parameter_value`; changed only when nothing can fail any more
  ResultFlags& result;
  std::vector<geometry::PathItem>& out;
  Flow flow = {};

  /// Appends an event of this block, or a way of the fourth axis.
  template <typename What>
  void emit(const What& what) {
    out.push_back({.source = source, .sequence = sequence, .override_off = override_off, .what = what});
  }
  /// Appends a way of the main axes.
  template <typename Element>
  void emit_way(const Element& element, AxisSet named_axes) {
    emit(element);
    out.back().named_axes = named_axes;
    out.back().exact_stop = exact_stop;
  }
};

using Outcome = std::expected<void, language::Error>;

/// An error of a block, ready to be returned. `word` is the address to blame, 0 for the block as a whole.
[[nodiscard]] std::unexpected<language::Error> error_at(language::ErrorCode code, geometry::SourceBlock source,
                                                        char word, std::string detail = {}, std::string expected = {});

/// F above F MAX (DEC-13): names the value and the limit.
[[nodiscard]] std::unexpected<language::Error> feed_above_limit(geometry::SourceBlock source, std::int64_t feed,
                                                                const Settings& settings);

/// What a function does, besides its F, S, T and M words, which every block handles alike.
using Handler = Outcome (*)(BlockRun&);

// Straight ways (execute_line.cpp).
Outcome execute_rapid(BlockRun& run);        // G00
Outcome execute_line(BlockRun& run);         // G01
Outcome execute_fourth_axis(BlockRun& run);  // G12

// Arcs (execute_arc.cpp).
Outcome execute_clockwise_arc(BlockRun& run);               // G02
Outcome execute_counterclockwise_arc(BlockRun& run);        // G03
Outcome execute_clockwise_by_radius(BlockRun& run);         // G05
Outcome execute_counterclockwise_by_radius(BlockRun& run);  // G06
Outcome execute_clockwise_helix(BlockRun& run);             // G07
Outcome execute_counterclockwise_helix(BlockRun& run);      // G08
Outcome round_corner(BlockRun& run);                        // G10

// Compensation (execute_compensation.cpp).
Outcome cancel_radius_compensation(BlockRun& run);  // G40
Outcome compensate_left(BlockRun& run);             // G41
Outcome compensate_right(BlockRun& run);            // G42
Outcome lengthen_ways(BlockRun& run);               // G43
Outcome shorten_ways(BlockRun& run);                // G44
Outcome cancel_length_compensation(BlockRun& run);  // G45
Outcome compensate_length(BlockRun& run);           // G46

// Modal groups (execute_modal.cpp).
Outcome select_plane_xy(BlockRun& run);     // G17
Outcome select_plane_xz(BlockRun& run);     // G18
Outcome select_plane_yz(BlockRun& run);     // G19
Outcome cancel_scale(BlockRun& run);        // G74
Outcome set_scale(BlockRun& run);           // G75
Outcome select_absolute(BlockRun& run);     // G90
Outcome select_incremental(BlockRun& run);  // G91

// Order of execution (execute_flow.cpp).
Outcome jump(BlockRun& run);           // G20
Outcome jump_on_input(BlockRun& run);  // G21
Outcome call(BlockRun& run);           // G22
Outcome call_on_input(BlockRun& run);  // G23

// Parametric functions (execute_parametric.cpp).
Outcome assign_value(BlockRun& run);    // ↓00
Outcome calculate(BlockRun& run);       // ↓01..↓04, ↓10..↓17
Outcome jump_on_result(BlockRun& run);  // ↓50..↓54

// Machining cycles (execute_cycle.cpp).
Outcome execute_cycle(BlockRun& run);  // G81..G86

// Events (execute_events.cpp).
Outcome dwell(BlockRun& run);            // G04
Outcome only_words(BlockRun& run);       // G11
Outcome set_actual(BlockRun& run);       // G68
Outcome search_switches(BlockRun& run);  // G69

/// G61 to G66: the same function with an exact stop at the end of its way (G-610, DEC-20).
template <Handler function>
Outcome with_exact_stop(BlockRun& run) {
  run.exact_stop = true;
  return function(run);
}

/// A block that needs the data of the tool must not run where their row in P0000 is damaged (ERR-010, STO-003).
/// errors  checksum_wrong: the block, with the row in its detail
[[nodiscard]] Outcome check_tool_row(const ProgramSet& programs, int tool, geometry::SourceBlock source);

/// F, S and T act at block start (FST-009, FST-011).
/// errors  checksum_wrong: T calls a tool whose row is damaged
Outcome execute_feed_speed_tool(BlockRun& run);

/// M03, M04, M08, M13, M14 act at block start, all others at block end (M-900).
enum class Moment : std::uint8_t { block_start, block_end };
void execute_m(BlockRun& run, Moment moment);

}  // namespace cnclab::program
