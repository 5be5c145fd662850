// A heading in row 18, four lines, what is worth knowing in row 22 where it is free, and the keys in row 23.
#include "lab/labor/labor_screen.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/clock.hpp"

namespace cnclab::lab {

namespace {

constexpr int kHeading = 18, kFirst = 19, kNote = 22, kKeys = 23;

/// A page as text; what is empty is not written.
struct Rows {
  std::string heading{};
  std::vector<std::string> lines{};
  std::string note{}, keys{};
};

std::string change_in_words(const LaborVersion& version, const Subject& of, bool german) {
  if (version.time_ms == 0) return german ? "wie geliefert" : "as delivered";
  if (std::holds_alternative<MachineDataSet>(of)) {
    constexpr std::size_t kNumbers = 14;  // "03 04 05 06 07"
    const bool is_long = version.kind.size() > kNumbers;
    return (german ? "Daten " : "data ") + version.kind.substr(0, kNumbers) + (is_long ? " …" : "");
  }
  const std::string block = fmt::format("N{:03}", version.block);
  if (version.kind == "put") return german ? "Satz " + block + " gespeichert" : "block " + block + " stored";
  if (version.kind == "insert") return german ? "Satz " + block + " eingefügt" : "block " + block + " inserted";
  if (version.kind == "delete") return german ? "Satz " + block + " gelöscht" : "block " + block + " deleted";
  if (version.kind == "remove") return german ? "gelöscht" : "deleted";
  return german ? "im Ganzen gespeichert" : "stored as a whole";
}

/// Who and where, in at most `columns`: of a long name the middle is left out, never the seat (STO-005).
std::string person_in_words(const LaborVersion& version, bool german, std::size_t columns) {
  if (version.station == 0) return shortened(version.by, columns);
  const std::string seat = fmt::format(", {} {}", german ? "Platz" : "station", version.station);
  return shortened(version.by, columns - seat.size()) + seat;
}

std::string version_line(const LaborVersion& version, const Subject& of, bool german) {
  constexpr std::size_t kPersonColumns = 27;  // what is left of a row behind its number, date and change
  std::string when(17, ' ');
  if (version.time_ms != 0) {
    const panel::WallClock at = wall_clock(version.time_ms);
    when = fmt::format("{:02}.{:02}.{:02} {:02}:{:02}:{:02}", at.day, at.month, at.year, at.hour, at.minute, at.second);
  }
  return fmt::format("V{:<4} {}  {:<22} {}", version.number, when, change_in_words(version, of, german),
                     person_in_words(version, german, kPersonColumns));
}

std::string page_of(std::size_t first, std::size_t lines, bool german) {
  constexpr std::size_t kPage = LaborMenu::kLines;
  return fmt::format(fmt::runtime(german ? "Seite {} von {}" : "page {} of {}"), first / kPage + 1,
                     std::max<std::size_t>(1, (lines + kPage - 1) / kPage));
}

/// "1-4", "1": the digits of the lines that stand there.
std::string digits_of(std::size_t first, std::size_t lines) {
  const std::size_t count = std::min(LaborMenu::kLines, lines - std::min(first, lines));
  return count > 1 ? fmt::format("1-{}", count) : "1";
}

bool has_pages(std::size_t lines) { return lines > LaborMenu::kLines; }

std::vector<std::string> numbered(const std::vector<std::string>& lines, std::size_t first, bool with_digits) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < LaborMenu::kLines && first + i < lines.size(); ++i)
    shown.push_back((with_digits ? std::to_string(i + 1) + "  " : "") + lines[first + i]);
  return shown;
}

/// The rows of each page.
struct Layout {
  const LaborFacilities& facilities;
  language::Tongue tongue;
  bool german = tongue == language::Tongue::german;

  [[nodiscard]] std::string say(const char* in_german, const char* in_english) const {
    return german ? in_german : in_english;
  }

  Rows operator()(const StartPage& /*page*/) const {
    Rows rows{.heading = say("Was möchten Sie tun?", "What would you like to do?")};
    rows.lines = {fmt::format("{:<24}{:<24}{}", say("1 Versionen", "1 Versions"), say("2 Passwort", "2 Password"),
                              say("3 Sprache", "3 Language")),
                  fmt::format("{:<24}{:<24}{}",
                              facilities.can_print_screen ? say("4 Bildschirm drucken", "4 Print the screen") : "",
                              facilities.has_cassettes ? say("5 Kassetten", "5 Cassettes") : "",
                              say("6 Nachrichten", "6 Messages")),
                  say("7 Abmelden", "7 Log out")};
    rows.note = say("Das Labor zeichnet Tasten, Programmänderungen, Läufe und Freigaben auf.",
                    "The lab records keys, changes of programs, runs and grants.");
    rows.keys = std::string(facilities.can_print_screen ? "1-4" : "1-3") + (facilities.has_cassettes ? ",5-7" : ",6-7");
    if (facilities.can_print_screen && facilities.has_cassettes) rows.keys = "1-7";
    rows.keys += say(" wählt   C oder LABOR: zurück zur Steuerung", " choose   C or LABOR: back to the control");
    return rows;
  }

  Rows operator()(const SubjectPage& /*page*/) const {
    Rows rows{.heading = say("Versionen: wovon?", "Versions: of what?")};
    rows.lines = {say("1 Programm", "1 Program"), say("2 Werkzeugtabelle P0000", "2 Tool table P0000"),
                  say("3 Maschinendaten", "3 Machine data")};
    rows.note = say("Jede Änderung behält den Stand davor: auch Gelöschtes kommt zurück.",
                    "Every change keeps what was before: what was deleted comes back, too.");
    rows.keys = say("1-3 wählt   C zurück   LABOR zur Steuerung", "1-3 choose   C back   LABOR to the control");
    return rows;
  }

