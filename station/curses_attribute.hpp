// How a cell of a Screen looks in a terminal; included behind <curses.h> by those who draw.
#pragma once

#include <curses.h>

#include "shared/screen.hpp"

namespace cnclab::station {

[[nodiscard]] inline attr_t curses_attribute(Attribute attribute) {
  switch (attribute) {
    case Attribute::normal:
      return A_NORMAL;
    case Attribute::inverse:
      return A_REVERSE;
    case Attribute::bold:
      return A_BOLD;
    case Attribute::dim:
      return A_DIM;
  }
  return A_NORMAL;
}

}  // namespace cnclab::station
