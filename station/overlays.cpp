// Screens made from screens.
#include "station/overlays.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "station/cell_text.hpp"
#include "station/help_page.hpp"

namespace cnclab::station {
namespace {

constexpr int kHelpRows = Screen::kRows - 3;
constexpr int kBoxRow = 6, kBoxColumn = 6, kBoxWidth = 54;
constexpr std::size_t kMostReason = 5;  // rows: the box ends within the frame

void write_box(Screen& screen, const std::vector<std::string>& lines) {
  std::string edge;
  for (int i = 0; i < kBoxWidth - 2; ++i) edge += "─";
  const auto at = [](std::size_t line) { return kBoxRow + static_cast<int>(line); };
  screen.write(at(0), kBoxColumn, "┌" + edge + "┐", Attribute::bold);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    screen.write(at(i + 1), kBoxColumn, "│" + std::string(kBoxWidth - 2, ' ') + "│", Attribute::bold);
    screen.write(at(i + 1), kBoxColumn + 2, lines[i], i == 0 ? Attribute::inverse : Attribute::bold, kBoxWidth - 4);
  }
  screen.write(at(lines.size() + 1), kBoxColumn, "└" + edge + "┘", Attribute::bold);
}

std::string lost_for(std::chrono::seconds since, Language language) {
  return fmt::format(" {}  {} s ", Text{"VERBINDUNG VERLOREN", "CONNECTION LOST"}.in(language), since.count());
}

}  // namespace

Screen with_lost_line(const Screen& last, std::chrono::seconds since, const std::string& trouble, Language language) {
  Screen screen = last;
  for (int row = 0; row < Screen::kRows; ++row) {
    Screen::Row cells = last.row(row);
    for (Cell& cell : cells) cell.attribute = Attribute::dim;
    screen.set_row(row, cells);
  }
  const auto said = [&](const Text& text) { return std::string(text.in(language)); };
  std::vector<std::string> lines{
      lost_for(since, language),
      said({"Das Bild ist der letzte Stand und gilt nicht mehr.", "The picture is the last state, no longer valid."}),
      said({"Die Station verbindet sich von selbst wieder.", "The station reconnects by itself."})};
  std::vector<std::string> reason = wrapped(printable(trouble), kBoxWidth - 4);
  if (reason.size() > kMostReason) reason.resize(kMostReason);
  lines.insert(lines.end(), reason.begin(), reason.end());
  lines.push_back(said({"q beendet.", "q quits."}));
  write_box(screen, lines);
  return screen;
}

Screen with_lost_heading(const Screen& help, std::chrono::seconds since, Language language) {
  constexpr int kColumn = 48;
  Screen screen = help;
  screen.write(0, kColumn, lost_for(since, language), Attribute::inverse);
  return screen;
}

Screen with_looking_on(const Screen& seen, std::uint32_t station, Language language) {
  constexpr Text kTitle{" Nur zusehen: Platz {} ", " Looking on: station {} "};
  constexpr Text kBar{" Nur zusehen: Tasten wirken hier nicht.   q beendet das Zusehen ",
                      " Looking on: keys do nothing here.   q ends looking on "};
  constexpr int kTitleColumn = 2, kBarRow = Screen::kRows - 1;
  Screen screen = seen;
  screen.write(0, kTitleColumn, fmt::format(fmt::runtime(kTitle.in(language)), station), Attribute::inverse);
  screen.set_row(kBarRow, Screen::Row{});
  screen.write(kBarRow, 0, kBar.in(language), Attribute::inverse);
  return screen;
}

Screen with_log_out_question(const Screen& screen, bool looks_on, Language language) {
  constexpr Text kLogOut{" Abmelden? Noch einmal q oder j = ja, jede andere Taste = nein ",
                         " Log out? Again q or y = yes, any other key = no "};
  constexpr Text kLookAway{" Zusehen beenden? Noch einmal q oder j = ja, jede andere Taste = nein ",
                           " End looking on? Again q or y = yes, any other key = no "};
  Screen asked = screen;
  asked.set_row(Screen::kRows - 1, Screen::Row{});
  asked.write(Screen::kRows - 1, 0, (looks_on ? kLookAway : kLogOut).in(language), Attribute::inverse);
  return asked;
}

std::string too_small_text(int rows, int columns, Language language) {
  constexpr Text kText{"Fenster zu klein: 80×24 Zeichen nötig, es hat {}×{}.",
                       "Window too small: 80×24 needed, it has {}×{}."};
  return fmt::format(fmt::runtime(kText.in(language)), columns, rows);
}

std::size_t last_help_start(Language language) {
  const std::size_t lines = help_lines(language).size();
  return lines > kHelpRows ? lines - kHelpRows : 0;
}

Screen help_screen(std::size_t first, Language language) {
  constexpr Text kTitle{" CNC 3300: alle Tasten ", " CNC 3300: all keys "};
  constexpr Text kFoot{" Pfeil ↑ ↓, Bild↑ Bild↓ blättern, jede andere Taste zurück ",
                       " Arrow ↑ ↓, PgUp PgDn scroll, any other key leaves "};
  const auto lines = help_lines(language);
  Screen screen;
  screen.write(0, 0, std::string(kTitle.in(language)), Attribute::inverse);
  const std::size_t start = std::min(first, last_help_start(language));
  for (std::size_t i = start; i < lines.size() && i - start < kHelpRows; ++i) {
    screen.write(static_cast<int>(i - start) + 1, 0, lines[i]);
  }
  screen.write(Screen::kRows - 1, 0, std::string(kFoot.in(language)), Attribute::inverse);
  return screen;
}

std::optional<int> shown_potentiometer(const Screen& screen) {
  constexpr int kRow = 8, kFirst = 66;
  int value = 0, digits = 0;
  for (int column = kFirst; column < Screen::kColumns; ++column) {
    const char32_t code = screen.at(kRow, column).code;
    if (code >= U'0' && code <= U'9' && digits < 3) {
      value = 10 * value + static_cast<int>(code - U'0');
      ++digits;
    } else if (code == U'%' && digits > 0) {
      return value <= 100 ? std::optional(value) : std::nullopt;
    }
  }
  return std::nullopt;
}

bool shows_external_data(const Screen& screen) {
  constexpr int kTitleRow = 2;
  const std::string title = screen.text(kTitleRow);
  return title.starts_with("│EXTERNE DATEN") || title.starts_with("│EXTERNAL DATA");
}

}  // namespace cnclab::station
