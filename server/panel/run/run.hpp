// One run of a program: from START until its end, abandonment or an error.
//
//   ProgramSet ──▶ Preflight                                  contours are checked as a whole, then it starts (DEC-09)
//   ProgramSet ──▶ PathSource ──▶ Planner ──▶ Channel         the source runs ahead of the machine by some seconds
//                      └─ RunRecord per block ─┐
//   Channel::snapshot ── sequence ─────────────┴──▶ which block, which modal state the operator sees
//
// A run owns everything that decided its course at START (DEC-28). It is fed in small portions (`poll`), so a jump loop
// without motion never holds up the lab (DEC-63).
#pragma once

#include <cstdint>
#include <deque>
#include <expected>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/error.hpp"
#include "machine/channel.hpp"
#include "panel/connection.hpp"
#include "panel/run/contour_scout.hpp"
#include "panel/run/long_work.hpp"
#include "panel/run/offset_record.hpp"
#include "panel/run/preflight.hpp"
#include "panel/run/tool_guard.hpp"
#include "panel/run/travel_guard.hpp"
#include "program/path_source.hpp"

namespace cnclab::panel {

/// What a run is begun with; all of it values (DEC-28).
struct RunOrder {
  program::ProgramSet programs;
  program::Start start;  ///< its position is the machine's Istwert
  machine::MachineData data;
  language::Vocabulary vocabulary;
  std::array<bool, 3> io_cards{true, true, true};  ///< which are fitted (D-124)
  bool rests_accumulate = false;                   ///< as the original (D-115)
  LongWork long_work = do_at_once;                 ///< who checks the contours
  bool is_single_function = false;  ///< HANDEINGABE: its end is no end of a program, spindle and coolant stay (DEC-38)
  /// Where X, Y, Z stand from the middle of their travel, on a machine that knows: then its travel is guarded
  /// (AUTH-011). Filled by `Run::begin`.
  std::optional<std::array<double, 3>> machine_mm{};
  std::optional<machine::ToolList> tools{};  ///< of the machine, with what is in the spindle (DEC-29); nothing: any may
};

/// What a run leaves to the next one, of whatever mode, when it ends at this moment: the state of the block really
/// executed, not of the one read ahead. Compensation that is in force stays so; the offset in which the tool stands
/// goes with it, so that it is neither entered twice nor lost (MOD-026, D-39, D-75).
struct Legacy {
  program::ModalState modal;
  program::Parameters parameters{};
  std::array<double, 3> compensation_mm{};  ///< Istwert minus Sollwert
};

struct RunEnd {
  enum class Kind : std::uint8_t { program_end, failed, broken, refused };
  Kind kind{};
  machine::StopCause cause = machine::StopCause::none;
  std::optional<language::Error> error;  ///< Kind::failed
  Legacy legacy;
};

/// What execution must know of the machine and the configuration.
[[nodiscard]] program::Settings interpreter_settings(const machine::MachineData& data,
                                                     const language::Vocabulary& vocabulary);

class Run {
 public:
  enum class State : std::uint8_t {
    none,
    running,
    waiting,  ///< programmed halt, or waiting for an input: START goes on (KEY-013)
    braking,  ///< also while an axis is driven off its switch (ERR-020): the run is over when it stands
    stopped,  ///< after STOP: START drives the rest
    between,  ///< EINZELSATZ: the next block waits for START
  };

  /// Begins with the first block of the order; it moves as soon as its contours are checked and the machine has taken
  /// it up.
  /// errors   what the first block or the program as a whole has wrong; nothing was started. What the check finds later
  ///          is told by `poll` as a failed run
  /// A machine that takes no command at all (its ring is full) is told by `poll` as a refused start.
  [[nodiscard]] std::expected<void, language::Error> begin(const Connection& connection, RunOrder order);

  void go_on();  ///< START in any state but `none`
  void stop();   ///< STOP: on the ramp, the rest is kept
  /// Forgets the run; the machine must stand still. Returns the state of the block really executed.
  std::optional<RunEnd> abandon();

  /// Feeds the path and follows the machine; returns how the run ended when it did.
  std::optional<RunEnd> poll();
  /// Whether feeding may answer a question for Input 1, or take what the look along a contour has found.
  enum class Questions : std::uint8_t { answered, held };
  /// As `poll`, but ends nothing, and feeds all that there is: for a replay, whose stops come from its record, and the
  /// ticks in which it goes on too.
  /// input_1   as the record answers the next question; nothing: as the machine does
  void feed_replay(Questions questions, std::optional<bool> input_1 = std::nullopt);

  /// The newest feeding, or the beginning, has ended a wait.
  [[nodiscard]] bool has_gone_on() const { return has_gone_on_; }

