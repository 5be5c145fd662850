// Halts are items like any other: the machine stops for them as for M00.
#include "panel/run/tool_guard.hpp"

#include <fmt/format.h>

#include <utility>

namespace cnclab::panel {

namespace {

using geometry::PathItem;
using language::Error;
using language::ErrorCode;
using machine::ToolFault;

bool is_way(const PathItem& item) {
  return std::holds_alternative<geometry::Line>(item.what) || std::holds_alternative<geometry::Arc>(item.what);
}

/// An event that happens before `place`, as part of its block.
PathItem event_before(const PathItem& place, auto what) {
  PathItem event;
  event.source = place.source;
  event.sequence = place.sequence;
  event.passes_single_block = place.passes_single_block;
  event.what = what;
  return event;
}

Error error_of(const ToolFault& fault, const geometry::SourceBlock& block) {
  Error error{
      .program = block.program, .block = block.block, .word = 'T', .detail = fmt::format("T{:02}", fault.number)};
  const auto differs = [&](char value) {
    error.code = ErrorCode::tool_differs;
    error.detail += fmt::format(" {} {:.3f}", value, fault.found_mm);
    error.expected = fmt::format("{:.3f}..{:.3f}", fault.listed_mm - machine::ToolList::kTolerance_mm,
                                 fault.listed_mm + machine::ToolList::kTolerance_mm);
  };
  switch (fault.kind) {
    case ToolFault::Kind::not_listed:
      error.code = ErrorCode::tool_not_listed;
      break;
    case ToolFault::Kind::radius_differs:
      differs('R');
      break;
    case ToolFault::Kind::length_differs:
      differs('L');
      break;
  }
  return error;
}

}  // namespace

std::optional<Error> ToolGuard::guard(std::vector<PathItem>& items) {
  std::vector<PathItem> out;
  out.reserve(items.size());
  std::optional<Error> error;
  for (PathItem& item : items) {
    const auto* called = std::get_if<geometry::ToolChange>(&item.what);
    if (called != nullptr || is_way(item)) {
      const geometry::ToolChange in_force = std::exchange(in_force_, {});
      if (called == nullptr && in_force.number != 0) error = call(item, in_force, out);
    }
    if (called != nullptr && !error) error = call(item, *called, out);
    if (error) {
      std::erase_if(out, [&item](const PathItem& other) { return other.sequence >= item.sequence; });
      break;
    }
    out.push_back(std::move(item));
  }
  items = std::move(out);
  return error;
}

std::optional<Error> ToolGuard::call(const PathItem& place, const geometry::ToolChange& tool,
                                     std::vector<PathItem>& out) {
  const bool is_added = !std::holds_alternative<geometry::ToolChange>(place.what);
  if (list_) {
    if (const auto fault = list_->fault_of(tool)) return error_of(*fault, place.source);
    if (list_->needs_change(tool)) {
      out.push_back(event_before(place, geometry::Halt{}));
      due_[place.sequence] = tool.number;
      list_->set_in_spindle(tool.number);
    }
  }
  if (is_added) out.push_back(event_before(place, tool));
  return std::nullopt;
}

int ToolGuard::due(std::uint64_t sequence) const {
  const auto found = due_.find(sequence);
  return found == due_.end() ? 0 : found->second;
}

}  // namespace cnclab::panel
