// Commands typed at the console, pages of answers, and a station's screen with its keyboard (INS-002 to INS-005).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "console_rig.hpp"
#include "instructor/console_model.hpp"
#include "instructor/console_view.hpp"

namespace cnclab::instructor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What comes of typing a text and then Enter.
Reaction entered(ConsoleModel model, const std::u32string& text) {
  for (const char32_t character : text) model = react(std::move(model), Typed{character}).model;
  return react(std::move(model), Special::enter);
}

TEST(ConsoleEntry, INS_005_every_command_of_the_command_line_can_be_typed) {
  struct Row {
    const char32_t* typed;
    const char* request;
  };
  const Row rows[] = {
      {U":students", "students { }"},
      {U":student add anna --role observer", "student_add { name: \"anna\" role: \"observer\" }"},
      {U":program restore anna P0003 2", "program_restore { student: \"anna\" program: 3 version: 2 }"},
      {U":message 3 \"zwei  Wörter\"", "message { station: 3 text: \"zwei  W\\303\\266rter\" }"},
      {U"mHallo", "message { station: 7 text: \"Hallo\" }"},
      {U"MHallo zusammen", "message { text: \"Hallo zusammen\" }"},
      {U"x", "expel { station: 7 }"},
  };
  for (const Row& row : rows) {
    const Reaction reaction = entered(connected(), row.typed);
    EXPECT_EQ(asked(reaction), row.request);
    EXPECT_EQ(reaction.model.overlay, Overlay::none);
  }
}

TEST(ConsoleEntry, INS_003_content_goes_to_its_file) {
  const Reaction backup = entered(connected(), U":backup copy.db");
  EXPECT_EQ(backup.content_file, "copy.db");
  const Reaction collected = entered(connected(), U":program collect .");
  EXPECT_TRUE(collected.is_collection);
  EXPECT_EQ(collected.content_file.parent_path(), ".");
}

TEST(ConsoleEntry, a_wrong_command_is_told_and_stays_to_be_corrected) {
  const Reaction wrong = entered(connected(), U":studentz");
  EXPECT_FALSE(wrong.request);
  EXPECT_TRUE(wrong.model.message.is_error);
  EXPECT_EQ(wrong.model.overlay, Overlay::entry);
  const ConsoleModel shorter = react(wrong.model, Special::backspace).model;
  EXPECT_EQ(shorter.entry, "student");
  EXPECT_EQ(asked(entered(shorter, U"s")), "students { }");
  EXPECT_EQ(react(wrong.model, Special::escape).model.overlay, Overlay::none);
}

TEST(ConsoleEntry, a_password_is_not_typed_on_the_screen) {
  const Reaction refused = entered(connected(), U":passwd");
  EXPECT_FALSE(refused.request);
  EXPECT_TRUE(refused.model.message.is_error);
}

TEST(ConsoleEntry, AUTH_006_F12_stops_while_a_command_is_typed_and_h_is_a_letter) {
  const ConsoleModel typing = react(connected(), Typed{U':'}).model;
  EXPECT_EQ(asked(react(typing, Special::halt)), "halt { }");
  EXPECT_EQ(react(typing, Typed{U'h'}).model.entry, "h");
}

TEST(ConsolePage, INS_003_a_long_answer_is_scrolled_and_closed) {
  v1::InstructorRequest request;
  request.mutable_students();
  v1::InstructorAnswer answer;
  for (int i = 0; i < 40; ++i) answer.add_items()->mutable_student()->set_name("s" + std::to_string(i));
  ConsoleModel model = with_answer(connected(), request, answer);
  ASSERT_EQ(model.overlay, Overlay::page);
  EXPECT_THAT(draw_console(model).screen.text(kFirstSeatRow), HasSubstr("\"s0\""));
  model = react(model, Typed{U' '}).model;
  EXPECT_THAT(draw_console(model).screen.text(kFirstSeatRow + 1), HasSubstr("\"s8\"")) << "two rows each";
  for (int i = 0; i < 80; ++i) model = react(model, Special::down).model;
  EXPECT_EQ(model.page_top, 65);
  EXPECT_EQ(react(model, Special::escape).model.overlay, Overlay::none);
}

ConsoleModel with_page(int lines) {
  v1::InstructorRequest request;
  request.mutable_students();
  v1::InstructorAnswer answer;
  for (int i = 0; i < lines; ++i) answer.add_items()->mutable_student()->set_name("s" + std::to_string(i));
  return with_answer(connected(), request, answer);
}

TEST(ConsolePage, what_is_typed_blindly_over_a_list_commands_nothing) {
  ConsoleModel model = with_page(3);
  for (const char32_t character : std::u32string(U"sStpx1")) {
    Reaction reaction = react(std::move(model), Typed{character});
    EXPECT_EQ(asked(reaction), "-");
    model = std::move(reaction.model);
  }
  EXPECT_EQ(model.overlay, Overlay::page);
  EXPECT_EQ(model.chosen, 7);
  EXPECT_EQ(asked(react(model, Typed{U'h'})), "halt { }") << "AUTH-006";
  for (const Input& key :
       {Input(Typed{U'q'}), Input(Special::escape), Input(Special::enter), Input(Special::backspace)})
    EXPECT_EQ(react(model, key).model.overlay, Overlay::none);
}

