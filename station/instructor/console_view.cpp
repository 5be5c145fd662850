// The console's screen, drawn from what it knows.
#include "instructor/console_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace cnclab::instructor {
namespace {

using station::Text;

constexpr int kLeaseColumn = 44, kLeaseColumnInHalt = 60;
constexpr int kLongNameRow = 17, kMachineRow = 18, kTickRow = 19, kMessageRow = 21, kKeysRow = 23;

constexpr std::size_t kTextWidth = Screen::kColumns - 2;

/// Where to break a text so that what is before fits into a row: at a blank, where there is one.
std::size_t break_of(const std::u32string& text) {
  if (text.size() <= kTextWidth) return text.size();
  const std::size_t blank = text.rfind(U' ', kTextWidth);
  return blank == std::u32string::npos || blank == 0 ? kTextWidth : blank;
}

/// Columns of the table of seats.
struct Column {
  int at;
  int width;
  Text heading;
};
constexpr Column kSeat{2, 2, {"Pl", "St"}}, kName{5, 12, {"Name", "Name"}}, kMode{18, 15, {"Betriebsart", "Mode"}},
    kRunning{34, 1, {"", ""}}, kProgram{35, 10, {"Programm", "Program"}}, kLink{46, 5, {"Netz", "Line"}},
    kHand{52, 4, {"Hand", "Hand"}}, kKey{57, 9, {"Taste", "Key"}}, kErrors{67, 4, {"Fehl", "Err."}},
    kControl{72, 8, {"Maschine", "Machine"}};

/// Keys whose names of interfaces.md are wider than their column.
struct ShortName {
  std::string_view name, text;
};
constexpr std::array<ShortName, 8> kShortNames{{{"KUEHLMITTEL", "KÜHLMITT."},
                                                {"EINZELSATZ", "EINZELS."},
                                                {"EXTERNE_DATEN", "EXT.DATEN"},
                                                {"SATZ_SUCHEN", "S.SUCHEN"},
                                                {"SPEICHER_LOESCHEN", "SP.LÖSCH."},
                                                {"HANDEINGABE", "HANDEING."},
                                                {"SATZ_LOESCHEN", "S.LÖSCHEN"},
                                                {"MASCHINE_HALT", "M. HALT"}}};

std::string_view short_name(std::string_view key) {
  const auto* const found = std::ranges::find(kShortNames, key, &ShortName::name);
  return found == kShortNames.end() ? key : found->text;
}

class Drawing {
 public:
  explicit Drawing(const ConsoleModel& model) : model_(model) {}

  /// The station's own 24 rows, with a line over its frame that says how to leave.
  [[nodiscard]] Screen draw_watched() {
    screen_ = model_.watched.screen;
    const Text watching{" Platz {}: Bild. t Tastatur, h MASCHINE HALT, jede andere Taste: zurück ",
                        " Station {}: screen. t keyboard, h MACHINE HALT, any other key: back "};
    const Text typing{" Platz {}: Ihre Tastatur. F8 gibt sie zurück, F12 MASCHINE HALT ",
                      " Station {}: your keyboard. F8 gives it back, F12 MACHINE HALT "};
    const Text& text = model_.watched.is_typing ? typing : watching;
    fill(0, Attribute::inverse);
    screen_.write(0, 1, fmt::format(fmt::runtime(say(text)), model_.watched.station), Attribute::inverse);
    if (!model_.message.text.empty()) screen_.write(17, 1, model_.message.text, Attribute::inverse, 64);
    return screen_;
  }

  [[nodiscard]] Screen draw_seats() {
    draw_title();
    if (model_.overlay == Overlay::help) {
      draw_help();
    } else if (model_.overlay == Overlay::page) {
      draw_page();
    } else {
      draw_headings();
      for (int seat = 1; seat <= kSeats; ++seat) draw_seat(seat);
      draw_long_name();
    }
    draw_machine();
    draw_ticks();
    draw_message();
    draw_keys();
    return screen_;
  }

 private:
  [[nodiscard]] std::string_view say(const Text& text) const { return text.in(model_.language); }

  void fill(int row, Attribute attribute) { screen_.write(row, 0, std::string(Screen::kColumns, ' '), attribute); }

