// Keys and clicks of the console, and what they ask of the server (INS-001, INS-002, AUTH-004, AUTH-006, AUTH-010).
#include "instructor/console_model.hpp"

#include <gtest/gtest.h>

#include "console_rig.hpp"
#include "instructor/command_line.hpp"

namespace cnclab::instructor {
namespace {

struct InputRow {
  std::string name;
  Input input;
  std::string request;
  bool is_urgent = false;
};

void PrintTo(const InputRow& row, std::ostream* out) { *out << row.name; }

class ConsoleKeys : public testing::TestWithParam<InputRow> {};

TEST_P(ConsoleKeys, asks_the_server) {
  const Reaction reaction = react(connected(), GetParam().input);
  EXPECT_EQ(asked(reaction), GetParam().request);
  EXPECT_EQ(reaction.is_urgent, GetParam().is_urgent);
  EXPECT_FALSE(reaction.quits);
}

INSTANTIATE_TEST_SUITE_P(INS_002, ConsoleKeys,
                         testing::Values(InputRow{"AUTH-002 s", Typed{U's'}, "select { station: 7 }"},
                                         InputRow{"AUTH-002 Enter", Special::enter, "select { station: 7 }"},
                                         InputRow{"AUTH-004 S", Typed{U'S'}, "select { station: 7 force: true }"},
                                         InputRow{"AUTH-001 r", Typed{U'r'}, "release { }"},
                                         InputRow{"AUTH-004 R", Typed{U'R'}, "release { force: true }"},
                                         InputRow{"AUTH-006 F12", Special::halt, "halt { }", true},
                                         InputRow{"AUTH-006 h", Typed{U'h'}, "halt { }", true},
                                         InputRow{"AUTH-006 c", Typed{U'c'}, "clear_halt { }"},
                                         InputRow{"AUTH-010 p", Typed{U'p'}, "power_off { }", true},
                                         InputRow{"INS-002 l", Typed{U'l'}, "lock { station: 7 }"},
                                         InputRow{"INS-002 v", Typed{U'v'}, "show { station: 7 }"},
                                         InputRow{"INS-002 w", Typed{U'w'}, "watch { station: 7 }"},
                                         InputRow{"INS-002 t", Typed{U't'}, "take { station: 7 }"},
                                         InputRow{"INS-002 g", Typed{U'g'}, "give { station: 7 }"},
                                         InputRow{"z does nothing", Typed{U'z'}, "-"},
                                         InputRow{"Esc does nothing", Special::escape, "-"}));

TEST(ConsoleModel, AUTH_010_p_switches_on_again_what_is_off) {
  ConsoleModel model = connected();
  model.status->mutable_machine()->set_state("off");
  EXPECT_EQ(asked(react(model, Typed{U'p'})), "power_on { }");
}

TEST(ConsoleModel, INS_001_seats_are_chosen_by_digit_arrow_and_click) {
  EXPECT_EQ(react(connected(), Typed{U'3'}).model.chosen, 3);
  EXPECT_EQ(react(connected(), Special::up).model.chosen, 6);
  EXPECT_EQ(react(connected(), Special::down).model.chosen, 8);
  EXPECT_EQ(react(connected(), Clicked{kFirstSeatRow + 14}).model.chosen, 15);
  EXPECT_EQ(react(connected(), Clicked{kFirstSeatRow}).model.chosen, 1);
}

TEST(ConsoleModel, SEAT_001_the_choice_stays_between_1_and_15) {
  ConsoleModel model = connected();
  model.chosen = 1;
  EXPECT_EQ(react(model, Special::up).model.chosen, 1);
  model.chosen = 15;
  EXPECT_EQ(react(model, Special::down).model.chosen, 15);
  for (const int row : {0, kFirstSeatRow - 1, kFirstSeatRow + kSeats, 23}) {
    EXPECT_EQ(react(model, Clicked{row}).model.chosen, 15) << row;
  }
}

TEST(ConsoleModel, q_quits_at_once_while_nobody_has_control) { EXPECT_TRUE(react(connected(), Typed{U'q'}).quits); }

TEST(ConsoleModel, q_asks_first_while_a_station_has_control) {
  const Reaction asked_first = react(connected(7), Typed{U'q'});
  EXPECT_FALSE(asked_first.quits);
  EXPECT_EQ(asked_first.model.overlay, Overlay::ask_quit);
  EXPECT_TRUE(react(asked_first.model, Typed{U'j'}).quits);
  EXPECT_TRUE(react(asked_first.model, Typed{U'y'}).quits);
  const Reaction stays = react(asked_first.model, Typed{U'n'});
  EXPECT_FALSE(stays.quits);
  EXPECT_EQ(stays.model.overlay, Overlay::none);
}

TEST(ConsoleModel, AUTH_006_the_halt_works_over_every_question_and_page) {
  for (const Overlay overlay : {Overlay::help, Overlay::ask_quit}) {
    for (const Input& input : {Input(Special::halt), Input(Typed{U'h'})}) {
      ConsoleModel model = connected(7);
      model.overlay = overlay;
      const Reaction reaction = react(model, input);
      EXPECT_EQ(asked(reaction), "halt { }");
      EXPECT_FALSE(reaction.quits);
    }
  }
}

TEST(ConsoleModel, help_opens_with_a_question_mark_and_closes_with_any_key_that_does_nothing_else) {
  const ConsoleModel model = react(connected(), Typed{U'?'}).model;
  EXPECT_EQ(model.overlay, Overlay::help);
  const Reaction reaction = react(model, Typed{U's'});
  EXPECT_EQ(reaction.model.overlay, Overlay::none);
  EXPECT_EQ(asked(reaction), "-");
}

TEST(ConsoleModel, SEAT_005_keys_on_a_lost_line_are_dropped_and_say_so) {
  ConsoleModel model = connected();
  model.link = Link::lost;
  const Reaction reaction = react(model, Typed{U's'});
  EXPECT_EQ(asked(reaction), "-");
  EXPECT_TRUE(reaction.model.message.is_error);
  EXPECT_EQ(reaction.model.message.text, "Keine Verbindung: nichts gesendet.");
}

TEST(ConsoleModel, AUTH_004_a_refusal_stands_on_the_message_line) {
  v1::InstructorRequest request;
  request.mutable_select()->set_station(7);
  v1::InstructorAnswer answer;
  answer.set_error("Die Maschine fährt.");
  const auto refused = with_answer(connected(), request, answer);
  EXPECT_EQ(refused.message.text, "Die Maschine fährt.");
  EXPECT_TRUE(refused.message.is_error);
}

TEST(ConsoleModel, INS_002_l_twice_locks_and_unlocks_before_the_next_status_comes) {
  auto model = connected();
  model.status->add_stations()->set_station(7);
  model = react(std::move(model), Typed{U'7'}).model;
  const Reaction lock = react(model, Typed{U'l'});
  ASSERT_TRUE(lock.request && lock.request->has_lock());
  v1::InstructorAnswer answer;
  answer.add_items()->mutable_done()->set_ok(true);
  const Reaction unlock = react(with_answer(lock.model, *lock.request, answer), Typed{U'l'});
  EXPECT_TRUE(unlock.request && unlock.request->has_unlock());
}

TEST(ConsoleModel, AUTH_006_the_message_of_a_halt_goes_when_the_halt_is_cleared_elsewhere) {
  v1::InstructorRequest request;
  request.mutable_halt();
  v1::InstructorAnswer answer;
  answer.add_items()->mutable_done()->set_ok(true);
  ConsoleModel model = with_answer(connected(), request, answer);
  v1::Status status = *model.status;
  status.set_halted_by("lehrer");
  model = with_status(std::move(model), status);
  EXPECT_EQ(model.message.text, "MASCHINE HALT. c hebt ihn auf.");
  status.set_halted_by("");
  EXPECT_EQ(with_status(model, status).message.text, "");
  model.overlay = Overlay::watching;
  EXPECT_EQ(with_answer(model, request, answer).message.text, "MASCHINE HALT. In der Tafel hebt c ihn auf.");
}

TEST(ConsoleModel, AUTH_016_nobody_types_at_a_keyboard_that_was_given_back) {
  ConsoleModel model = connected();
  model.user = "lehrer";
  model.watched = {.station = 7, .screen = {}, .is_typing = true};
  v1::Status status = *model.status;
  status.add_stations()->set_station(7);
  status.mutable_stations(0)->set_taken_by("lehrer");
  model = with_status(std::move(model), status);
  EXPECT_TRUE(model.watched.is_typing);
  status.mutable_stations(0)->clear_taken_by();
  model = with_status(std::move(model), status);
  EXPECT_FALSE(model.watched.is_typing);
  EXPECT_EQ(model.message.text, "Die Tastatur ist zurückgegeben.");
}

struct DoneRow {
  std::string command, detail, german, english;
};

void PrintTo(const DoneRow& row, std::ostream* out) { *out << row.command; }

class DoneCommand : public testing::TestWithParam<DoneRow> {};

TEST_P(DoneCommand, is_told_in_a_sentence) {
  const auto command = read_command(words_of(GetParam().command), station::Language::german);
  ASSERT_TRUE(command) << command.error();
  v1::InstructorAnswer answer;
  answer.add_items()->mutable_done()->set_detail(GetParam().detail);
  ConsoleModel model = connected();
  EXPECT_EQ(with_answer(model, command->request, answer).message.text, GetParam().german);
  model.language = station::Language::english;
  EXPECT_EQ(with_answer(model, command->request, answer).message.text, GetParam().english);
}

INSTANTIATE_TEST_SUITE_P(
    INS_005, DoneCommand,
    testing::Values(
        DoneRow{"student remove imp1", "imp1", "Entfernt: imp1. student restore holt zurück.",
                "Removed: imp1. student restore brings it back."},
        DoneRow{"student remove imp1 --erase", "imp1", "Endgültig gelöscht: imp1.", "Deleted for good: imp1."},
        DoneRow{"student rename a b", "b", "Heißt jetzt b.", "Is called b now."},
        DoneRow{"export exp.csv", "exp.csv", "Geschrieben: exp.csv", "Written: exp.csv"},
        DoneRow{"message all Pause", "", "Nachricht gesendet.", "Message sent."},
        DoneRow{"input 11 on", "", "Eingang 11 ein.", "Input 11 on."},
        DoneRow{"remote 3 off", "", "REMOTE an Platz 3 aus.", "REMOTE at station 3 off."},
        DoneRow{"ram-fault 3 on", "", "Speicherfehler an Platz 3 ein.", "Memory fault at station 3 on."},
        DoneRow{"expel 12", "", "Platz 12 ist abgemeldet.", "Station 12 is logged out."},
        DoneRow{"program collect /tmp", "/tmp: 4", "Eingesammelt, Dateien in /tmp: 4", "Collected, files in /tmp: 4"},
        DoneRow{"show off", "", "Jeder Platz zeigt wieder sein eigenes Bild.",
                "Every station shows its own screen again."},
        DoneRow{"clear-halt", "", "Halt aufgehoben.", "Halt cleared."},
        DoneRow{"clear-halt", "Es war kein Halt gedrückt.", "Es war kein Halt gedrückt.",
                "Es war kein Halt gedrückt."}));

TEST(ConsoleModel, INS_005_an_empty_list_says_that_it_is_empty) {
  v1::InstructorRequest request;
  request.mutable_runs()->set_name("anna");
  EXPECT_EQ(with_answer(connected(), request, {}).message.text, "Keine Einträge.");
}

TEST(ConsoleModel, AUTH_006_in_a_window_too_small_to_see_anything_only_a_stop_acts) {
  ConsoleModel model = connected();
  model.is_too_small = true;
  for (const Input& input : {Input(Typed{U's'}), Input(Typed{U'c'}), Input(Special::enter), Input(Typed{U'q'}),
                             Input(Typed{U':'}), Input(Clicked{kFirstSeatRow})}) {
    const Reaction reaction = react(model, input);
    EXPECT_EQ(asked(reaction), "-");
    EXPECT_FALSE(reaction.quits);
    EXPECT_EQ(reaction.model.overlay, Overlay::none);
    EXPECT_EQ(reaction.model.chosen, 7);
  }
  EXPECT_EQ(asked(react(model, Typed{U'h'})), "halt { }");
  EXPECT_EQ(asked(react(model, Special::halt)), "halt { }");
  model.overlay = Overlay::watching;
  model.watched = {.station = 7, .screen = {}, .is_typing = true};
  EXPECT_EQ(react(model, Typed{U' '}).keys, std::vector{Key::STOP});
  EXPECT_TRUE(react(model, Typed{U's'}).keys.empty());
}

TEST(ConsoleModel, AUTH_005_an_accepted_select_tells_what_the_student_has_to_do) {
  v1::InstructorRequest request;
  request.mutable_select()->set_station(7);
  v1::InstructorAnswer answer;
  answer.add_items()->mutable_done()->set_ok(true);
  EXPECT_EQ(with_answer(connected(), request, answer).message.text,
            "Platz 7: Steuerung angeboten; der Platz nimmt mit START an.");
  auto english = connected();
  english.language = station::Language::english;
  EXPECT_EQ(with_answer(english, request, answer).message.text,
            "Station 7: control offered; it is accepted there with START.");
}

}  // namespace
}  // namespace cnclab::instructor
