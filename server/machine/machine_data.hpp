// The machine data of chapter 5: numbers 01 to 22, their formats, limits and defaults (MD-101 to MD-122, D-112).
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "motion/limits.hpp"

namespace cnclab::machine {

/// One machine datum as the control shows and checks it.
struct DatumForm {
  int number = 0;                                  ///< 3..22; 01 and 02 (clock, date) are no machine data of the store
  std::string_view text;                           ///< "X ACHSE", "F MAX", …
  std::string_view unit;                           ///< "1/1000 mm", "mm/min", …
  std::int64_t least = 0, most = 0, standard = 0;  ///< standard = EPROM set
};

[[nodiscard]] std::span<const DatumForm> datum_forms();

/// A complete, valid set. Value type; made from the EPROM set and changed number by number.
class MachineData {
 public:
  MachineData();  ///< EPROM set (D-112)

  [[nodiscard]] std::int64_t get(int number) const;
  /// errors: the reason in a few words (unknown number, outside limits, F START/STOP above F MAX); nothing changed
  [[nodiscard]] std::expected<void, std::string_view> set(int number, std::int64_t value);

  friend bool operator==(const MachineData&, const MachineData&) = default;
  friend MachineData on_lab_machine(const MachineData& student, const MachineData& lab);

 private:
  std::map<int, std::int64_t> values_;
};

/// RAMPE per 10 ms, STOPVERZÖGERUNG, F START/STOP … in mm and seconds (DEC-20).
[[nodiscard]] motion::Limits motion_limits(const MachineData& data);

/// The data that hold when a student's control runs the lab machine (DEC-25): MD 03–07 the smaller of both, 09–12,
/// 14–17, 19 the machine's, the rest the student's.
[[nodiscard]] MachineData on_lab_machine(const MachineData& student, const MachineData& lab);

/// Why a machine-data file cannot be used.
struct DataFileFault {
  int line = 0;  ///< from 1
  std::string reason;
};

/// A machine-data file: one `NN = value` per line, `#` starts a comment, what is missing keeps its default.
[[nodiscard]] std::expected<MachineData, DataFileFault> read_machine_data(std::string_view text);

}  // namespace cnclab::machine
