// Executes a program on paper, with Input 1 both ways.
//
//   path ──block──▶ asks for Input 1? ──▶ an answer not tried here before: a copy of the path takes it
//                   faulty?           ──▶ noted, passed over
#include <deque>
#include <set>
#include <tuple>

#include "program/check_programs.hpp"

namespace cnclab::program {

namespace {

class DryRun {
 public:
  DryRun(Interpreter first, std::uint64_t most_blocks) : blocks_left_(most_blocks) {
    paths_.push_back(std::move(first));
  }

  /// All paths by turns, so that one that loops does not use up what the others need.
  std::vector<language::Error> run() {
    constexpr int kBlocksPerTurn = 1000;
    while (!paths_.empty() && blocks_left_ > 0) {
      Interpreter path = std::move(paths_.front());
      paths_.pop_front();
      bool goes_on = true;
      for (int i = 0; i < kBlocksPerTurn && goes_on && blocks_left_ > 0; ++i) goes_on = advance(path);
      if (goes_on) paths_.push_back(std::move(path));
    }
    return std::move(errors_);
  }

 private:
  /// One block; false where the path ends.
  bool advance(Interpreter& path) {
    --blocks_left_;
    if (path.awaited_input()) answer(path);
    items_.clear();
    const auto executed = path.step(items_);
    if (executed) return !path.ended();
    if (is_new(executed.error())) errors_.push_back(executed.error());
    return path.pass_over_fault();
  }

  void answer(Interpreter& path) {
    const geometry::SourceBlock place = path.upcoming(1).front().first;
    const bool inactive_is_new = is_untried(place, false);
    const bool active_is_new = is_untried(place, true);
    if (inactive_is_new && active_is_new) {
      paths_.push_back(path);
      paths_.back().answer_input(true);
    }
    path.answer_input(active_is_new && !inactive_is_new);
  }

  bool is_untried(geometry::SourceBlock place, bool answer) {
    return tried_.emplace(place.program, place.block, answer).second;
  }
  bool is_new(const language::Error& error) { return faulty_.emplace(error.program, error.block).second; }

  std::deque<Interpreter> paths_;
  std::uint64_t blocks_left_;
  std::set<std::tuple<std::uint16_t, std::uint16_t, bool>> tried_;
  std::set<std::pair<std::uint16_t, std::uint16_t>> faulty_;
  std::vector<language::Error> errors_;
  std::vector<geometry::PathItem> items_;
};

}  // namespace

std::vector<language::Error> dry_run(const ProgramSet& programs, const Settings& settings, const Start& start,
                                     std::uint64_t most_blocks) {
  auto interpreter = Interpreter::begin(programs, settings, start);
  if (!interpreter) return {interpreter.error()};
  return DryRun(std::move(*interpreter), most_blocks).run();
}

}  // namespace cnclab::program
