// The menu is drawn from the key table, so it can only offer what its keys do.
#include "panel/modes/menu_mode.hpp"

#include "panel/key_table.hpp"
#include "panel/screen/names.hpp"

namespace cnclab::panel {

void draw(const MenuMode&, const ControlState& state, Monitor& monitor) {
  constexpr int kFirstRow = 4, kKeyColumn = 2, kNameColumn = 21;
  int row = kFirstRow;
  for (const KeyRow& entry : key_table()) {
    if (entry.place != Place::menu) continue;
    if (!has_row(entry, state.settings.vocabulary)) {  // its line stays blank (MODEL-003)
      ++row;
      continue;
    }
    const bool is_lit = state.settings.remote && entry.effect == Effect::open_external_data;
    monitor.put(row, 0, U'□', is_lit ? Attribute::inverse : Attribute::normal);
    monitor.write(row, kKeyColumn, label_of(entry.first));
    monitor.write(row, kNameColumn, text(entry.help, state.tongue()));
    ++row;
  }
}

}  // namespace cnclab::panel
