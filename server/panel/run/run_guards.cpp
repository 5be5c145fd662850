// What a block must pass before it moves, and the answers that it waits for.
#include <algorithm>
#include <utility>

#include "panel/run/run.hpp"

namespace cnclab::panel {

/// On the lab machine nothing follows a contour that nobody has checked as a whole (DEC-09).
void Run::guard_contours(const program::ExecutedBlock& executed) {
  if (!connection_.is_lab_machine || failure_ || source_->contours_ordered() <= sound_contours_) return;
  failure_ = language::Error{.code = language::ErrorCode::contour_unchecked,
                             .program = executed.source.program,
                             .block = executed.source.block,
                             .word = 'G'};
  std::erase_if(items_, [&executed](const auto& item) { return item.sequence >= executed.sequence; });
}

/// The training machine may come to one that START could not reach, and looks along it then.
void Run::scout_contours() {
  if (connection_.is_lab_machine || failure_) return;
  if (scout_) {
    failure_ = scout_->guard(items_);
    sound_contours_ = std::max(sound_contours_, scout_->sound_contours());
  }
  const std::size_t ordered = source_->contours_ordered();
  if (ordered <= sound_contours_)
    scout_.reset();
  else if (!scout_ || scout_->contour() < ordered)
    scout_.emplace(order_->long_work, *source_);
}

/// A block beyond the lab machine's travel does not move at all (AUTH-011): its items are dropped, those before stay.
void Run::guard_travel() {
  if (!guard_) return;
  for (const geometry::PathItem& item : items_) {
    failure_ = guard_->fault_of(item);
    if (!failure_) continue;
    const std::uint64_t sequence = item.sequence;
    std::erase_if(items_, [sequence](const auto& other) { return other.sequence >= sequence; });
    return;
  }
}

/// Behind the travel: what is left of the items then comes before its fault.
void Run::guard_tools() {
  if (auto error = tools_->guard(items_)) failure_ = std::move(error);
}

/// One wait ends in each feeding: each has its own tick in the record, and a look along a contour that takes no time in
/// a replay may have taken some here.
bool Run::may_go_on() {
  const bool must_wait = (scout_ && scout_->is_looking()) || source_->interpreter().awaited_input();
  if (!must_wait) return true;
  if (has_gone_on_) return false;
  if (questions_ == Questions::held || (scout_ && !scout_->has_looked()) || !answer_input()) return false;
  has_gone_on_ = true;
  return true;
}

/// Input 1 for G21 and G23 as it was two blocks before (D-56). A block that cannot begin because its own end depends on
/// the answer (a compensated way is held back until the next is known) begins with it: then the input counts now, as
/// before START.
bool Run::answer_input() {
  program::Interpreter& interpreter = source_->interpreter();
  const std::optional<std::uint64_t> asked = interpreter.awaited_input();
  if (!asked) return true;
  const bool is_taken_up = run_ != 0 && seen_.run == run_;
  std::optional<bool> answer = recorded_input_1_;
  if (!answer && is_taken_up) answer = machine::input_1_at_start(seen_, *asked);
  if (!answer && (*asked == 0 || (is_taken_up && is_path_done()))) answer = seen_.input_1;
  if (answer) take_answer(*answer);
  return answer.has_value();
}

void Run::take_answer(bool input_1) {
  last_answer_ = input_1;
  source_->interpreter().answer_input(input_1);
  if (scout_) scout_->take_answer(input_1);
}

}  // namespace cnclab::panel