  void draw_title() {
    fill(0, Attribute::inverse);
    screen_.write(0, 1, say({"LEHRKRAFT", "INSTRUCTOR"}), Attribute::inverse);
    screen_.write(0, 18, fmt::format("{} @ {}", model_.user, model_.server), Attribute::inverse, 32);
    switch (model_.link) {
      case Link::connected:
        screen_.write(0, 52, say({"verbunden", "connected"}), Attribute::inverse);
        break;
      case Link::lost:
        screen_.write(0, 52, fmt::format("{} {} s", say({"VERBINDUNG VERLOREN", "CONNECTION LOST"}), model_.lost_for_s),
                      Attribute::inverse, 28);
        break;
    }
  }

  void draw_headings() {
    for (const auto& column : {kSeat, kName, kMode, kProgram, kLink, kHand, kKey, kErrors, kControl}) {
      screen_.write(1, column.at, say(column.heading), Attribute::bold, column.width);
    }
  }

  [[nodiscard]] Attribute attribute_of(int seat) const {
    if (seat == model_.chosen) return Attribute::inverse;
    return model_.link == Link::lost ? Attribute::dim : Attribute::normal;
  }

  void draw_seat(int seat) {
    const int row = kFirstSeatRow + seat - 1;
    const Attribute attribute = attribute_of(seat);
    fill(row, attribute);
    const auto put = [&](const Column& column, std::string_view text) {
      screen_.write(row, column.at, text, attribute, column.width);
    };
    if (seat == model_.chosen) screen_.write(row, 1, ">", attribute);
    put(kSeat, fmt::format("{:2}", seat));
    if (!model_.status) return;
    put(kControl, control_of(seat));
    const v1::StationStatus* const at_seat = seat_of(*model_.status, seat);
    if (at_seat == nullptr) return put(kName, say({"(frei)", "(free)"}));
    put(kName, shortened(at_seat->user(), kName.width));
    put(kMode, at_seat->mode());
    if (at_seat->program() != 0) put(kProgram, fmt::format("P{:04} N{:03}", at_seat->program(), at_seat->block()));
    if (at_seat->running()) put(kRunning, "●");
    put(kKey, short_name(at_seat->last_key()));
    if (at_seat->errors_last_minute() != 0) put(kErrors, fmt::format("{:3}", at_seat->errors_last_minute()));
    put(kLink, at_seat->connected() ? say({"ja", "yes"}) : say({"FEHLT", "LOST"}));
    if (at_seat->meldung() != 0) put(kHand, fmt::format("{}.", at_seat->meldung()));
    if (at_seat->remote() && control_of(seat).empty()) put(kControl, "REMOTE");  // its control listens to a computer
    if (at_seat->locked()) put(kControl, say({"gesperrt", "locked"}));
    if (!at_seat->taken_by().empty()) put(kControl, at_seat->taken_by());
  }

  /// Of the chosen seat, whose column is too narrow for it.
  void draw_long_name() {
    const auto* const chosen = model_.status ? seat_of(*model_.status, model_.chosen) : nullptr;
    if (chosen == nullptr || from_utf8(chosen->user()).size() <= static_cast<std::size_t>(kName.width)) return;
    screen_.write(kLongNameRow, kName.at, chosen->user(), Attribute::dim);
  }

  [[nodiscard]] std::string_view control_of(int seat) const {
    const auto station = static_cast<std::uint32_t>(seat);
    if (model_.status->selected() == station) return "►";
    if (model_.status->offered() == station) return say({"gefragt", "asked"});
    return "";
  }

  [[nodiscard]] std::string_view state_text(const std::string& state) const {
    struct Row {
      std::string_view state;
      Text text;
    };
    static constexpr std::array<Row, 5> kStates{{{"standstill", {"STEHT", "STANDSTILL"}},
                                                 {"moving", {"FÄHRT", "MOVING"}},
                                                 {"stopping", {"BREMST", "STOPPING"}},
                                                 {"halted", {"HALT", "HALTED"}},
                                                 {"off", {"STROMLOS", "POWER OFF"}}}};
    for (const auto& row : kStates) {
      if (row.state == state) return say(row.text);
    }
    return state;
  }

