// Keeping programs and errors as a reader finds them.
#include "language/program_collector.hpp"

#include <algorithm>
#include <ranges>
#include <utility>

namespace cnclab::language {

void ProgramCollector::open(std::uint16_t number, int line) {
  close();
  is_open_ = true;
  number_ = number;
  line_of_program_ = line;
}

void ProgramCollector::close() {
  if (is_open_) {
    const bool is_reserved = is_reserved_for_cycles(number_);
    if (blocks_.empty() && !is_bad_)
      add_error({.code = ErrorCode::program_empty, .expected = std::string(head_example()), .line = line_of_program_});
    if (is_reserved && tape_.notices.size() < kMostErrors)
      tape_.notices.push_back(explain({.code = ErrorCode::reserved_for_cycles, .program = number_}, tongue_));
    if (!is_reserved && !is_bad_) keep();
    if (!is_reserved && is_bad_ && tape_.faulty_programs.size() < kMostErrors)
      tape_.faulty_programs.push_back(sorted());
  }
  is_open_ = is_bad_ = is_known_orphan_ = false;
  blocks_.clear();
  lines_.clear();
  seen_.reset();
}

Block& ProgramCollector::begin_block(std::uint16_t number) {
  Block& block = blocks_.emplace_back();
  block.number = number;
  return block;
}

void ProgramCollector::end_block(int line) {
  const std::uint16_t number = blocks_.back().number;
  if (seen_.test(number)) {
    drop_block({.code = ErrorCode::block_number_wrong, .block = number, .word = 'N', .detail = "2×", .line = line});
    return;
  }
  seen_.set(number);
  lines_.push_back(line);
}

void ProgramCollector::drop_block(Error error) {
  error.block = blocks_.back().number;
  blocks_.pop_back();
  add_error(std::move(error));
}

void ProgramCollector::add_error(Error error) {
  is_bad_ = true;
  if (is_open_) error.program = number_;
  error.in_tool_table = is_tool_table();
  if (is_open_ && is_reserved_for_cycles(number_)) return;  // left out with a notice anyway
  errors_.add(std::move(error));
}

void ProgramCollector::add_orphan(std::string_view found, int line) {
  if (!is_known_orphan_)
    errors_.add(
        {.code = ErrorCode::transfer_wrong, .detail = std::string(found), .expected = "P0001N001", .line = line});
  is_known_orphan_ = true;
}

void ProgramCollector::add_unreadable_head(int line) {
  close();
  is_known_orphan_ = true;
  errors_.add({.code = ErrorCode::program_number_wrong, .word = 'P', .expected = "P0000..P9999", .line = line});
}

void ProgramCollector::keep() {
  ReadProgram read = sorted();
  std::uint16_t& place = places_[number_];
  if (place != 0) {
    tape_.programs[place - 1U] = std::move(read);
  } else {
    tape_.programs.push_back(std::move(read));
    place = static_cast<std::uint16_t>(tape_.programs.size());
  }
}

/// The open program with ascending numbers (EDIT-032), which texts nearly always have, and no more memory than needed.
ReadProgram ProgramCollector::sorted() const {
  if (std::ranges::is_sorted(blocks_, {}, &Block::number))
    return {.program = {.number = number_, .blocks = {blocks_.begin(), blocks_.end()}},
            .lines = {lines_.begin(), lines_.end()}};
  std::vector<std::size_t> order(blocks_.size());
  std::ranges::copy(std::views::iota(std::size_t{0}, order.size()), order.begin());
  std::ranges::sort(order, {}, [&](std::size_t i) { return blocks_[i].number; });
  ReadProgram read{.program = {.number = number_, .blocks = {}}, .lines = {}};
  for (const std::size_t i : order) {
    read.program.blocks.push_back(blocks_[i]);
    read.lines.push_back(lines_[i]);
  }
  return read;
}

void ProgramCollector::note_dropped_errors() {
  if (errors_.dropped == 0) return;
  const std::string count = std::to_string(errors_.dropped);
  tape_.notices.push_back(tongue_ == Tongue::german ? count + " weitere Fehler sind nicht aufgeführt."
                                                    : count + " more errors are not listed.");
}

Tape ProgramCollector::finish(bool has_lower_case) {
  close();
  if (has_lower_case) {
    tape_.programs.clear();
    tape_.faulty_programs.clear();
    tape_.machine_data.clear();
  }
  tape_.errors = std::move(errors_.errors);
  note_dropped_errors();
  return std::move(tape_);
}

}  // namespace cnclab::language
