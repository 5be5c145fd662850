// The console's screen as drawings (INS-001).
#include "instructor/console_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cnclab::instructor {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string trimmed(const Screen& screen, int row) {
  std::string text = screen.text(row);
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

ConsoleModel lesson() {
  ConsoleModel model;
  model.server = "127.0.0.1:3300";
  model.user = "lehrer";
  auto& status = model.status.emplace();
  status.set_selected(7);
  status.set_lease(12);
  auto& machine = *status.mutable_machine();
  machine.set_state("moving");
  machine.set_referenced(true);
  machine.set_x(85);
  machine.set_y(-60.5);
  machine.set_feed(1000);
  machine.set_spindle(-500);
  status.mutable_ticks()->set_longest_ms(0.25);
  auto& anna = *status.add_stations();
  anna.set_station(7);
  anna.set_user("anna");
  anna.set_mode("AUTOMAT");
  anna.set_program(1);
  anna.set_block(3);
  anna.set_running(true);
  anna.set_connected(true);
  anna.set_last_key("EINZELSATZ");
  auto& otto = *status.add_stations();
  otto.set_station(9);
  otto.set_user("otto");
  otto.set_mode("EINGABEMODUS");
  otto.set_meldung(1);
  otto.set_errors_last_minute(2);
  return model;
}

TEST(ConsoleView, INS_001_every_seat_has_a_line_with_who_what_and_control) {
  const Screen screen = draw_console(lesson()).screen;
  EXPECT_EQ(trimmed(screen, 1), "  Pl Name         Betriebsart      Programm   Netz  Hand Taste     Fehl Maschine");
  EXPECT_EQ(trimmed(screen, 8), "   7 anna         AUTOMAT         ●P0001 N003 ja         EINZELS.       ►");
  EXPECT_EQ(trimmed(screen, 10), "   9 otto         EINGABEMODUS                FEHLT 1.               2");
  EXPECT_EQ(trimmed(screen, 16), "  15 (frei)");
}

TEST(ConsoleView, INS_001_long_names_differ_where_they_do_and_the_chosen_one_is_told_whole) {
  ConsoleModel model = lesson();
  model.status->mutable_stations(0)->set_user("schueler-2026-01");
  model.status->mutable_stations(1)->set_user("schueler-2026-02");
  model.chosen = 9;
  const Screen screen = draw_console(model).screen;
  EXPECT_THAT(trimmed(screen, 8), testing::StartsWith("   7 schuel…26-01 AUTOMAT"));
  EXPECT_THAT(trimmed(screen, 10), testing::StartsWith(" > 9 schuel…26-02 EINGABEMODUS"));
  EXPECT_EQ(trimmed(screen, 17), "     schueler-2026-02");
}

TEST(ConsoleView, INS_004_the_question_before_somebody_is_deleted_names_who) {
  ConsoleModel model = lesson();
  model.overlay = Overlay::ask_erase;
  model.asked_about.emplace().mutable_student_remove()->set_name("anna");
  EXPECT_EQ(trimmed(draw_console(model).screen, 21), " anna: Konto und Programme für immer löschen? j/n");
}

TEST(ConsoleView, INS_001_the_name_of_every_key_fits_its_column) {
  for (int number = 1; number <= kKeys; ++number) {
    const std::string name(name_of(static_cast<Key>(number)));
    ConsoleModel model = lesson();
    model.status->mutable_stations(0)->set_last_key(name);
    const Screen screen = draw_console(model).screen;
    std::string shown;
    for (int column = 57; column < 67; ++column) shown += to_utf8(screen.at(8, column).code);
    shown.erase(shown.find_last_not_of(' ') + 1);
    if (name.size() <= 9)
      EXPECT_EQ(shown, name);
    else
      EXPECT_FALSE(name.starts_with(shown)) << "cut: " << shown;
  }
}

