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
#include <functional>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/block_form.hpp"
#include "language/error.hpp"
#include "program/modal_state.hpp"
#include "program/program_source.hpp"

namespace cnclab::program {

inline constexpr int kDeepestCall = 16;  ///< D-58

/// What execution must know of the machine and the configuration; values at START (DEC-28).
struct Settings {
  double f_max_mm_per_min = 3000;
  double s_max_rpm = 3000;
  std::array<double, 3> travel_mm{500, 500, 500};  ///< word limits MD 03..05 for values by parameter
  std::array<double, 4> steps_per_mm{200, 200, 200, 200};
  language::Vocabulary vocabulary;
  bool outputs_at_end_off = false;  ///< lab machine: the end of a program switches spindle and coolant off (DEC-38)
};

/// Where and how a run begins.
struct Start {
  std::uint16_t program = 1;
  std::uint16_t block = 1;       ///< must exist
  geometry::Point position;      ///< Istwert at START, mm
  ModalState modal;
  Parameters parameters{};
};

/// What one executed block was and left behind.
struct ExecutedBlock {
  std::uint64_t sequence = 0;      ///< running number since START, from 1
  geometry::SourceBlock source;
  int depth = 0;                   ///< 0 in the main program
  ModalState modal;                ///< after the block
  bool ended = false;              ///< the program's end was reached with this block
};

/// The state of inputs as the program may ask for them: card 0 line 0 is Input 1 (G21, G23, M16).
using InputReader = std::function<bool(int card, int line)>;

class Interpreter {
 public:
  /// errors  program_missing, block_missing
  [[nodiscard]] static std::expected<Interpreter, language::Error> begin(ProgramSet programs, Settings settings,
                                                                         const Start& start, InputReader inputs = {});

  /// Executes the next block and appends what it does to `out`; a block without effect appends a Mark, so that every
  /// block has an item that ends it. The end of the program appends End.
  ///
  /// errors   any of execution (language/error.hpp); nothing is appended, the state is that before the block
  /// after the end or an error, further calls return the same.
  [[nodiscard]] std::expected<ExecutedBlock, language::Error> step(std::vector<geometry::PathItem>& out);

  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] const ModalState& modal() const { return modal_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  /// Programmed position (Sollwert): Istwert as the operator reads it after the blocks so far, in µm; X Y Z.
  [[nodiscard]] const std::array<std::int64_t, 3>& programmed_um() const { return programmed_um_; }

  /// The blocks that come next in stored order, following unconditional G20 only (DEC-63), without executing them.
  /// The first is the block that `step` would execute.
  [[nodiscard]] std::vector<std::pair<geometry::SourceBlock, const language::Block*>> upcoming(std::size_t count) const;

 private:
  ModalState modal_;
  Parameters parameters_{};
  std::array<std::int64_t, 3> programmed_um_{};
  bool ended_ = false;
};

}  // namespace cnclab::program
