// Machine data: their table, their checks, what they mean for motion.
#include "machine/machine_data.hpp"

#include <algorithm>
#include <array>

namespace cnclab::machine {

namespace {

// D-112; units as the control shows them.
constexpr std::array<DatumForm, 16> kForms{{
    {3, "X ACHSE", "1/1000 mm", 1, 9'999'999, 500'000},
    {4, "Y ACHSE", "1/1000 mm", 1, 9'999'999, 500'000},
    {5, "Z ACHSE", "1/1000 mm", 1, 9'999'999, 500'000},
    {6, "F MAX", "mm/min", 1, 9999, 3000},
    {7, "S MAX", "1/min", 1, 9999, 3000},
    {9, "STOPVERZÖGERUNG", "", 1, 99, 2},
    {10, "F START/STOP", "mm/min", 1, 9999, 300},
    {11, "SCHLEICHWEG", "1/1000 mm", 0, 9999, 500},
    {12, "RAMPE", "mm/min", 1, 9999, 100},
    {14, "X SCHRITTE/MM", "1/mm", 1, 9999, 200},
    {15, "Y SCHRITTE/MM", "1/mm", 1, 9999, 200},
    {16, "Z SCHRITTE/MM", "1/mm", 1, 9999, 200},
    {17, "U SCHRITTE/MM", "1/mm", 1, 9999, 200},
    {19, "ENDSCHALTER POL", "", 201, 51503, 201},
    {20, "BAUDRATE", "baud", 300, 4800, 1200},
    {22, "PIEPSER", "", 0, 1, 1},
}};

constexpr std::array<std::int64_t, 2> kPolarities{201, 51503};
constexpr std::array<std::int64_t, 5> kBaudRates{300, 600, 1200, 2400, 4800};  // EXT-045

constexpr int kFMax = 6, kFStartStop = 10;

const DatumForm* form_of(int number) {
  const auto* form = std::ranges::find(kForms, number, &DatumForm::number);
  return form == kForms.end() ? nullptr : form;
}

}  // namespace

std::span<const DatumForm> datum_forms() { return kForms; }

MachineData::MachineData() {
  for (const DatumForm& form : kForms) values_[form.number] = form.standard;
}

std::int64_t MachineData::get(int number) const {
  const auto place = values_.find(number);
  return place == values_.end() ? 0 : place->second;
}

std::expected<void, std::string_view> MachineData::set(int number, std::int64_t value) {
  const DatumForm* form = form_of(number);
  if (form == nullptr) return std::unexpected("no such machine datum; there are 03-07, 09-12, 14-17, 19, 20, 22");
  if (value < form->least || value > form->most) return std::unexpected("outside the limits of this datum");
  if (number == 19 && std::ranges::find(kPolarities, value) == kPolarities.end()) {
    return std::unexpected("ENDSCHALTER POL is 201 or 51503");
  }
  if (number == 20 && std::ranges::find(kBaudRates, value) == kBaudRates.end()) {
    return std::unexpected("BAUDRATE is 300, 600, 1200, 2400 or 4800");
  }
  const std::int64_t f_max = number == kFMax ? value : get(kFMax);
  const std::int64_t start_stop = number == kFStartStop ? value : get(kFStartStop);
  if (start_stop > f_max) return std::unexpected("F START/STOP would be above F MAX");
  values_[number] = value;
  return {};
}

motion::Limits motion_limits(const MachineData& data) {
  constexpr double kSecondsPerMinute = 60, kRampPeriod_s = 0.01;
  const auto value = [&data](int number) { return static_cast<double>(data.get(number)); };
  motion::Limits limits;
  limits.f_max_mm_per_s = value(kFMax) / kSecondsPerMinute;
  limits.start_stop_mm_per_s = std::min(value(kFStartStop), value(kFMax)) / kSecondsPerMinute;
  limits.acceleration_mm_per_s2 = value(12) / kSecondsPerMinute / kRampPeriod_s;
  limits.stop_deceleration_mm_per_s2 = limits.acceleration_mm_per_s2 / (1 + value(9) / 10);
  limits.creep_way_mm = value(11) / 1000;
  for (std::size_t axis = 0; axis < 4; ++axis) limits.steps_per_mm[axis] = value(14 + static_cast<int>(axis));
  return limits;
}

MachineData on_lab_machine(const MachineData& student, const MachineData& lab) {
  MachineData both = student;
  for (const int number : {3, 4, 5, 6, 7}) both.values_[number] = std::min(student.get(number), lab.get(number));
  // F START/STOP stays the machine's even where the student's F MAX is below it; motion_limits keeps to the smaller.
  for (const int number : {9, 10, 11, 12, 14, 15, 16, 17, 19}) both.values_[number] = lab.get(number);
  return both;
}

}  // namespace cnclab::machine
