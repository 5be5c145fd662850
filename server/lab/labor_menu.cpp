// Keys and picture of the lab's own menu.
#include "lab/labor_menu.hpp"

namespace cnclab::lab {

LaborChoice labor_choice(Key key) {
  if (key == Key::LABOR) return LaborChoice::open_or_close;
  if (key == Key::CLEAR || key == Key::MENU) return LaborChoice::close;
  if (key == Key::D1) return LaborChoice::log_out;
  return LaborChoice::none;
}

void draw_labor_menu(Screen& screen, language::Tongue tongue) {
  const bool german = tongue == language::Tongue::german;
  for (int row = 18; row < Screen::kRows; ++row) screen.set_row(row, Screen::Row{});
  screen.write(18, 0, german ? "LABOR" : "LAB", Attribute::inverse);
  screen.write(18, 7, german ? "Was möchten Sie tun?" : "What would you like to do?");
  screen.write(20, 1, german ? "1 Abmelden" : "1 Log out");
  screen.write(22, 1, german ? "C oder LABOR: zurück zur Steuerung" : "C or LABOR: back to the control");
}

}  // namespace cnclab::lab