TEST(ConsolePage, INS_005_a_command_can_be_typed_while_something_lies_over_the_table) {
  EXPECT_EQ(asked(entered(with_page(3), U":status")), "status { }");
  EXPECT_EQ(asked(entered(react(connected(), Typed{U'?'}).model, U":status")), "status { }");
  v1::InstructorRequest watch;
  watch.mutable_watch()->set_station(7);
  const Reaction begun = react(with_answer(connected(), watch, {}), Typed{U':'});
  EXPECT_EQ(asked(begun), "watch { }") << "watching ends";
  EXPECT_EQ(asked(entered(begun.model, U"status")), "status { }");
}

TEST(ConsolePage, the_keys_of_a_list_stand_below_it_and_page_through_it) {
  ConsoleModel model = with_page(40);
  EXPECT_THAT(draw_console(model).screen.text(22), HasSubstr("Bild↓"));
  EXPECT_THAT(draw_console(model).screen.text(23), HasSubstr(": Befehl"));
  EXPECT_THAT(draw_console(model).screen.text(23), testing::Not(HasSubstr("s wählen")));
  struct Row {
    Input key;
    int top;
  };
  const Row rows[] = {{StationKey{station::Special::page_down}, 15}, {Special::down, 16},
                      {StationKey{station::Special::page_up}, 1},    {StationKey{station::Special::end}, 65},
                      {StationKey{station::Special::home}, 0},       {Special::up, 0}};
  for (const Row& row : rows) {
    model = react(std::move(model), row.key).model;
    EXPECT_EQ(model.page_top, row.top);
  }
}

TEST(ConsolePage, INS_003_a_line_wider_than_the_screen_goes_on_in_the_next) {
  v1::InstructorRequest request;
  request.mutable_students();
  v1::InstructorAnswer answer;
  answer.add_items()->mutable_student()->set_name(std::string(100, 'a') + "yz");
  const Screen screen = draw_console(with_answer(connected(), request, answer)).screen;
  EXPECT_THAT(screen.text(kFirstSeatRow), HasSubstr("aaa"));
  EXPECT_THAT(screen.text(kFirstSeatRow + 1), HasSubstr("yz"));
}

TEST(ConsolePaste, pasted_text_is_text_of_a_command_and_elsewhere_only_a_halt_in_it_acts) {
  for (const char32_t character : std::u32string(U"sSp1?:q!"))
    EXPECT_EQ(asked(react(connected(), Pasted{character})), "-");
  EXPECT_EQ(react(connected(), Pasted{U':'}).model.overlay, Overlay::none);
  EXPECT_EQ(asked(react(connected(), Pasted{U'h'})), "halt { }") << "AUTH-006";
  const ConsoleModel entry = react(connected(), Typed{U':'}).model;
  EXPECT_EQ(react(entry, Pasted{U'h'}).model.entry, "h");
  v1::InstructorRequest take;
  take.mutable_take()->set_station(7);
  const ConsoleModel typing = with_answer(connected(), take, {});
  EXPECT_THAT(react(typing, Pasted{U's'}).keys, IsEmpty());
  EXPECT_THAT(react(typing, Pasted{U'!'}).keys, ElementsAre(Key::MASCHINE_HALT));
}

TEST(ConsoleWatching, INS_002_a_stations_screen_fills_the_console_until_a_key) {
  v1::InstructorRequest request;
  request.mutable_watch()->set_station(7);
  ConsoleModel model = with_answer(connected(), request, {});
  Screen screen;
  screen.write(5, 3, "EINGABEMODUS");
  model = with_screen(std::move(model), screen);
  EXPECT_THAT(draw_console(model).screen.text(5), HasSubstr("EINGABEMODUS"));
  EXPECT_EQ(asked(react(model, Typed{U't'})), "take { station: 7 }");
  const Reaction back = react(model, Typed{U'q'});
  EXPECT_EQ(asked(back), "watch { }");
  EXPECT_EQ(back.model.overlay, Overlay::none);
}

TEST(ConsoleWatching, INS_002_the_answer_to_the_end_of_watching_leaves_the_table_as_it_is) {
  v1::InstructorRequest request;
  request.mutable_watch()->set_station(7);
  const Reaction back = react(with_answer(connected(), request, {}), Typed{U'q'});
  v1::InstructorAnswer done;
  done.add_items()->mutable_done()->set_ok(true);
  const ConsoleModel model = with_answer(back.model, *back.request, done);
  EXPECT_EQ(model.overlay, Overlay::none);
  EXPECT_EQ(asked(react(model, Typed{U'h'})), "halt { }");
  EXPECT_TRUE(react(model, Typed{U'q'}).quits);
}