  Rows operator()(const ProgramPage& page) const {
    Rows rows{.heading = say("Versionen von Programm P", "Versions of program P") + page.digits + "_"};
    rows.note = say("Vornullen können fehlen; ein gelöschtes Programm hat seine Versionen noch.",
                    "Leading zeros may be left out; a deleted program still has its versions.");
    rows.keys = say("Ziffern   → Versionen zeigen   C löscht eine Ziffer, dann zurück",
                    "Digits   → show the versions   C deletes a digit, then back");
    return rows;
  }

  Rows operator()(const ReadingPage& page) const {
    return {.heading = name_of(page.of, tongue) + say(": wird gelesen …", ": being read …"),
            .keys = say("C zurück", "C back")};
  }

  Rows operator()(const VersionsPage& page) const {
    Rows rows{.heading = say("Versionen: ", "Versions: ") + name_of(page.of, tongue)};
    rows.keys = say("C zurück   LABOR zur Steuerung", "C back   LABOR to the control");
    if (page.versions.empty()) {
      rows.lines = {say("Davon wurde noch nichts gespeichert.", "Nothing of this was ever stored.")};
      return rows;
    }
    rows.heading += ", " + page_of(page.first, page.versions.size(), german);
    std::vector<std::string> lines;
    for (const LaborVersion& version : page.versions) lines.push_back(version_line(version, page.of, german));
    rows.lines = numbered(lines, page.first, true);
    rows.keys = digits_of(page.first, page.versions.size()) + say(" zurückholen   ", " bring back   ");
    if (has_pages(page.versions.size()))
      rows.keys += say("↓ ältere   +/- jüngere   → zehn Seiten   ", "↓ older   +/- newer   → ten pages   ");
    rows.keys += say("C zurück", "C back");
    return rows;
  }

  Rows operator()(const RestorePage& page) const {
    const LaborVersion& version = page.list.versions.at(page.chosen);
    Rows rows;
    rows.heading =
        fmt::format(fmt::runtime(say("{}: soll Version {} wieder gelten?", "{}: is version {} to hold again?")),
                    name_of(page.list.of, tongue), version.number);
    const std::string who = person_in_words(version, german, Screen::kColumns);
    rows.lines = {version_line(version, page.list.of, german), who.empty() ? "" : say("von ", "by ") + who};
    rows.note = say("Der jetzige Stand bleibt als Version erhalten.", "The present state is kept as a version.");
    rows.keys = say("→ ja   C nein", "→ yes   C no");
    return rows;
  }

  Rows operator()(const LanguagePage& /*page*/) const {
    return {.heading = say("Sprache der Texte", "Language of the texts"),
            .lines = {"1 Deutsch", "2 English"},
            .note = say("Sie gilt für Sie an jedem Platz.", "It holds for you at every station."),
            .keys = say("1-2 wählt   C zurück   LABOR zur Steuerung", "1-2 choose   C back   LABOR to the control")};
  }

  Rows operator()(const ListPage& page) const {
    const bool chooses = page.list == LaborList::cassettes;
    Rows rows;
    switch (page.list) {
      case LaborList::messages:
        rows.heading = say("Nachrichten der Lehrkraft", "Messages of the instructor");
        rows.lines = {say("Seit der Anmeldung kam keine.", "None has come since the login.")};
        break;
      case LaborList::cassettes:
        rows.heading = say("Kassetten", "Cassettes");
        rows.lines = {say("Es gibt noch keine.", "There is none.")};
        break;
    }
    const std::size_t lines = page.lines.size();
    if (chooses && lines > 0) rows.keys += digits_of(page.first, lines) + say(" wählt   ", " choose   ");
    if (chooses) rows.keys += say("EINGABE neue   ", "EINGABE new   ");
    if (has_pages(lines)) rows.keys += say("↓ weiter   +/- zurückblättern   ", "↓ on   +/- one page back   ");
    rows.keys += say("C zurück", "C back");
    if (lines == 0) return rows;
    rows.heading += ", " + page_of(page.first, lines, german);
    rows.lines = numbered(page.lines, page.first, chooses);
    return rows;
  }

  Rows operator()(const CassettePage& page) const {
    CassetteRows rows = rows_of(page, tongue);
    return {.heading = std::move(rows.heading), .lines = std::move(rows.lines), .keys = std::move(rows.keys)};
  }
};

}  // namespace

std::string name_of(const Subject& subject, language::Tongue tongue) {
  const bool german = tongue == language::Tongue::german;
  const auto* program = std::get_if<std::uint16_t>(&subject);
  if (program == nullptr) return german ? "Maschinendaten" : "machine data";
  if (*program == 0) return german ? "Werkzeugtabelle P0000" : "tool table P0000";
  return fmt::format("P{:04}", *program);
}

void draw_labor_menu(Screen& screen, const LaborMenu& menu, language::Tongue tongue, bool keeps_sentence) {
  const Rows rows = std::visit(Layout{menu.facilities(), tongue}, menu.page());
  for (int row = keeps_sentence ? kFirst : kHeading; row < Screen::kRows; ++row) screen.set_row(row, Screen::Row{});
  if (!keeps_sentence) {
    screen.write(kHeading, 0, tongue == language::Tongue::german ? " LABOR " : " LAB ", Attribute::inverse);
    screen.write(kHeading, 8, rows.heading);
  }
  for (std::size_t i = 0; i < rows.lines.size(); ++i) screen.write(kFirst + static_cast<int>(i), 1, rows.lines[i]);
  if (!rows.note.empty()) screen.write(kNote, 1, rows.note);
  screen.write(kKeys, 1, rows.keys);
}

}  // namespace cnclab::lab
