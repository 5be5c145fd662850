// Executes blocks: modal state, jumps and calls in, path elements and machine events out.
//
//   ProgramSet ──blocks──▶ Interpreter ──PathItem──▶ geometry stages ──▶ motion
//
// One call of `step` executes one block. The interpreter runs ahead of the machine; who runs it keeps, per executed
// block, the state to come back to (`ExecutedBlock`), since a run may be abandoned in the middle.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/block_form.hpp"
#include "language/error.hpp"
#include "program/checked_blocks.hpp"
#include "program/modal_state.hpp"
#include "program/program_source.hpp"

namespace cnclab::program {

inline constexpr int kDeepestCall = 16;  ///< D-58

/// X, Y, Z in nanometres. Ways are µm × factor in 1/1000 (G75), so every position is a whole number of nm and no sum
/// ever rounds (DEC-05).
using Nanometres = std::array<std::int64_t, 3>;

/// Some of the axes X 1, Y 2, Z 4.
using AxisSet = std::uint8_t;

/// What execution must know of the machine and the configuration; values at START (DEC-28).
struct Settings {
  double f_max_mm_per_min = 3000;
  double s_max_rpm = 3000;
  std::array<double, 3> travel_mm{500, 500, 500};  ///< word limits MD 03..05 for values by parameter
  std::array<double, 4> steps_per_mm{200, 200, 200, 200};
  language::Vocabulary vocabulary{};
  std::array<bool, 3> io_cards{true, true, true};  ///< which of the I/O cards 1, 2, 3 are fitted (D-124)
  bool rests_accumulate = false;    ///< incremental ways as whole steps, block by block, as the original (D-115)
  bool outputs_at_end_off = false;  ///< lab machine: the end of a program switches spindle and coolant off (DEC-38)
};

/// Where and how a run begins.
struct Start {
  std::uint16_t program = 1;
  std::uint16_t block = 1;     ///< must exist
  geometry::Point position{};  ///< Istwert at START, mm
  ModalState modal{};
  Parameters parameters{};
  std::array<double, 3> compensation_mm{};  ///< Istwert minus Sollwert of X Y Z: what compensation has left (D-75)
};

/// What one executed block was and left behind.
struct ExecutedBlock {
  std::uint64_t sequence = 0;  ///< running number since START, from 1
  geometry::SourceBlock source;
  int depth = 0;                   ///< 0 in the main program
  std::uint16_t main_program = 0;  ///< the program at depth 0 that runs now, or that called the one that runs
  bool is_shown = true;            ///< false under M21, and in subprograms under M22 (MOD-059, MOD-060)
  ModalState modal;                ///< after the block
  std::array<std::int64_t, 3> programmed_um{};  ///< Sollwert X Y Z after the block
  bool ended = false;                           ///< the program's end was reached with this block
};

/// What a block works on; copied before each block, so that a block that fails leaves nothing behind.
struct ExecutionState {
  ModalState modal;
  Nanometres programmed_nm{};       ///< Sollwert as the operator reads it
  Nanometres offset_nm{};           ///< path coordinate minus Sollwert: what G68 has renamed since START
  std::int64_t fourth_axis_nm = 0;  ///< U, path coordinate (G12; no Istwert of its own, D-62)
  /// X, Y, Z in µm as the running ROM program would have them without scale factors (DEC-51); set by each cycle,
  /// without meaning outside.
  std::array<std::int64_t, 3> unscaled_um{};
  geometry::Point path;  ///< end of the path so far; an axis that does not move keeps its value to the last bit
  /// Axes whose path may lie beside this one, because compensation has moved them and they have yet to be led back:
  /// each with a way of its own (G43, G44, G46), or both of a plane together (G41, G42).
  AxisSet shifted_axes = 0, contour_axes = 0;
};

/// One level of calls: level 0 is the main program.
struct Frame {
  const language::Program* program = nullptr;  ///< what runs at this level now (G20 may change it)
  std::size_t next = 0;                        ///< index of its next block
  const language::Program* called = nullptr;   ///< what was called here, and where it is repeated from
  std::size_t entry = 0;
  int repeats_left = 0;  ///< W: how often it still runs again (D-57)
};

struct BlockRun;  // block_run.hpp: for the functions of this folder only
struct Flow;

class Interpreter {
 public:
  /// errors  program_missing, block_missing, reserved_for_cycles; function_unknown names the first block that can be
  ///         reached and that this control cannot execute, so that nothing moves before it is known
  [[nodiscard]] static std::expected<Interpreter, language::Error> begin(ProgramSet programs, Settings settings,
                                                                         const Start& start);

  /// The sequence of the block at whose start Input 1 counts for the next block (G21, G23: two blocks before; 0: at
  /// START; G-211, D-56). Nothing where the next block does not ask, or has its answer.
  [[nodiscard]] std::optional<std::uint64_t> awaited_input() const;
  /// Answers `awaited_input`. A block that asks and has no answer takes Input 1 as inactive.
  void answer_input(bool is_active);

  /// Executes the next block and appends what it does to `out`; a block without effect appends a Mark, so that every
  /// block has an item that ends it. The end of the program appends End.
  ///
  /// errors   any of execution (language/error.hpp); nothing is appended, the state is that before the block
  /// after the end or an error, further calls return the same.
  [[nodiscard]] std::expected<ExecutedBlock, language::Error> step(std::vector<geometry::PathItem>& out);

  /// For checks: goes on behind the block at which `step` failed, as if it had been right: its F, S, T and M act, its
  /// axes are at the end of its way, and an F that was missing is there. False where nothing follows, or nobody knows
  /// what (a jump that leads nowhere).
  bool pass_over_fault();

  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] const ModalState& modal() const { return state_.modal; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  /// Programmed position (Sollwert): Istwert as the operator reads it after the blocks so far, in µm; X Y Z.
  [[nodiscard]] std::array<std::int64_t, 3> programmed_um() const;

  /// The blocks that come next in stored order, following unconditional G20 only (DEC-63), without executing them.
  /// The first is the block that `step` would execute.
  [[nodiscard]] std::vector<std::pair<geometry::SourceBlock, const language::Block*>> upcoming(std::size_t count) const;

 private:
  Interpreter(ProgramSet programs, Settings settings, const Start& start);

  std::expected<ExecutedBlock, language::Error> execute_block(std::vector<geometry::PathItem>& out);
  /// The checks before a block acts; the block with its parameters read, or nothing where it has none.
  std::expected<std::optional<language::Block>, language::Error> prepare(const Frame& level);
  /// Is the next block one of a subprogram under M22 (MOD-060)?
  [[nodiscard]] bool is_in_hidden_subprogram() const;
  /// Moves on to the next block to execute; true when there is none.
  bool go_on(const Flow& flow);
  /// Leaves finished subprograms or runs them again (W); true when the main program has no further block.
  bool leave_finished_levels();
  void append_end(BlockRun& run);
  /// The bench for the block that comes next; `block` may be that with its parameters read.
  BlockRun bench_for(const language::Block& block, std::vector<geometry::PathItem>& out);

  ProgramSet programs_;
  Settings settings_;
  std::optional<bool> input_answer_;  ///< for the next block
  Parameters parameters_{};
  ResultFlags result_;  ///< all cleared at START (D-92)
  ExecutionState state_;
  CheckedBlocks checked_;
  std::vector<Frame> levels_;
  std::uint64_t sequence_ = 0;
  bool ended_ = false;
  /// The result that every further call repeats.
  std::optional<std::expected<ExecutedBlock, language::Error>> last_;
};

}  // namespace cnclab::program