TEST(ConsoleWatching, AUTH_006_h_stops_while_a_screen_is_watched_and_the_screen_stays) {
  v1::InstructorRequest request;
  request.mutable_watch()->set_station(7);
  const Reaction stopped = react(with_answer(connected(), request, {}), Typed{U'h'});
  EXPECT_EQ(asked(stopped), "halt { }");
  EXPECT_TRUE(stopped.is_urgent);
  EXPECT_EQ(stopped.model.overlay, Overlay::watching);
  EXPECT_EQ(stopped.model.watched.station, 7);
}

TEST(ConsoleWatching, INS_002_keys_go_to_the_keyboard_taken_over_until_F8) {
  v1::InstructorRequest request;
  request.mutable_take()->set_station(7);
  const ConsoleModel model = with_answer(connected(), request, {});
  EXPECT_THAT(react(model, Typed{U't'}).keys, ElementsAre(Key::TEACH_IN));
  EXPECT_THAT(react(model, StationKey{station::Special::tab}).keys, ElementsAre(Key::EINGABE));
  EXPECT_THAT(react(model, Typed{U'7'}).keys, ElementsAre(Key::D7));
  EXPECT_FALSE(react(model, Typed{U'q'}).quits);
  EXPECT_EQ(asked(react(model, Special::halt)), "halt { }") << "the instructor's halt";
  const Reaction given = react(model, Special::give_back);
  EXPECT_EQ(asked(given), "give { station: 7 }");
  EXPECT_THAT(react(given.model, Typed{U'7'}).keys, IsEmpty());
}

TEST(ConsoleWatching, the_titles_line_is_the_consoles_own_and_a_halt_says_where_c_clears_it) {
  v1::InstructorRequest watch, halt;
  watch.mutable_watch()->set_station(7);
  halt.mutable_halt();
  ConsoleModel model = with_answer(connected(), watch, {});
  Screen screen;
  screen.write(0, 66, "Platz 07");
  model = with_screen(std::move(model), screen);
  EXPECT_THAT(draw_console(model).screen.text(0), testing::Not(HasSubstr("07")));
  v1::InstructorAnswer done;
  done.add_items()->mutable_done();
  EXPECT_THAT(with_answer(model, halt, done).message.text, HasSubstr("In der Tafel"));
  EXPECT_THAT(with_answer(connected(), halt, done).message.text, testing::Not(HasSubstr("In der Tafel")));
}

TEST(ConsoleWatching, SEAT_005_what_the_lost_line_refused_is_told_until_there_is_one_again) {
  ConsoleModel model = react(with_line(connected(), Link::lost), Typed{U's'}).model;
  EXPECT_THAT(model.message.text, HasSubstr("nichts gesendet"));
  EXPECT_EQ(with_line(std::move(model), Link::connected).message.text, "");
}

TEST(ConsoleEntry, help_is_no_command_here) {
  const Reaction reaction = entered(connected(), U":--help");
  EXPECT_TRUE(reaction.model.message.is_error);
  EXPECT_THAT(reaction.model.message.text, HasSubstr("--help"));
}

TEST(ConsoleWatching, SEAT_005_a_lost_line_ends_watching_and_typing) {
  v1::InstructorRequest request;
  request.mutable_take()->set_station(7);
  const ConsoleModel model = with_line(with_answer(connected(), request, {}), Link::lost);
  EXPECT_EQ(model.overlay, Overlay::none);
  EXPECT_THAT(react(model, Typed{U'7'}).keys, IsEmpty());
}

/// `:student remove anna --erase` and Enter.
Reaction order_erase() {
  ConsoleModel model = connected();
  model.overlay = Overlay::entry;
  model.entry = "student remove anna --erase";
  return react(model, Special::enter);
}

TEST(ConsoleErase, INS_004_what_cannot_come_back_is_asked_about_first) {
  const Reaction asked_first = order_erase();
  EXPECT_EQ(asked(asked_first), "-");
  EXPECT_EQ(asked_first.model.overlay, Overlay::ask_erase);
  for (const char32_t yes : {U'j', U'J', U'y', U'Y'}) {
    const Reaction sent = react(asked_first.model, Typed{yes});
    EXPECT_EQ(asked(sent), R"(student_remove { name: "anna" erase: true })");
    EXPECT_EQ(sent.model.overlay, Overlay::none);
  }
}

TEST(ConsoleErase, INS_004_any_other_key_deletes_nothing_and_a_halt_acts) {
  for (const Input& no : {Input(Typed{U'n'}), Input(Special::enter), Input(Special::escape), Input(Pasted{U'j'})}) {
    const Reaction kept = react(order_erase().model, no);
    EXPECT_EQ(asked(kept), "-");
    EXPECT_EQ(kept.model.message.text, std::holds_alternative<Pasted>(no) ? "" : "Nichts gelöscht.");
  }
  EXPECT_EQ(asked(react(order_erase().model, Special::halt)), "halt { }");
}

TEST(ConsoleErase, INS_004_archiving_asks_nothing) {
  ConsoleModel model = connected();
  model.overlay = Overlay::entry;
  model.entry = "student remove anna";
  EXPECT_EQ(asked(react(model, Special::enter)), R"(student_remove { name: "anna" })");
}

}  // namespace
}  // namespace cnclab::instructor
