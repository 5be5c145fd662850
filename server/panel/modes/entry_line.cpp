// The half-filled block: which field the marker is in, and what keys make of it.
#include "panel/modes/entry_line.hpp"

#include <algorithm>

#include "language/screen_form.hpp"

namespace cnclab::panel {

namespace {

using language::Function;

constexpr int kNumberColumn = 0;
constexpr int kFunctionColumn = 5;

}  // namespace

EntryLine::EntryLine(std::uint16_t program, int number, std::uint8_t proposed_g) {
  content_.is_tool_row = program == language::kToolTable;
  content_.number.offer(number);
  if (!content_.is_tool_row) content_.code.offer(proposed_g);
}

EntryLine EntryLine::loaded(std::uint16_t program, const language::Block& block, const language::BlockForm& form) {
  EntryLine line(program, block.number, block.function.code);
  line.content_.is_parametric = block.function.kind == Function::Kind::parametric;
  line.content_.is_loaded = true;
  std::size_t next = 0;
  for (const language::Address address : form.words) {
    const bool is_there = next < block.words.size() && block.words[next].address == address;
    line.content_.words.push_back(WordEntry::of(address, is_there ? &block.words[next] : nullptr));
    if (is_there) ++next;
  }
  line.content_.shown = block.function;
  return line;
}

std::optional<Function> EntryLine::function() const {
  if (content_.is_tool_row) return Function{Function::Kind::tool, 0};
  if (!content_.code.value) return std::nullopt;
  const auto kind = content_.is_parametric ? Function::Kind::parametric : Function::Kind::g;
  return Function{kind, static_cast<std::uint8_t>(*content_.code.value)};
}

void EntryLine::digit(int figure) {
  switch (content_.marker) {
    case Marker::number:
      content_.number.digit(figure);
      forget_words();
      break;
    case Marker::function:
      content_.code.digit(figure);
      break;
    case Marker::word:
      content_.words[content_.word].digit(figure);
      break;
  }
}

void EntryLine::point() {
  if (content_.marker == Marker::word) content_.words[content_.word].point();
}

void EntryLine::sign() {
  if (content_.marker == Marker::word) content_.words[content_.word].sign();
}

bool EntryLine::acts(Effect effect) const {
  if (content_.marker != Marker::word) return true;
  const WordEntry& word = content_.words[content_.word];
  if (effect == Effect::point || effect == Effect::sign) return word.takes_point_and_sign();
  return effect != Effect::down || word.takes_parameter();
}

void EntryLine::clear() {
  switch (content_.marker) {
    case Marker::number:
      content_.number.clear();
      forget_words();
      break;
    case Marker::function:
      if (!content_.code.value && !content_.is_parametric) {
        content_.marker = Marker::number;
        break;
      }
      content_.code.clear();
      content_.is_parametric = false;
      break;
    case Marker::word:
      content_.words[content_.word].clear();
      break;
  }
}

bool EntryLine::down() {
  if (content_.marker == Marker::word) return content_.words[content_.word].to_parameter();
  if (content_.marker == Marker::number || content_.is_tool_row) return false;
  content_.code.clear();
  content_.is_parametric = true;
  return true;
}

/// Another number is another block: what was loaded or typed so far does not go with it.
void EntryLine::forget_words() {
  content_.is_loaded = false;
  content_.words.clear();
  content_.shown.reset();
}

void EntryLine::offer_number(int number) { content_.number.offer(number); }

void EntryLine::show_words(const language::BlockForm& form) {
  const std::vector<WordEntry> before = std::move(content_.words);
  content_.words.clear();
  for (const language::Address address : form.words) {
    const auto taken = std::ranges::count(content_.words, address, &WordEntry::address);
    auto same = before.begin();
    for (auto skip = taken; same != before.end(); ++same)
      if (same->address == address && skip-- == 0) break;
    content_.words.push_back(same == before.end() ? WordEntry::of(address, nullptr) : *same);
    content_.words.back().arrive();
  }
  content_.shown = form.function;
  content_.word = 0;
  content_.marker = content_.words.empty() ? Marker::function : Marker::word;
}

void EntryLine::next_word() {
  if (content_.words.empty()) return;
  content_.word = content_.marker == Marker::word ? (content_.word + 1) % content_.words.size() : 0;
  content_.marker = Marker::word;
  content_.words[content_.word].arrive();
}

bool EntryLine::is_at_last_word() const {
  return content_.marker == Marker::word && content_.word + 1 == content_.words.size();
}

void EntryLine::fill(language::Address address, std::optional<std::int32_t> number) {
  const auto found = std::ranges::find(content_.words, address, &WordEntry::address);
  if (found == content_.words.end()) return;
  const language::Word word{address, false, number.value_or(0)};
  *found = WordEntry::of(address, number ? &word : nullptr);
}

void EntryLine::mark(char letter) {
  const auto is_meant = [letter](const WordEntry& word) { return language::letter(word.address) == letter; };
  auto found =
      std::ranges::find_if(content_.words, [&](const WordEntry& word) { return is_meant(word) && !word.has_value; });
  if (found == content_.words.end()) found = std::ranges::find_if(content_.words, is_meant);
  if (found == content_.words.end()) {
    content_.marker = content_.is_tool_row ? content_.marker : Marker::function;
    return;
  }
  content_.word = static_cast<std::size_t>(found - content_.words.begin());
  content_.marker = Marker::word;
  found->arrive();
}

language::Block EntryLine::block() const {
  language::Block block;
  block.number = static_cast<std::uint16_t>(number());
  block.function = function().value_or(Function{});
  for (const WordEntry& entry : content_.words)
    if (const auto word = entry.word(); word && block.words.size() < language::kMostWords) block.words.push_back(*word);
  return block;
}

const WordEntry* EntryLine::half_word() const {
  const auto found = std::ranges::find_if(content_.words, &WordEntry::is_half);
  return found == content_.words.end() ? nullptr : &*found;
}

void EntryLine::draw(Monitor& monitor, int row, language::Plane plane, language::Tongue tongue, Style style) const {
  const bool is_numbered = style != Style::without_number;
  const int left = is_numbered ? 0 : -kFunctionColumn, column = kFunctionColumn + left;
  const bool has_words = words_fit_function();
  if (is_numbered) monitor.write(row, kNumberColumn, (content_.is_tool_row ? "T" : "N") + content_.number.text());
  if (has_words) draw_words(monitor, row, left, plane, tongue);
  // A number that still waits to be acknowledged stands alone, unless its block was loaded.
  const bool has_function = has_words || content_.marker != Marker::number;
  if (has_function && !content_.is_tool_row)
    monitor.write(row, column, (content_.is_parametric ? "↓" : "G") + content_.code.text());
  if (content_.marker == Marker::number && style == Style::editor) return monitor.mark(row, kNumberColumn);
  if (content_.marker != Marker::function || content_.is_tool_row) return;
  // ↓ and G differ only in this cell, so the arrow stays readable and is shown inverse (SCR-053).
  if (content_.is_parametric) return monitor.put(row, column, U'↓', Attribute::inverse);
  if (!is_numbered) return monitor.put(row, column, U'G', Attribute::inverse);
  monitor.mark(row, column);
}

void EntryLine::draw_words(Monitor& monitor, int row, int left, language::Plane plane, language::Tongue tongue) const {
  language::Block empty = block();
  empty.words.clear();
  const std::u32string cells = from_utf8(language::block_line(empty, plane, tongue));
  std::size_t column = content_.is_tool_row ? kFunctionColumn : kFunctionColumn + 4;
  for (std::size_t i = column; i < cells.size(); ++i) monitor.put(row, static_cast<int>(i) + left, cells[i]);
  for (std::size_t i = 0; i < content_.words.size(); ++i) {
    const WordEntry& word = content_.words[i];
    const auto wanted = static_cast<char32_t>(language::letter(word.address));
    for (bool in_text = false; column < cells.size() && (in_text || cells[column] != wanted); ++column)
      in_text = cells[column] == U'(' || (in_text && cells[column] != U')');
    const bool is_value = word.address == language::Address::value;
    const int place = static_cast<int>(column) + left;
    monitor.write(row, place + (is_value ? 2 : 0), word.text());
    if (content_.marker == Marker::word && content_.word == i) monitor.mark(row, place);
    ++column;
  }
}

}  // namespace cnclab::panel
