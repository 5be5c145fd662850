// The clock of one control: the lab's time, moved by what MD 01 and 02 have set (MD-101, MD-102, DEC-10, D-33).
//
//   lab's clock with a date     ──▶ + offset; the offset is kept with the student
//   clock of a control just switched on, 00:00:00 00/00/00 ──▶ runs from what was set; without a date no day changes.
//   What it stood at when the student left is kept, and it goes on from there at the next login (STO-001).
#pragma once

#include <cstdint>
#include <optional>

#include "panel/control.hpp"

namespace cnclab::panel {

class PanelClock {
 public:
  /// What the header shows.
  [[nodiscard]] WallClock at(const Now& now) const;

  /// errors   false where there is no such time or day; nothing changed
  [[nodiscard]] bool set_time(const Now& now, int hour, int minute, int second);
  /// year   of the century
  [[nodiscard]] bool set_date(const Now& now, int year, int month, int day);

  /// What a clock without the lab's date stands at, once it was set.
  struct Standing {
    std::int64_t seconds = 0;
    bool has_date = false;
  };
  [[nodiscard]] std::optional<Standing> standing(const Now& now) const;
  /// A kept clock: it stands until `run_on` is called for the first time.
  void stand_at(const Standing& standing) { own_ = Own{std::nullopt, standing.seconds, standing.has_date}; }
  /// With every beat.
  void run_on(const Now& now) {
    if (own_ && !own_->set_ns) own_->set_ns = now.monotonic_ns;
  }

  [[nodiscard]] std::int64_t offset_s() const { return offset_s_; }
  void set_offset_s(std::int64_t offset_s) { offset_s_ = offset_s; }

 private:
  /// The clock of a control that has no date of its own: what it was set to, and when.
  struct Own {
    std::optional<std::int64_t> set_ns;  ///< monotonic; nothing: it stands
    std::int64_t set_to_s = 0;
    bool has_date = false;
  };

  [[nodiscard]] std::int64_t seconds_at(const Now& now) const;
  void move_to(const Now& now, std::int64_t seconds, bool has_date);

  std::int64_t offset_s_ = 0;
  std::optional<Own> own_;
};

}  // namespace cnclab::panel
