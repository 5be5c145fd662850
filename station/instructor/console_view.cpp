// The console's screen, drawn from what it knows.
#include "instructor/console_view.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace cnclab::instructor {
namespace {

using station::Language;
using station::Text;

constexpr int kMachineRow = 18, kTickRow = 19, kMessageRow = 21, kKeysRow = 23;

/// Columns of the table of seats.
struct Column {
  int at;
  int width;
  Text heading;
};
constexpr Column kSeat{3, 5, {"Platz", "Seat"}}, kName{9, 16, {"Name", "Name"}}, kMode{26, 15, {"Betriebsart", "Mode"}},
    kProgram{42, 10, {"Programm", "Program"}}, kRunning{53, 5, {"läuft", "runs"}}, kLink{59, 5, {"Netz", "Line"}},
    kHand{65, 4, {"Hand", "Hand"}}, kControl{70, 9, {"Maschine", "Machine"}};

class Drawing {
 public:
  explicit Drawing(const ConsoleModel& model) : model_(model) {}

  [[nodiscard]] Screen draw() {
    draw_title();
    if (model_.overlay == Overlay::help) {
      draw_help();
    } else {
      draw_headings();
      for (int seat = 1; seat <= kSeats; ++seat) draw_seat(seat);
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
    screen_.write(0, 1, say({"LEHRERKONSOLE", "INSTRUCTOR"}), Attribute::inverse);
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
    for (const auto& column : {kSeat, kName, kMode, kProgram, kRunning, kLink, kHand, kControl}) {
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
    put(kName, at_seat->user());
    put(kMode, at_seat->mode());
    if (at_seat->program() != 0) put(kProgram, fmt::format("P{:04} N{:03}", at_seat->program(), at_seat->block()));
    if (at_seat->running()) put(kRunning, "●");
    put(kLink, at_seat->connected() ? say({"ja", "yes"}) : say({"FEHLT", "LOST"}));
    if (at_seat->meldung() != 0) put(kHand, fmt::format("{}.", at_seat->meldung()));
    if (at_seat->locked()) put(kControl, say({"gesperrt", "locked"}));
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
    screen_.write(kTickRow, 1, say({"Takt", "Tick"}), Attribute::bold);
    screen_.write(kTickRow, 11,
                  fmt::format("{} {:.0f}, {} {:.2f} ms", say({"verspätet", "late"}), status.ticks().late(),
                              say({"längster", "longest"}), status.ticks().longest_ms()));
    screen_.write(kTickRow, 44, fmt::format("{} {:.0f}", say({"Freigabe Nr", "lease no."}), status.lease()));
    if (!status.halted_by().empty()) {
      screen_.write(kTickRow, 62, fmt::format("HALT: {}", status.halted_by()), Attribute::inverse, 17);
    }
  }

  void draw_message() {
    if (model_.overlay == Overlay::ask_quit && model_.status) {
      const Text question{"Platz {} hat die Steuerung und behält sie. Beenden? j/n",
                          "Seat {} has control and keeps it. Quit? y/n"};
      screen_.write(kMessageRow, 1, fmt::format(fmt::runtime(say(question)), model_.status->selected()),
                    Attribute::inverse);
      return;
    }
    const auto attribute = model_.message.is_error ? Attribute::inverse : Attribute::normal;
    screen_.write(kMessageRow, 1, model_.message.text, attribute, Screen::kColumns - 2);
  }

  void draw_keys() {
    screen_.write(kKeysRow, 1,
                  say({"1-9 ↑↓  s wählen  r zurück  F12/h HALT  c Halt auf  p Strom  ? Hilfe  q Ende",
                       "1-9 ↑↓  s select  r release  F12/h HALT  c clear halt  p power  ? help  q quit"}),
                  Attribute::dim, Screen::kColumns - 1);
  }

  void draw_help() {
    static constexpr std::array<Text, 15> kLines{{
        {"1 bis 9, ↑ ↓, Maus   Platz wählen", "1 to 9, ↑ ↓, mouse   choose a seat"},
        {"s oder Eingabetaste  Platz die Maschine anbieten; er nimmt mit START an",
         "s or Enter           offer the machine to the seat; it accepts with START"},
        {"S                    auch während sie fährt: hält erst auf der Rampe an",
         "S                    also while it moves: stops on the ramp first"},
        {"r                    Steuerung zurücknehmen", "r                    take control back"},
        {"R                    auch während sie fährt", "R                    also while it moves"},
        {"F12 oder h           MASCHINE HALT: Rampe, Spindel und Kühlmittel aus",
         "F12 or h             MACHINE HALT: ramp, spindle and coolant off"},
        {"c                    Halt aufheben", "c                    clear the halt"},
        {"p                    Antriebe stromlos, noch einmal: wieder ein",
         "p                    drives without current, again: on"},
        {"q                    Konsole beenden", "q                    quit the console"},
        {"", ""},
        {"F12 und p ersetzen kein NOT-HALT: der ist ein Schalter an der Maschine.",
         "F12 and p are no emergency stop: that is a switch at the machine."},
        {"", ""},
        {"►                    dieser Platz steuert die Maschine",
         "►                    this seat controls the machine"},
        {"Hand                 Reihenfolge der Meldungen", "Hand                 order of raised hands"},
        {"Jede Taste schließt diese Seite.", "Any key closes this page."},
    }};
    int row = kFirstSeatRow;
    for (const auto& line : kLines) screen_.write(row++, 2, say(line));
  }

  const ConsoleModel& model_;
  Screen screen_;
};

}  // namespace

Screen draw_console(const ConsoleModel& model) { return Drawing(model).draw(); }

}  // namespace cnclab::instructor