  void draw_machine() {
    const Attribute attribute = model_.link == Link::lost ? Attribute::dim : Attribute::normal;
    screen_.write(kMachineRow, 1, say({"Maschine", "Machine"}), Attribute::bold);
    if (!model_.status) return screen_.write(kMachineRow, 11, say({"noch keine Angaben", "nothing known yet"}));
    const auto& machine = model_.status->machine();
    screen_.write(kMachineRow, 11, state_text(machine.state()), attribute, 10);
    screen_.write(kMachineRow, 22,
                  fmt::format("X{:+09.3f} Y{:+09.3f} Z{:+09.3f}", machine.x(), machine.y(), machine.z()), attribute);
    screen_.write(kMachineRow, 58, fmt::format("F{:4.0f} S{:+05.0f}", machine.feed(), machine.spindle()), attribute);
    if (!machine.referenced()) screen_.write(kMachineRow, 71, say({"UNREF.", "UNREF."}), attribute);
  }

  void draw_ticks() {
    if (!model_.status) return;
    const auto& status = *model_.status;
    const std::string lease = fmt::format("{} {:.0f}", say({"Freigabe Nr", "lease no."}), status.lease());
    if (!status.halted_by().empty()) {  // who pressed it, whole; the tick can wait (AUTH-006)
      screen_.write(kTickRow, 1, fmt::format("HALT: {}", status.halted_by()), Attribute::inverse,
                    kLeaseColumnInHalt - 2);
      return screen_.write(kTickRow, kLeaseColumnInHalt, lease);
    }
    screen_.write(kTickRow, kLeaseColumn, lease);
    screen_.write(kTickRow, 1, say({"Takt", "Tick"}), Attribute::bold);
    screen_.write(kTickRow, 11,
                  fmt::format("{} {:.0f}, {} {:.2f} ms", say({"verspätet", "late"}), status.ticks().late(),
                              say({"längster", "longest"}), status.ticks().longest_ms()));
    if (status.machine().damaged_data_size() > 0) screen_.write(kTickRow, 62, "CHECKSUM FEHLER", Attribute::inverse);
  }

  void draw_page() {
    const int lines = static_cast<int>(model_.page.size());
    screen_.write(1, 1,
                  fmt::format("{}-{} / {}", model_.page_top + 1, std::min(lines, model_.page_top + kPageLines), lines),
                  Attribute::bold);
    for (int i = 0; i < kPageLines && model_.page_top + i < lines; ++i)
      screen_.write(kFirstSeatRow + i, 1,
                    model_.page[static_cast<std::size_t>(model_.page_top) + static_cast<std::size_t>(i)],
                    Attribute::normal, Screen::kColumns - 2);
  }

  /// In this row, a long one in two: `row` is the last of them.
  void write_message(int row, Attribute attribute) {
    const std::u32string text = from_utf8(model_.message.text);
    const std::size_t end = break_of(text);
    const bool is_long = end < text.size();
    screen_.write(is_long ? row - 1 : row, 1, to_utf8(text.substr(0, end)), attribute);
    if (!is_long) return;
    const std::size_t rest = text[end] == U' ' ? end + 1 : end;
    screen_.write(row, 1, to_utf8(text.substr(rest)), attribute, kTextWidth);
  }

  /// Where it is longer than the row its end stays in sight.
  void draw_entry() {
    std::u32string text = U":" + from_utf8(model_.entry) + U"_";
    if (text.size() > kTextWidth) text = U"…" + text.substr(text.size() - kTextWidth + 1);
    screen_.write(kMessageRow - 1, 1, to_utf8(text), Attribute::bold);
    write_message(kMessageRow + 1, Attribute::inverse);
  }

  /// What waits for a yes or no; nothing where nothing does.
  [[nodiscard]] std::optional<std::string> question() const {
    if (model_.overlay == Overlay::ask_quit && model_.status) {
      const Text quit{"Platz {} hat die Steuerung und behält sie. Beenden? j/n",
                      "Station {} has control and keeps it. Quit? y/n"};
      return fmt::format(fmt::runtime(say(quit)), model_.status->selected());
    }
    if (model_.overlay != Overlay::ask_erase || !model_.asked_about) return std::nullopt;
    const Text erase{"{}: Konto und Programme für immer löschen? j/n", "{}: delete account and programs for good? y/n"};
    return fmt::format(fmt::runtime(say(erase)), model_.asked_about->student_remove().name());
  }

  void draw_message() {
    if (model_.overlay == Overlay::entry) return draw_entry();
    if (const auto asked = question()) return screen_.write(kMessageRow, 1, *asked, Attribute::inverse);
    const auto attribute = model_.message.is_error ? Attribute::inverse : Attribute::normal;
    write_message(kMessageRow, attribute);
  }