TEST(ConsoleView, INS_001_no_row_of_keys_is_cut) {
  for (const auto language : {station::Language::german, station::Language::english}) {
    ConsoleModel model = lesson();
    model.language = language;
    const Screen screen = draw_console(model).screen;
    EXPECT_THAT(trimmed(screen, 22), testing::EndsWith(language == station::Language::german ? "Befehl" : "command"));
    EXPECT_THAT(trimmed(screen, 23), testing::EndsWith(language == station::Language::german ? "Ende" : "quit"));
    model.overlay = Overlay::help;
    for (int row = 2; row < 18; ++row) EXPECT_EQ(draw_console(model).screen.at(row, 79).code, U' ') << row;
  }
}

TEST(ConsoleView, INS_002_a_long_answer_takes_two_rows) {
  ConsoleModel model = lesson();
  model.message = {"Mit diesen Daten dauert ein Halt aus F MAX über 2 s: RAMPE größer oder F MAX kleiner wählen.",
                   true};
  Screen screen = draw_console(model).screen;
  EXPECT_EQ(trimmed(screen, 20), " Mit diesen Daten dauert ein Halt aus F MAX über 2 s: RAMPE größer oder F MAX");
  EXPECT_EQ(trimmed(screen, 21), " kleiner wählen.");
  model.message = {"Halt aufgehoben."};
  screen = draw_console(model).screen;
  EXPECT_EQ(trimmed(screen, 20), "");
  EXPECT_EQ(trimmed(screen, 21), " Halt aufgehoben.");
}

TEST(ConsoleView, INS_005_the_end_of_a_long_command_and_its_error_stay_in_sight) {
  ConsoleModel model = lesson();
  model.overlay = Overlay::entry;
  model.entry = "message all " + std::string(80, 'a') + "!";
  model.message = {std::string(100, 'b'), true};
  const Screen screen = draw_console(model).screen;
  EXPECT_EQ(trimmed(screen, 20), " …" + std::string(75, 'a') + "!_");
  EXPECT_EQ(trimmed(screen, 21), " " + std::string(78, 'b'));
  EXPECT_EQ(trimmed(screen, 22), " " + std::string(22, 'b'));
  EXPECT_THAT(trimmed(screen, 23), HasSubstr("Ende"));
}

TEST(ConsoleView, KEY_008_a_station_under_REMOTE_says_so) {
  ConsoleModel model = lesson();
  for (auto& station : *model.status->mutable_stations()) station.set_remote(true);
  EXPECT_THAT(draw_console(model).screen.text(10), HasSubstr("REMOTE"));
  EXPECT_THAT(draw_console(model).screen.text(8), Not(HasSubstr("REMOTE"))) << "who has the machine is shown first";
}

TEST(ConsoleView, INS_001_machine_and_tick_have_a_line_each) {
  const Screen screen = draw_console(lesson()).screen;
  EXPECT_EQ(trimmed(screen, 18), " Maschine  FÄHRT      X+0085.000 Y-0060.500 Z+0000.000    F1000 S-0500");
  EXPECT_EQ(trimmed(screen, 19), " Takt      verspätet 0, längster 0.25 ms    Freigabe Nr 12");
}

TEST(ConsoleView, AUTH_012_an_unreferenced_machine_says_so) {
  ConsoleModel model = lesson();
  model.status->mutable_machine()->set_referenced(false);
  EXPECT_THAT(draw_console(model).screen.text(18), HasSubstr("UNREF."));
  EXPECT_THAT(draw_console(lesson()).screen.text(18), Not(HasSubstr("UNREF.")));
}

TEST(ConsoleView, AUTH_006_the_screen_names_who_halted) {
  ConsoleModel model = lesson();
  model.status->set_halted_by("Platz 9");
  EXPECT_THAT(draw_console(model).screen.text(19), HasSubstr("HALT: Platz 9"));
  const std::string longest = "Platz 13, " + std::string(32, 'n');
  model.status->set_halted_by(longest);
  EXPECT_THAT(draw_console(model).screen.text(19),
              AllOf(HasSubstr("HALT: " + longest + " "), HasSubstr("Freigabe Nr 12")));
}

