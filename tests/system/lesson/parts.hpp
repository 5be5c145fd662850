// The fifteen parts of the lesson: for each student a drawing, and the program that the student writes for it.
#pragma once

#include <string>
#include <vector>

#include "drawing.hpp"
#include "keying.hpp"

namespace cnclab::lesson {

/// A dwell that the drawing's worksheet asks for.
struct Rest {
  Point at{};
  double seconds = 0;
};

struct Part {
  std::string student;
  std::string title;
  std::vector<WrittenProgram> programs;  ///< P0001 first; keyed in in this order
  std::vector<Curve> curves;             ///< the tool's way from where it stands at START
  std::string view = "xy";               ///< for the picture: xy, xz, yz or iso
  bool is_absolute = false;              ///< moves under G90: the zero is confirmed by a second START (DEC-27)
  std::vector<Rest> rests;
  Point shown_at_end{};  ///< Istwert at the end, begun at 0 / 0 / 0; differs where G68 renames the place
};

/// One for each station, 1 to 15 in this order; all end where they began.
[[nodiscard]] std::vector<Part> parts();

}  // namespace cnclab::lesson