  [[nodiscard]] State state() const;
  [[nodiscard]] bool is_present() const { return source_.has_value(); }
  /// An axis ran onto its switch and is being driven free: nothing else moves until it stands.
  [[nodiscard]] bool is_backing_off() const;
  /// START was given and the machine has not answered: what the screen would show is not known before.
  [[nodiscard]] bool awaits_answer() const { return is_present() && !is_checking() && seen_.tick < answer_tick_; }
  /// The block on top of the window: the one being done, or the next where it waits for START.
  [[nodiscard]] geometry::SourceBlock shown_block() const;
  [[nodiscard]] bool shows_blocks() const;          ///< false under M21, and in subprograms under M22
  [[nodiscard]] bool ignores_single_block() const;  ///< in subprograms under M22 (KEY-046)
  [[nodiscard]] program::ModalState modal() const;
  /// What the next run would begin with if this one ended now.
  [[nodiscard]] Legacy legacy() const;
  [[nodiscard]] const program::ProgramSet& programs() const { return order_->programs; }
  /// What it was begun with; nullptr where none is present, or nothing has been started because its contours are still
  /// being checked. Another run has another one.
  [[nodiscard]] std::shared_ptr<const RunOrder> order() const { return is_checking() ? nullptr : order_; }
  [[nodiscard]] bool sounds_alarm() const;  ///< M01 waits for START
  /// The tool that is to be put in before START goes on (DEC-29); 0: none.
  [[nodiscard]] int tool_due() const;

 private:
  /// A block that was executed ahead of the machine.
  struct Record {
    program::ExecutedBlock block;
    std::shared_ptr<const program::Parameters> parameters;  ///< after the block; shared while unchanged
    bool has_alarm = false;
    double path_s = 0;  ///< time of the path up to the end of what has come of it, at programmed speed, from START
  };

  [[nodiscard]] bool is_checking() const { return preflight_.has_value(); }
  std::expected<void, language::Error> conclude_check(const Preflight::Result& result);
  std::expected<void, language::Error> launch();
  /// Executes the next block; false while it must wait for Input 1.
  bool prepare_block();
  void account_for_items();
  void guard_contours(const program::ExecutedBlock& executed);
  void scout_contours();
  /// Nothing has to be waited for, or all of it has come now.
  [[nodiscard]] bool may_go_on();
  [[nodiscard]] bool answer_input();
  void take_answer(bool input_1);
  void guard_travel();
  void guard_tools();
  /// One portion of the path, behind one wait at most. True where there may be more of it at once.
  bool feed(Questions questions = Questions::answered);
  void forget_done_blocks();
  [[nodiscard]] bool is_far_enough_ahead() const;
  [[nodiscard]] const Record* record(std::uint64_t sequence) const;
  /// Where EINZELSATZ rests between two blocks: the one that waits for START; nullptr where that cannot be executed.
  [[nodiscard]] const Record* next_record() const;
  [[nodiscard]] const program::Parameters& parameters() const;
  [[nodiscard]] std::array<double, 3> compensation_mm() const;
  [[nodiscard]] bool is_path_done() const;
  RunEnd finish(RunEnd::Kind kind);
  std::optional<RunEnd> poll_check();
  void look();
  void go();

  Connection connection_;
  machine::Snapshot seen_;
  std::uint64_t run_ = 0;             ///< the channel's number of this run
  std::uint64_t answer_tick_ = 0;     ///< from this tick on the snapshot knows of the last command
  std::uint64_t refused_before_ = 0;  ///< commands that had not been taken when START was pressed

  std::shared_ptr<const RunOrder> order_;
  std::optional<Preflight> preflight_;  ///< while contours are being checked; nothing has been started then
  std::size_t sound_contours_ = 0;      ///< so many contours, in their order, were found right
  std::optional<ContourScout> scout_;   ///< of the contour that the run has come to without
  bool is_stopped_in_check_ = false;
  Questions questions_ = Questions::answered;
  std::optional<bool> recorded_input_1_;  ///< of a replay
  bool last_answer_ = false;
  bool has_gone_on_ = false;  ///< in this feeding: what had been waited for has come
  std::optional<program::PathSource> source_;
  std::array<double, 4> steps_per_mm_{};
  std::optional<TravelGuard> guard_;
  std::optional<ToolGuard> tools_;
  std::optional<OffsetRecord> offsets_;
  std::vector<geometry::PathItem> items_;  ///< the newest finished ones, from `next_item_` still to be appended
  std::size_t next_item_ = 0;
  std::deque<Record> records_;
  std::shared_ptr<const program::Parameters> first_parameters_, parameters_;
  std::optional<language::Error> failure_;  ///< of the block after the last record
  double path_s_ = 0;                       ///< of all items so far
  double look_ahead_s_ = 0;
};

}  // namespace cnclab::panel
