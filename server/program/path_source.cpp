// Passes each block's items through the stages.
#include "program/path_source.hpp"

#include <fmt/format.h>

namespace cnclab::program {

using geometry::StageFault;

language::Error error_of(const StageFault& fault) {
  const auto code = [&] {
    switch (fault.kind) {
      case StageFault::Kind::arc_at_entry_or_exit:
      case StageFault::Kind::inside_arc_too_small:
      case StageFault::Kind::no_intersection:
      case StageFault::Kind::runs_backwards:
      case StageFault::Kind::too_close:
        return language::ErrorCode::compensation_impossible;
      case StageFault::Kind::rounding_without_lines:
      case StageFault::Kind::rounding_too_large:
        return language::ErrorCode::compensation_impossible;
    }
    return language::ErrorCode::compensation_impossible;
  }();
  language::Error error{.code = code, .program = fault.block.program, .block = fault.block.block};
  if (fault.found_mm != 0) error.detail = fmt::format("{:.3f}", fault.found_mm);
  if (fault.needed_mm != 0) error.expected = fmt::format("{:.3f}", fault.needed_mm);
  return error;
}

std::expected<PathSource, language::Error> PathSource::begin(ProgramSet programs, Settings settings,
                                                             const Start& start) {
  auto interpreter = Interpreter::begin(std::move(programs), std::move(settings), start);
  if (!interpreter) return std::unexpected(interpreter.error());
  return PathSource(std::move(*interpreter), start);
}

PathSource::PathSource(Interpreter interpreter, const Start& start)
    : interpreter_(std::move(interpreter)), stages_(start.compensation_mm) {}

std::expected<ExecutedBlock, language::Error> PathSource::step(std::vector<geometry::PathItem>& out) {
  if (fault_) return std::unexpected(*fault_);
  programmed_.clear();
  auto executed = interpreter_.step(programmed_);
  if (auto passed = pass_on(out); !passed) return std::unexpected(passed.error());
  if (!executed || executed->ended)
    if (auto flushed = flush(out); !flushed) return std::unexpected(flushed.error());
  if (!executed) fault_ = executed.error();
  return executed;
}

std::expected<void, language::Error> PathSource::pass_on(std::vector<geometry::PathItem>& out) {
  for (const geometry::PathItem& item : programmed_) {
    if (auto pushed = stages_.push(item, out); pushed)
      continue;
    else
      fault_ = error_of(pushed.error());
    return std::unexpected(*fault_);
  }
  return {};
}

std::expected<void, language::Error> PathSource::flush(std::vector<geometry::PathItem>& out) {
  if (fault_) return std::unexpected(*fault_);
  if (auto flushed = stages_.flush(out); !flushed) {
    fault_ = error_of(flushed.error());
    return std::unexpected(*fault_);
  }
  return {};
}

}  // namespace cnclab::program
