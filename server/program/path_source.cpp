// Passes each block's items through the stages.
#include "program/path_source.hpp"

#include <fmt/format.h>

namespace cnclab::program {

using geometry::StageFault;

namespace {

language::ErrorCode code_of(const StageFault& fault) {
  using language::ErrorCode;
  switch (fault.kind) {
    case StageFault::Kind::arc_at_entry_or_exit:
      return ErrorCode::arc_at_entry_or_exit;
    case StageFault::Kind::arc_under_axis_offset:
      return ErrorCode::arc_under_axis_offset;
    case StageFault::Kind::inside_arc_too_small:
      return ErrorCode::inside_arc_too_small;
    case StageFault::Kind::no_intersection:
      return ErrorCode::no_intersection;
    case StageFault::Kind::runs_backwards:
      return ErrorCode::runs_backwards;
    case StageFault::Kind::too_close:
      return ErrorCode::too_close;
    case StageFault::Kind::entry_too_close:
      return ErrorCode::entry_too_close;
    case StageFault::Kind::exit_too_close:
      return ErrorCode::exit_too_close;
    case StageFault::Kind::rounding_without_lines:
      return ErrorCode::rounding_without_lines;
    case StageFault::Kind::rounding_too_large:
      return fault.needed_mm == 0 ? ErrorCode::rounding_way_back : ErrorCode::rounding_too_large;
  }
  return ErrorCode::compensation_impossible;
}

bool names_a_wall(StageFault::Kind kind) {
  return kind == StageFault::Kind::too_close || kind == StageFault::Kind::entry_too_close ||
         kind == StageFault::Kind::exit_too_close;
}

/// What was found of the fault's measure, and what would do.
void measure(const StageFault& fault, language::Error& error) {
  const bool is_radius = fault.kind == StageFault::Kind::inside_arc_too_small;
  const std::string_view name = is_radius ? "R " : "", unit = is_radius ? "" : " mm";
  error.detail = fmt::format("{}{:.3f}{}", name, fault.found_mm, unit);
  error.expected = fmt::format("{}>= {:.3f}{}", name, fault.needed_mm, unit);
}

bool is_contour_order(const geometry::PathItem& item) {
  const auto* order = std::get_if<geometry::RadiusOffset>(&item.what);
  return order != nullptr && (order->side == geometry::OffsetSide::left || order->side == geometry::OffsetSide::right);
}

}  // namespace

language::Error error_of(const StageFault& fault) {
  language::Error error{.code = code_of(fault), .program = fault.block.program, .block = fault.block.block};
  if (error.code == language::ErrorCode::rounding_way_back) return error;
  if (names_a_wall(fault.kind)) {
    error.detail = fmt::format("P{:04} N{:03}", fault.other.program, fault.other.block);
  } else if (fault.found_mm != 0 || fault.needed_mm != 0) {
    measure(fault, error);
  }
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

std::expected<ExecutedBlock, language::Error> PathSource::step(std::vector<geometry::PathItem>& out,
                                                               geometry::ContourCheck* check) {
  if (fault_) return std::unexpected(*fault_);
  programmed_.clear();
  auto executed = interpreter_.step(programmed_);
  if (auto passed = pass_on(out, check); !passed) return std::unexpected(passed.error());
  if (!executed || executed->ended)
    if (auto flushed = flush(out, check); !flushed) return std::unexpected(flushed.error());
  if (!executed) fault_ = executed.error();
  return executed;
}

std::expected<void, language::Error> PathSource::pass_on(std::vector<geometry::PathItem>& out,
                                                         geometry::ContourCheck* check) {
  for (const geometry::PathItem& item : programmed_) {
    if (is_contour_order(item)) ++contours_ordered_;
    auto pushed = stages_.push(item, out, check);
    if (pushed) continue;
    has_contour_fault_ = true;
    fault_ = error_of(pushed.error());
    return std::unexpected(*fault_);
  }
  return {};
}

std::expected<void, language::Error> PathSource::flush(std::vector<geometry::PathItem>& out,
                                                       geometry::ContourCheck* check) {
  if (fault_) return std::unexpected(*fault_);
  if (auto flushed = stages_.flush(out, check); !flushed) {
    has_contour_fault_ = true;
    fault_ = error_of(flushed.error());
    return std::unexpected(*fault_);
  }
  return {};
}

}  // namespace cnclab::program
