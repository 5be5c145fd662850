// Reading machine data as numbers and values; what a number means is the machine's.
#include "language/machine_data_section.hpp"

#include <algorithm>
#include <optional>

#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

constexpr std::uint16_t kFirstStored = 3;     // 01 and 02 are clock and date (DEC-62)
constexpr std::int64_t kLargest = 9'999'999;  // the widest of the control's fields (MD 03 to 05)
constexpr std::string_view kExample = "N03=500000";
constexpr std::string_view kValues = "0..9999999";

class SectionReader {
 public:
  SectionReader(TapeCursor& cursor, ErrorList& errors) : cursor_(cursor), errors_(errors) {}

  /// The data, or nothing after an error.
  std::optional<std::vector<MachineDatum>> read() {
    if (is_at_end()) fail("MD", kExample);
    while (!is_at_end())
      if (!read_datum()) skip_to_next();
    if (has_error_) return std::nullopt;
    return std::move(data_);
  }

 private:
  /// Behind the section stand "%", a separator, the end, another program or another section.
  [[nodiscard]] bool is_at_end() const {
    const char c = cursor_.current();
    return c == '%' || c == 'P' || c == 'M' || c == TapeCursor::kSeparator || c == TapeCursor::kEnd;
  }

  /// "N03=500000".
  bool read_datum() {
    const int line = cursor_.line();
    if (cursor_.current() != 'N') return fail(std::string(1, cursor_.current()), kExample);
    cursor_.advance();
    const auto number = cursor_.read_digits(2);
    if (!number || cursor_.current() != '=') return fail("N", kExample);
    std::string name = "N";
    append_digits(name, *number, 2);
    if (*number < kFirstStored) return fail(std::move(name), "N03..N22");
    cursor_.advance();
    const auto value = read_value();
    if (!value) return fail(std::move(name), kValues);
    if (std::ranges::find(data_, *number, &MachineDatum::number) != data_.end()) return fail(name + " 2×", {});
    data_.push_back({.number = *number, .value = *value, .line = line});
    return true;
  }

  std::optional<std::int64_t> read_value() {
    if (!cursor_.is_digit()) return std::nullopt;
    std::int64_t value = 0;
    for (; cursor_.is_digit(); cursor_.advance())
      value = std::min(value * 10 + (cursor_.current() - '0'), kLargest + 1);
    if (value > kLargest) return std::nullopt;
    return value;
  }

  void skip_to_next() {
    while (!is_at_end() && cursor_.current() != 'N') cursor_.advance();
  }

  bool fail(std::string found, std::string_view expected) {
    has_error_ = true;
    errors_.add({.code = ErrorCode::machine_datum_wrong,
                 .detail = std::move(found),
                 .expected = std::string(expected),
                 .line = cursor_.line()});
    return false;
  }

  TapeCursor& cursor_;
  ErrorList& errors_;
  std::vector<MachineDatum> data_;
  bool has_error_ = false;
};

}  // namespace

void read_machine_data(TapeCursor& cursor, ProgramCollector& programs) {
  programs.close();
  if (auto data = SectionReader(cursor, programs.errors()).read()) programs.put_machine_data(std::move(*data));
}

}  // namespace cnclab::language