  void draw_keys() {
    if (model_.overlay == Overlay::page) return draw_page_keys();
    if (model_.overlay != Overlay::entry)
      write_keys(kKeysRow - 1, {"w Bild  t Tastatur  l sperren  v zeigen  m Nachricht  x abmelden  : Befehl",
                                "w watch  t keyboard  l lock  v show to all  m message  x expel  : command"});
    write_keys(kKeysRow, {"1-9 ↑↓  s wählen  r zurück  F12/h HALT  c Halt auf  p Strom  ? Hilfe  q Ende",
                          "1-9 ↑↓  s select  r release  F12/h HALT  c clear halt  p power  ? help  q quit"});
  }

  void draw_page_keys() {
    write_keys(kKeysRow - 1, {"↑↓ Zeile   Leertaste Bild↓ Bild↑ Seite   Pos1 Anfang   Ende Schluss",
                              "↑↓ line   Space PgDn PgUp page   Home beginning   End end"});
    write_keys(kKeysRow, {"q Esc Enter zurück zur Tafel   : Befehl   F12/h HALT",
                          "q Esc Enter back to the table   : command   F12/h HALT"});
  }

  void write_keys(int row, const Text& keys) { screen_.write(row, 1, say(keys), Attribute::dim, Screen::kColumns - 1); }

  void draw_help() {
    static constexpr std::array<Text, 16> kLines{{
        {"1-9 ↑ ↓ Maus  Platz wählen            s Enter  Maschine anbieten (S: mit Halt)",
         "1-9 ↑ ↓ mouse choose a station        s Enter  offer the machine (S: stops it)"},
        {"r             zurücknehmen (R: mit Halt)    p  Antriebe stromlos, wieder ein",
         "r             take it back (R: stops it)    p  drives without current, back on"},
        {"F12 h         MASCHINE HALT: Rampe, Spindel und Kühlmittel aus; c hebt ihn auf",
         "F12 h         MACHINE HALT: ramp, spindle and coolant off; c clears it"},
        {"w             Bild des Platzes ansehen      v  sein Bild allen zeigen, v endet",
         "w             watch the station's screen    v  show it to all, v again ends"},
        {"t             Tastatur übernehmen, F8 gibt zurück (g: auch von hier)",
         "t             take the keyboard over, F8 gives it back (g: from here too)"},
        {"l             Tastatur sperren, freigeben   x  Platz abmelden (mit Enter)",
         "l             lock and unlock the keyboard  x  end its connection (with Enter)"},
        {"m M           Nachricht an den Platz, an alle", "m M           message to the station, to all"},
        {":             jeder Befehl wie auf der Kommandozeile, zum Beispiel:",
         ":             every command as on the command line, for example:"},
        {"   students   student add NAME   student password NAME   import liste.csv",
         "   students   student add NAME   student password NAME   import list.csv"},
        {"   programs NAME   program show NAME P0001   program send datei.tape --all",
         "   programs NAME   program show NAME P0001   program send file.tape --all"},
        {"   program collect ORDNER   program versions NAME P0001",
         "   program collect FOLDER   program versions NAME P0001"},
        {"   program restore NAME P0001 3   runs NAME   journal NAME   backup datei.db",
         "   program restore NAME P0001 3   runs NAME   journal NAME   backup file.db"},
        {"q             Konsole beenden", "q             quit the console"},
        {"F12 und p ersetzen kein NOT-HALT: der ist ein Schalter an der Maschine.",
         "F12 and p are no emergency stop: that is a switch at the machine."},
        {"► steuert die Maschine  ● läuft  Hand: Reihenfolge  Fehl: letzte Minute",
         "► has the machine  ● runs  Hand: order of hands  Err.: in the last minute"},
        {"Jede Taste schließt diese Seite.", "Any key closes this page."},
    }};
    int row = kFirstSeatRow;
    for (const auto& line : kLines) screen_.write(row++, 1, say(line));
  }

  const ConsoleModel& model_;
  Screen screen_;
};

}  // namespace

Drawn draw_console(const ConsoleModel& model, int columns) {
  const bool is_watching = model.overlay == Overlay::watching;
  if (!is_watching) return {Drawing(model).draw_seats(), std::nullopt};
  if (columns < kWideColumns) return {Drawing(model).draw_watched(), std::nullopt};
  return {Drawing(model).draw_seats(), Drawing(model).draw_watched()};
}

}  // namespace cnclab::instructor
