// One key into the line.
#include "panel/modes/line_keys.hpp"

namespace cnclab::panel {

bool key_into(EntryLine& line, Effect effect, int figure) {
  if (effect == Effect::digit)
    line.digit(figure);
  else if (effect == Effect::point)
    line.point();
  else if (effect == Effect::sign)
    line.sign();
  else
    return false;
  return true;
}

}  // namespace cnclab::panel
