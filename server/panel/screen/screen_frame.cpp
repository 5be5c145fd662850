// Everything on the screen that is the same in all operating modes.
#include "panel/screen/screen_frame.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "panel/screen/names.hpp"

namespace cnclab::panel {

namespace {

constexpr int kFrameBottom = 17, kFrameRight = 65;
constexpr int kSideColumn = 67, kLampColumn = 76;
constexpr int kSentenceRow = 18, kAllKeysRow = 23, kFirstKeyColumn = 1;

std::string clock_text(const WallClock& clock) {
  return two_digits(clock.hour) + ':' + two_digits(clock.minute) + ':' + two_digits(clock.second) + ' ' +
         two_digits(clock.day) + '/' + two_digits(clock.month) + '/' + two_digits(clock.year);
}

std::string five_digits(int value) {
  const std::string digits = std::to_string(std::clamp(value, 0, 99999));
  return std::string(5 - digits.size(), '0') + digits;
}

/// Motion screens carry their title in line 1, the others in line 2 (SCR-004, SCR-005).
bool is_motion_mode(Mode mode) {
  return mode == Mode::hand || mode == Mode::hand_input || mode == Mode::teach_in || mode == Mode::automat;
}

char32_t spindle_sign(geometry::SpindleTurn turn) {
  switch (turn) {
    case geometry::SpindleTurn::off:
      return U'○';
    case geometry::SpindleTurn::clockwise:
      return U'↻';
    case geometry::SpindleTurn::counterclockwise:
      return U'↺';
  }
  return U'○';
}

void draw_lamps(Canvas& canvas, const Lamps& lamps, language::Tongue tongue) {
  constexpr int kFirstRow = 9;
  struct Lamp {
    Text label;
    char32_t sign;
  };
  const auto sign = [](bool on) { return on ? U'●' : U'○'; };
  const Lamp rows[] = {{Text::side_start, sign(lamps.start)},
                       {Text::side_single, sign(lamps.single_block)},
                       {Text::side_spindle, spindle_sign(lamps.spindle)},
                       {Text::side_coolant, sign(lamps.coolant)},
                       {Text::side_limit, sign(lamps.limit)}};
  int row = kFirstRow;
  for (const Lamp& lamp : rows) {
    canvas.write(row, kSideColumn, text(lamp.label, tongue));
    canvas.put(row, kLampColumn, lamp.sign);
    ++row;
  }
}

/// Breaks at the last blank that fits; a text without one is cut.
std::pair<std::string, std::string> broken_at(const std::string& sentence, int columns) {
  if (columns_of(sentence) <= columns) return {sentence, {}};
  std::size_t place = std::string::npos;
  for (std::size_t i = 0; i < sentence.size(); ++i)
    if (sentence[i] == ' ' && columns_of(std::string_view(sentence).substr(0, i)) <= columns) place = i;
  if (place == std::string::npos) return {sentence, {}};
  return {sentence.substr(0, place), sentence.substr(place + 1)};
}

/// Breaks at blanks; a word that is longer than a row goes on in the next one.
std::vector<std::string> filled_rows(std::string_view words, int columns) {
  std::vector<std::string> rows(1);
  int used = 0;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (used > 0 && used + 1 + columns_of(word) > columns) {
      rows.emplace_back();
      used = 0;
    } else if (used > 0) {
      rows.back() += ' ';
      ++used;
    }
    for (const char byte : word) {
      const bool begins_letter = (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
      if (begins_letter && used == columns) rows.emplace_back();
      if (begins_letter) used = used == columns ? 1 : used + 1;
      rows.back() += byte;
    }
  }
  return rows;
}

/// Who pressed MASCHINE HALT, whole: at which seat and who (AUTH-006).
std::vector<std::string> halt_rows(const SideView& side, language::Tongue tongue, int columns) {
  if (side.halted_by.empty()) return {};
  const std::string seat = side.halted_at == 0 ? "" : text(Text::side_seat, tongue, {two_digits(side.halted_at)}) + " ";
  return filled_rows(text(Text::side_halt, tongue, {seat + side.halted_by}), columns);
}

/// "EINGABE", "±X ±Y ±Z", "0-9", "1,3-4,7": those of the row's keys that are of use; empty where none is.
std::string keys_text(const KeyRow& row, const BottomView& view) {
  std::string keys;
  Key former = Key::none;  // the last that was of use
  for (int number = static_cast<int>(row.first); number <= static_cast<int>(row.last); ++number) {
    const auto key = static_cast<Key>(number);
    if (!view.lists(row.effect, key)) continue;
    if (row.first == Key::PLUS_X) return "±X ±Y ±Z";
    const std::string label(label_of(key));
    const bool goes_on = former != Key::none && static_cast<int>(former) + 1 == number;
    if (!goes_on) keys += (keys.empty() ? "" : ",") + label;
    const bool ends = key == row.last || !view.lists(row.effect, static_cast<Key>(number + 1));
    if (goes_on && ends) keys += "-" + label;
    former = key;
  }
  return keys;
}

std::vector<std::string> listed_keys(const BottomView& view, Place place, const Settings& settings, bool with_help) {
  std::vector<std::string> all;
  for (const KeyRow& row : key_table()) {
    if (row.place != place || !has_row(row, settings.vocabulary)) continue;
    const std::string keys = keys_text(row, view);
    if (keys.empty()) continue;
    const std::string help = with_help ? " " + std::string(text(row.help, settings.tongue)) : std::string();
    all.push_back(keys + help);
  }
  return all;
}

/// Where the keys stand, from `row` on; keys that do not fit above stand beside the last row's own words.
struct KeyPlace {
  std::string keys;
  int row, column;
};
std::vector<KeyPlace> laid_out(const std::vector<std::string>& all, int row, std::string_view last_rows_own) {
  constexpr int kGap = 3;
  std::vector<KeyPlace> places;
  int column = kFirstKeyColumn;
  for (const std::string& keys : all) {
    const int width = columns_of(keys);
    if (column > kFirstKeyColumn && column + width > Screen::kColumns) {
      ++row;
      column = row == kAllKeysRow ? kFirstKeyColumn + columns_of(last_rows_own) + kGap : kFirstKeyColumn;
    }
    places.push_back({keys, row, column});
    column += width + kGap;
  }
  return places;
}

}  // namespace

void draw_frame(Canvas& canvas) {
  for (int column = 1; column < kFrameRight; ++column) {
    canvas.put(0, column, U'─');
    canvas.put(kFrameBottom, column, U'─');
  }
  for (int row = 1; row < kFrameBottom; ++row) {
    canvas.put(row, 0, U'│');
    canvas.put(row, kFrameRight, U'│');
  }
  canvas.put(0, 0, U'┌');
  canvas.put(0, kFrameRight, U'┐');
  canvas.put(kFrameBottom, 0, U'└');
  canvas.put(kFrameBottom, kFrameRight, U'┘');
}

void draw_header(Monitor& monitor, Mode mode, const Settings& settings, const WallClock& clock, int free_bytes) {
  constexpr int kTitleColumn = 19, kClockColumn = 46, kFreeColumn = 58;
  const bool is_3300 = settings.vocabulary.model == language::Model::cnc3300;
  monitor.write(0, 0, is_3300 ? "CNC 3300" : "CNC 3250");
  const bool is_motion = is_motion_mode(mode);
  monitor.write(is_motion ? 0 : 1, is_motion ? kTitleColumn : 0, title_of(mode, settings.tongue));
  monitor.write(0, kClockColumn, clock_text(clock));
  monitor.write(1, kFreeColumn, five_digits(free_bytes));
}

void draw_side(Canvas& canvas, const SideView& side, const Lamps& lamps, language::Tongue tongue) {
  constexpr int kWidth = Screen::kColumns - kSideColumn;
  constexpr int kUpperMeldungRow = 2, kMeldungRow = 15, kHaltRow = 16;
  const auto line = [&](int row, int column, std::string_view content, Attribute attribute = Attribute::normal) {
    canvas.write(row, column, content, attribute, kWidth - (column - kSideColumn));
  };
  const auto seat = [&](int station) { return text(Text::side_seat, tongue, {two_digits(station)}); };
  line(0, kSideColumn, seat(side.station));
  line(1, kSideColumn, side.user);
  line(3, kSideColumn + 1, text(side.on_lab_machine ? Text::side_machine : Text::side_training, tongue),
       side.on_lab_machine ? Attribute::inverse : Attribute::normal);
  line(5, kSideColumn, text(Text::side_controller, tongue));
  line(6, kSideColumn,
       side.controlling_station == 0 ? std::string(text(Text::side_nobody, tongue)) : seat(side.controlling_station));
  if (!lamps.is_referenced) line(7, kSideColumn, text(Text::side_unreferenced, tongue));
  std::string percent = std::to_string(std::clamp(side.override_percent, 0, 999));
  percent.insert(0, 3 - percent.size(), ' ');
  line(8, kSideColumn, text(Text::side_override, tongue, {percent}));
  draw_lamps(canvas, lamps, tongue);
  const std::vector<std::string> halt = halt_rows(side, tongue, kWidth);
  const int halt_row = std::min(kHaltRow, kFrameBottom + 1 - static_cast<int>(halt.size()));
  for (std::size_t i = 0; i < halt.size(); ++i)
    line(halt_row + static_cast<int>(i), kSideColumn, halt[i], Attribute::inverse);
  if (side.meldung > 0)
    line(halt_row > kMeldungRow ? kMeldungRow : kUpperMeldungRow, kSideColumn,
         text(Text::side_message, tongue, {std::to_string(side.meldung)}));
}

void draw_bottom(Canvas& canvas, const BottomView& view, Place place, const Settings& settings) {
  int row = kSentenceRow;
  const auto say = [&](const std::string& sentence) {
    const auto [first, rest] = broken_at(sentence, Screen::kColumns);
    canvas.write(row++, 0, first);
    if (!rest.empty()) canvas.write(row++, 0, rest);
  };
  if (!view.bar.empty()) say(view.bar);
  say(view.sentence);
  const std::string_view all_keys = text(Text::all_keys, settings.tongue);
  canvas.write(kAllKeysRow, kFirstKeyColumn, all_keys);
  std::vector<KeyPlace> places = laid_out(listed_keys(view, place, settings, true), row, all_keys);
  if (!places.empty() && places.back().row > kAllKeysRow)  // between long sentences the names alone
    places = laid_out(listed_keys(view, place, settings, false), row, all_keys);
  for (const KeyPlace& at : places)
    if (at.row <= kAllKeysRow) canvas.write(at.row, at.column, at.keys);
}

}  // namespace cnclab::panel
