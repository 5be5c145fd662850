// Keys and screen of the machine data; which values are allowed is machine_data.hpp's.
#include "panel/modes/machine_data_mode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "panel/screen/names.hpp"

namespace cnclab::panel {

namespace {

constexpr int kTime = 1, kDate = 2;
constexpr int kPolarity = 19, kBaudRate = 20;

struct DatumName {
  int number;
  Text text;
};

constexpr std::array kNames{
    DatumName{kTime, Text::datum_time},     DatumName{kDate, Text::datum_date},
    DatumName{3, Text::datum_x_travel},     DatumName{4, Text::datum_y_travel},
    DatumName{5, Text::datum_z_travel},     DatumName{6, Text::datum_f_max},
    DatumName{7, Text::datum_s_max},        DatumName{9, Text::datum_stop_deceleration},
    DatumName{10, Text::datum_start_stop},  DatumName{11, Text::datum_creep},
    DatumName{12, Text::datum_ramp},        DatumName{14, Text::datum_x_steps},
    DatumName{15, Text::datum_y_steps},     DatumName{16, Text::datum_z_steps},
    DatumName{17, Text::datum_u_steps},     DatumName{kPolarity, Text::datum_polarity},
    DatumName{kBaudRate, Text::datum_baud}, DatumName{22, Text::datum_beeper},
};

const DatumName* name_of_datum(int number) { return std::ranges::find(kNames, number, &DatumName::number); }

/// D-113: after 22 again 01.
int next_after(int number) {
  const DatumName* name = name_of_datum(number);
  return name + 1 == kNames.end() ? kNames.front().number : (name + 1)->number;
}

const machine::DatumForm* form_of(int number) {
  const auto forms = machine::datum_forms();
  const auto found = std::ranges::find(forms, number, &machine::DatumForm::number);
  return found == forms.end() ? nullptr : &*found;
}

/// Three numbers of two digits as one of six, as MD 01 and 02 show them.
int six_digits(int first, int second, int third) { return (first * 100 + second) * 100 + third; }

bool set_clock(const MachineDataMode& mode, ControlState& state) {
  const int value = *mode.value.value;
  const int first = value / 10'000, second = value / 100 % 100, third = value % 100;
  return mode.number == kTime ? state.clock.set_time(state.now, first, second, third)
                              : state.clock.set_date(state.now, first, second, third);
}

/// What is allowed, for row 18. F START/STOP is at most F MAX.
std::string range_text(int number, const machine::MachineData& data, language::Tongue tongue) {
  constexpr int kFMax = 6, kFStartStop = 10;
  if (number == kTime) return "00 00 00 - 23 59 59";
  if (number == kDate) return std::string(text(Text::datum_date, tongue));
  if (number == kPolarity) return "201, 51503";
  if (number == kBaudRate) return "300, 600, 1200, 2400, 4800";
  const machine::DatumForm* form = form_of(number);
  if (form == nullptr) return "";
  const std::int64_t least = number == kFMax ? data.get(kFStartStop) : form->least;
  const std::int64_t most = number == kFStartStop ? data.get(kFMax) : form->most;
  const std::string other = number == kFMax ? " (MD 10 - 9999)" : number == kFStartStop ? " (1 - MD 06)" : "";
  return std::to_string(least) + " - " + std::to_string(most) + other;
}

void refuse(MachineDataMode& mode, ControlState& state) {
  state.message =
      Message{std::string(text(Text::datum_refused, state.tongue())), 0,
              text(Text::said_datum_refused, state.tongue(),
                   {block_text(mode.number).substr(1), range_text(mode.number, state.data, state.tongue())})};
  show_datum(mode, state, mode.number);
}

/// → or EINGABE: an invalid value is not taken over (D-112).
void take_over(MachineDataMode& mode, ControlState& state) {
  const int next = next_after(mode.number);
  if (mode.value.typed == 0 || !mode.value.value) return show_datum(mode, state, next);
  if (mode.number == kTime || mode.number == kDate)
    return set_clock(mode, state) ? show_datum(mode, state, next) : refuse(mode, state);
  machine::MachineData data = state.data;
  if (!data.set(mode.number, *mode.value.value)) return refuse(mode, state);
  if (data == state.data) return show_datum(mode, state, next);
  state.storing = PutMachineData{std::move(data)};
}

std::string value_text(const MachineDataMode& mode) {
  std::string digits = mode.value.text();
  if (mode.number != kTime && mode.number != kDate) return digits;
  return digits.substr(0, 2) + ' ' + digits.substr(2, 2) + ' ' + digits.substr(4);
}

}  // namespace

MachineDataMode open_machine_data(const ControlState& state) {
  MachineDataMode mode;
  show_datum(mode, state, kTime);
  return mode;
}

void show_datum(MachineDataMode& mode, const ControlState& state, int number) {
  mode.number = number;
  constexpr int kClockDigits = 6;
  const WallClock wall = state.clock.at(state.now);
  if (number == kTime || number == kDate) {
    mode.value = DigitField{kClockDigits, {}, 0};
    mode.value.offer(number == kTime ? six_digits(wall.hour, wall.minute, wall.second)
                                     : six_digits(wall.year, wall.month, wall.day));
    return;
  }
  const machine::DatumForm* form = form_of(number);
  mode.value = DigitField{static_cast<int>(std::to_string(form->most).size()), {}, 0};
  mode.value.offer(static_cast<int>(state.data.get(number)));
}

Place place_of(const MachineDataMode&) { return Place::machine_data; }

void press(MachineDataMode& mode, ControlState& state, Effect effect, int figure) {
  switch (effect) {
    case Effect::digit:
      return mode.value.digit(figure);
    case Effect::clear:
      return mode.value.clear();
    case Effect::enter:
      return take_over(mode, state);
    default:
      return;
  }
}

void stored(MachineDataMode& mode, ControlState& state, const StoreRequest& request) {
  if (!std::holds_alternative<PutMachineData>(request)) return;
  (void)state.apply_data();  // where the machine does not stand still, the next START tries again
  show_datum(mode, state, next_after(mode.number));
}

void follow(MachineDataMode& mode, ControlState& state) {
  if (!mode.awaits_clock) return;
  mode.awaits_clock = false;
  show_datum(mode, state, mode.number);
}

void draw(const MachineDataMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kRow = 4, kNameColumn = 7, kValueColumn = 27, kUnitColumn = 37;
  monitor.write(kRow, 0, "NR " + block_text(mode.number).substr(1));
  monitor.write(kRow, kNameColumn, text(name_of_datum(mode.number)->text, state.tongue()));
  monitor.write(kRow, kValueColumn, value_text(mode), Attribute::inverse);
  if (const machine::DatumForm* form = form_of(mode.number)) monitor.write(kRow, kUnitColumn, form->unit);
}

bool has_datum(int number) { return name_of_datum(number) != kNames.end(); }

std::string machine_data_list(const machine::MachineData& data, language::Tongue tongue) {
  std::string list = std::string(title_of(Mode::machine_data, tongue)) + "\n\n";
  for (const machine::DatumForm& form : machine::datum_forms())
    list += fmt::format("{:02}  {:<22} {:>8} {}\n", form.number, text(name_of_datum(form.number)->text, tongue),
                        data.get(form.number), form.unit);
  return list;
}

std::string sentence_of(const MachineDataMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (state.storing) return std::string(text(Text::wait_store, tongue));
  return text(Text::wait_machine_data, tongue, {range_text(mode.number, state.data, tongue)});
}

}  // namespace cnclab::panel
