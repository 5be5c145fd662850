// The keys of a form.
#include "station/form_keys.hpp"

#include <algorithm>

namespace cnclab::station {

FormAct lead_through(Special key, std::size_t fields, std::size_t& current) {
  switch (key) {
    case Special::escape:
    case Special::ctrl_c:
      return FormAct::cancel;
    case Special::backspace:
      return FormAct::erase;
    case Special::up:
      current -= std::min<std::size_t>(current, 1);
      return FormAct::none;
    case Special::down:
      current = std::min(current + 1, fields - 1);
      return FormAct::none;
    case Special::tab:
      current = (current + 1) % fields;
      return FormAct::none;
    case Special::enter:
      if (current + 1 == fields) return FormAct::submit;
      ++current;
      return FormAct::none;
    default:
      return FormAct::none;
  }
}

}  // namespace cnclab::station
