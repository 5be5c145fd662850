// Printing programs and reading what was printed, line by line.
#include "language/listing.hpp"

#include <algorithm>

#include "language/block_form.hpp"
#include "language/block_reader.hpp"
#include "language/listing_line.hpp"
#include "language/program_collector.hpp"
#include "language/screen_form.hpp"
#include "language/tape_cursor.hpp"
#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

class ListingReader {
 public:
  explicit ListingReader(Tongue tongue) : programs_(tongue) {}

  Tape read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      read_line(bare_line(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return programs_.finish(has_lower_case_);
  }

 private:
  void read_line(const BareLine& line) {
    if (line.lower_case != 0) {
      has_lower_case_ = true;
      programs_.errors().add({.code = ErrorCode::lower_case, .detail = std::string(1, line.lower_case), .line = line_});
    }
    if (line.has_open_comment)
      programs_.errors().add({.code = ErrorCode::text_malformed, .word = '(', .expected = ")", .line = line_});
    if (line.text.empty()) return;
    switch (line.text.front()) {
      case 'P':
        read_program_head(line.text);
        return;
      case '%':
        programs_.close();
        refuse_more(line.text, 1);
        return;
      default:
        read_block(line.text);
        return;
    }
  }

  void read_program_head(std::string_view text) {
    TapeCursor cursor(text, Reading::strict, unused_);
    cursor.advance();
    const auto number = cursor.read_digits(4);
    if (!number) {
      programs_.add_unreadable_head(line_);
      return;
    }
    programs_.open(*number, line_);
    refuse_more(text, 5);
  }

  /// Nothing stands on the line behind its first `count` characters.
  void refuse_more(std::string_view text, std::size_t count) {
    const std::size_t more = text.find_first_not_of(' ', count);
    if (more == std::string_view::npos) return;
    programs_.add_error({.code = ErrorCode::text_malformed,
                         .detail = character_at(text, more),
                         .expected = std::string(text.substr(0, count)),
                         .line = line_});
  }

  void read_block(std::string_view text) {
    const std::string found = character_at(text, 0);
    if (!programs_.is_open()) {
      programs_.add_orphan(found, line_);
      return;
    }
    if (text.front() != programs_.head_example().front()) {
      programs_.add_error({.code = ErrorCode::text_malformed,
                           .detail = found,
                           .expected = std::string(programs_.head_example()),
                           .line = line_});
      return;
    }
    const TapeLine line = tape_line(text);
    TapeCursor cursor(line.tape, Reading::strict, unused_);
    BlockReader reader(cursor);
    const auto start = reader.read_start();
    if (!start) {
      programs_.add_error(at_line(std::move(reader.fault())));
      return;
    }
    Block& block = programs_.begin_block(start->number);
    block.is_damaged = line.is_damaged;
    if (line.fault)
      programs_.drop_block(at_line(*line.fault));
    else if (!reader.read(block, programs_.is_tool_table()))
      programs_.drop_block(at_line(std::move(reader.fault())));
    else if (cursor.current() != TapeCursor::kEnd || !reader.has_read_block_alone())
      programs_.drop_block(at_line({.code = ErrorCode::text_malformed, .detail = text_at(cursor)}));
    else
      programs_.end_block(line_);
  }

  /// What stands behind a block, of which a line holds one only.
  [[nodiscard]] static std::string text_at(const TapeCursor& cursor) {
    return std::string(cursor.current() == TapeCursor::kEnd ? 0 : 1, cursor.current());
  }

  [[nodiscard]] Error at_line(Error error) const {
    error.line = line_;
    return error;
  }

  ProgramCollector programs_;
  ErrorList unused_;  ///< a bare line has no comments and no small letters to report
  int line_ = 0;
  bool has_lower_case_ = false;
};

}  // namespace

std::string write_listing(const Program& program, std::string_view time_stamp, Tongue tongue) {
  std::string text = "P";
  append_digits(text, program.number, 4);
  text += "\n\n(";
  text += time_stamp;
  text += ")\n\n";
  Plane plane = Plane::xy;
  for (const Block& block : program.blocks) {
    text += block_line(block, plane, tongue) + '\n';
    plane = plane_behind(block, plane);
  }
  return text + "%\n";
}

Tape read_listing(std::string_view text, Tongue tongue) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return ListingReader(tongue).read(text);
}

}  // namespace cnclab::language