TEST(ConsoleView, AUTH_005_an_offer_is_shown_at_its_seat) {
  ConsoleModel model = lesson();
  model.status->set_selected(0);
  model.status->set_offered(9);
  const Screen screen = draw_console(model).screen;
  EXPECT_THAT(screen.text(10), HasSubstr("gefragt"));
  EXPECT_THAT(screen.text(8), Not(HasSubstr("►")));
}

TEST(ConsoleView, the_chosen_seat_is_inverse_over_its_whole_row) {
  ConsoleModel model = lesson();
  model.chosen = 9;
  const Screen screen = draw_console(model).screen;
  EXPECT_EQ(screen.at(10, 0).attribute, Attribute::inverse);
  EXPECT_EQ(screen.at(10, 79).attribute, Attribute::inverse);
  EXPECT_EQ(screen.at(9, 0).attribute, Attribute::normal);
}

TEST(ConsoleView, SEAT_005_a_lost_line_is_never_shown_as_live) {
  ConsoleModel model = lesson();
  model.link = Link::lost;
  model.lost_for_s = 3;
  const Screen screen = draw_console(model).screen;
  EXPECT_THAT(screen.text(0), HasSubstr("VERBINDUNG VERLOREN 3 s"));
  EXPECT_EQ(screen.at(8, 9).attribute, Attribute::dim);
  EXPECT_EQ(screen.at(18, 22).attribute, Attribute::dim);
}

TEST(ConsoleView, before_the_first_status_nothing_is_claimed) {
  ConsoleModel model = lesson();
  model.status.reset();
  const Screen screen = draw_console(model).screen;
  EXPECT_EQ(trimmed(screen, 3), "   2");
  EXPECT_THAT(screen.text(18), HasSubstr("noch keine Angaben"));
}

TEST(ConsoleView, keys_stand_on_the_bottom_line_in_both_languages) {
  ConsoleModel model = lesson();
  for (const auto* key : {"1-9", "s ", "r ", "F12/h", "c ", "p ", "?", "q"}) {
    EXPECT_THAT(draw_console(model).screen.text(23), HasSubstr(key));
  }
  model.language = station::Language::english;
  for (const auto* key : {"1-9", "select", "release", "F12/h", "clear", "power", "? help", "q quit"}) {
    EXPECT_THAT(draw_console(model).screen.text(23), HasSubstr(key));
  }
}

TEST(ConsoleView, AUTH_010_the_help_page_says_that_an_emergency_stop_is_hardware) {
  ConsoleModel model = lesson();
  model.overlay = Overlay::help;
  const Screen screen = draw_console(model).screen;
  std::string all;
  for (int row = 0; row < Screen::kRows; ++row) all += screen.text(row);
  EXPECT_THAT(all, HasSubstr("kein NOT-HALT"));
  EXPECT_THAT(all, HasSubstr("FÄHRT"));  // the machine stays in sight
}

TEST(ConsoleView, INS_002_a_watched_screen_takes_the_place_of_the_seats_or_stands_beside_them) {
  ConsoleModel model = lesson();
  model.overlay = Overlay::watching;
  model.watched.station = 7;
  model.watched.screen.write(5, 5, "EINGABEMODUS");
  const Drawn narrow = draw_console(model, kWideColumns - 1);
  EXPECT_THAT(narrow.screen.text(5), HasSubstr("EINGABEMODUS"));
  EXPECT_FALSE(narrow.beside);
  const Drawn wide = draw_console(model, kWideColumns);
  EXPECT_THAT(wide.screen.text(8), HasSubstr("anna"));
  ASSERT_TRUE(wide.beside);
  EXPECT_THAT(wide.beside->text(5), HasSubstr("EINGABEMODUS"));
  EXPECT_THAT(wide.beside->text(0), HasSubstr("Platz 7"));
  model.overlay = Overlay::none;
  EXPECT_FALSE(draw_console(model, kWideColumns).beside);
}

TEST(ConsoleView, the_question_before_quitting_names_the_seat) {
  ConsoleModel model = lesson();
  model.overlay = Overlay::ask_quit;
  EXPECT_THAT(draw_console(model).screen.text(21), HasSubstr("Platz 7"));
}

}  // namespace
}  // namespace cnclab::instructor
