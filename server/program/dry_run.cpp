// Executes a program on paper, with Input 1 both ways, and follows its contours.
//
//   course ──block──▶ asks for Input 1? ──▶ an answer not tried here before: a copy of the course takes it
//                     faulty?           ──▶ noted, passed over
//                     its items         ──▶ stages ──▶ a contour that cannot be followed, or cuts into itself: noted
#include <deque>
#include <set>
#include <tuple>

#include "geometry/contour_check.hpp"
#include "program/check_programs.hpp"
#include "program/path_source.hpp"

namespace cnclab::program {

namespace {

/// One way through the program.
struct Course {
  explicit Course(Interpreter first) : interpreter(std::move(first)) {}

  Interpreter interpreter;
  geometry::PathStages stages;
  geometry::ContourCheck contours;
  std::size_t findings_seen = 0;
};

class DryRun {
 public:
  DryRun(Interpreter first, std::uint64_t most_blocks) : blocks_left_(most_blocks) {
    courses_.emplace_back(std::move(first));
  }

  /// All courses by turns, so that one that loops does not use up what the others need.
  std::vector<language::Error> run() {
    constexpr int kBlocksPerTurn = 1000;
    while (!courses_.empty() && blocks_left_ > 0) {
      Course course = std::move(courses_.front());
      courses_.pop_front();
      bool goes_on = true;
      for (int i = 0; i < kBlocksPerTurn && goes_on && blocks_left_ > 0; ++i) goes_on = advance(course);
      if (goes_on) courses_.push_back(std::move(course));
    }
    return std::move(errors_);
  }

 private:
  /// One block; false where the course ends.
  bool advance(Course& course) {
    --blocks_left_;
    Interpreter& interpreter = course.interpreter;
    if (interpreter.awaited_input()) answer(course);
    items_.clear();
    const auto executed = interpreter.step(items_);
    follow(course);
    if (executed && !interpreter.ended()) return true;
    end_contour(course);
    if (executed) return false;
    note(executed.error());
    return interpreter.pass_over_fault();
  }

  /// Takes the block's items through the stages. Behind a contour that cannot be followed the next one is begun anew.
  void follow(Course& course) {
    for (const geometry::PathItem& item : items_) {
      const auto pushed = course.stages.push(item, path_, &course.contours);
      path_.clear();
      if (pushed) continue;
      note(error_of(pushed.error()));
      course.stages = geometry::PathStages{};
    }
    note_findings(course);
  }

  /// Nothing follows, or nobody knows from where: the path behind a faulty block begins elsewhere.
  void end_contour(Course& course) {
    const auto flushed = course.stages.flush(path_, &course.contours);
    path_.clear();
    if (!flushed) note(error_of(flushed.error()));
    note_findings(course);
    course.stages = geometry::PathStages{};
  }

  void note_findings(Course& course) {
    const auto& findings = course.contours.findings();
    for (; course.findings_seen < findings.size(); ++course.findings_seen)
      note(error_of(findings[course.findings_seen]));
  }

  void note(language::Error error) {
    if (is_new(error)) errors_.push_back(std::move(error));
  }

  void answer(Course& course) {
    const geometry::SourceBlock place = course.interpreter.upcoming(1).front().first;
    const bool inactive_is_new = is_untried(place, false);
    const bool active_is_new = is_untried(place, true);
    if (inactive_is_new && active_is_new) {
      courses_.push_back(course);
      courses_.back().interpreter.answer_input(true);
    }
    course.interpreter.answer_input(active_is_new && !inactive_is_new);
  }

  bool is_untried(geometry::SourceBlock place, bool answer) {
    return tried_.emplace(place.program, place.block, answer).second;
  }
  bool is_new(const language::Error& error) { return faulty_.emplace(error.program, error.block).second; }

  std::deque<Course> courses_;
  std::uint64_t blocks_left_;
  std::set<std::tuple<std::uint16_t, std::uint16_t, bool>> tried_;
  std::set<std::pair<std::uint16_t, std::uint16_t>> faulty_;
  std::vector<language::Error> errors_;
  std::vector<geometry::PathItem> items_, path_;  ///< of the newest block; finished, and of no further use
};

}  // namespace

std::vector<language::Error> dry_run(const ProgramSet& programs, const Settings& settings, const Start& start,
                                     std::uint64_t most_blocks) {
  auto interpreter = Interpreter::begin(programs, settings, start);
  if (!interpreter) return {interpreter.error()};
  return DryRun(std::move(*interpreter), most_blocks).run();
}

}  // namespace cnclab::program
