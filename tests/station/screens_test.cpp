// What the station draws itself: ASCII likenesses (DEC-01), the lost line (SEAT-005), help, login form.
#include <gtest/gtest.h>

#include <boost/asio/error.hpp>

#include "station/cell_text.hpp"
#include "station/connect_trouble.hpp"
#include "station/headless.hpp"
#include "station/login_form.hpp"
#include "station/overlays.hpp"

namespace cnclab::station {
namespace {

TEST(CellText, Dec01LikenessesWithoutUnicode) {
  const std::u32string original = U"┌─┐│└┘□●○↻↺→↓äöüÄÖÜß";
  const std::u32string likeness = U"+-+|++#*o><>vaouAOUs";
  ASSERT_EQ(original.size(), likeness.size());
  for (std::size_t i = 0; i < original.size(); ++i) {
    EXPECT_EQ(shown_code(original[i], Glyphs::ascii), likeness[i]) << to_utf8(original[i]);
    EXPECT_EQ(shown_code(original[i], Glyphs::all), original[i]) << to_utf8(original[i]);
  }
}

TEST(CellText, DEC_01_signs_of_two_characters_in_ASCII_lose_nothing_behind_them) {
  struct Row {
    const char* stands;
    const char* shown;
  };
  const Row rows[] = {{"Wort X eingeben, → zum nächsten. → weiter", "Wort X eingeben, -> zum naechsten. -> weiter"},
                      {"→  Wort   ↓  Satz", "-> Wort   v  Satz"},
                      {"│ DANACH →! │", "| DANACH ->!|"},
                      {"│voll →!│", "|voll >!|"},
                      {"→", "->"},
                      {"SPEICHER LÖSCHEN   Löschen", "SPEICHER LOESCHEN  Loeschen"},
                      {"Überlänge   Größe, für", "Ueberlaenge Groesse, fuer"},
                      {"±X ±Y ±Z verschieben   SATZ LÖ.", "+-X +-Y +-Z verschieben SATZ LOE."},
                      {"│voll ü│", "|voll u|"},
                      {"−5", "-5"}};
  for (const Row& row : rows) {
    Screen screen;
    screen.write(18, 2, row.stands);
    const std::string reply = screen_reply(screen, true);
    const std::string shown = row.shown;
    EXPECT_NE(reply.find("|  " + shown + " "), std::string::npos) << reply;
    EXPECT_NE(screen_reply(screen, false).find(row.stands), std::string::npos);
  }
}

TEST(CellText, A_cursor_behind_an_umlaut_stays_a_cursor) {
  Screen screen;
  screen.write(9, 30, "Müller");
  screen.put(9, 36, {U' ', Attribute::inverse});
  const Screen spelled = spelled_out(screen);
  EXPECT_EQ(spelled.text(9).substr(30, 7), "Mueller");
  EXPECT_EQ(spelled.at(9, 37).attribute, Attribute::inverse);
  EXPECT_EQ(marks_reply(screen, true), "9 37 1\nend\n");
}

TEST(CellText, DEC_01_marks_move_with_the_text_behind_an_arrow) {
  Screen screen;
  screen.write(5, 0, "→ ");
  screen.write(5, 2, "A", Attribute::inverse);
  EXPECT_EQ(marks_reply(screen, false), "5 2 1\nend\n");
  EXPECT_EQ(marks_reply(screen, true), "5 3 1\nend\n");
}

TEST(CellText, AnyCodePointIsOneHarmlessCell) {
  for (char32_t code = 0; code < 0x30000; ++code) {
    const char32_t ascii = shown_code(code, Glyphs::ascii);
    ASSERT_TRUE(ascii >= 0x20 && ascii < 0x7F) << static_cast<std::uint32_t>(code);
    const char32_t shown = shown_code(code, Glyphs::all);
    ASSERT_TRUE(shown >= 0x20 && (shown < 0x7F || shown >= 0xA0)) << static_cast<std::uint32_t>(code);
  }
  for (const char32_t wide_or_combining :
       {U'\u0301', U'\u200B', U'\u202E', U'漢', U'\uFF21', U'\U0001F600', U'\uFEFF'}) {
    EXPECT_EQ(shown_code(wide_or_combining, Glyphs::all), U'?');
  }
}

/// Blank, then `.` for a thin line or a light shade, `:` for a line down or the darkest shade, `#` for a line across
/// it.
TEST(CellText, DEC_37_DotsOfAPictureByTheirDensity) {
  struct Row {
    char32_t dots;
    char likeness;
  };
  constexpr Row kRows[] = {{U'\u2800', ' '}, {U'\u2801', '.'}, {U'\u2880', '.'}, {U'\u2809', '.'},
                           {U'\u28C0', '.'}, {U'\u2807', ':'}, {U'\u2847', ':'}, {U'\u28A5', ':'},
                           {U'\u280F', ':'}, {U'\u28A7', '#'}, {U'\u28FB', '#'}, {U'\u28FF', '#'}};
  for (const Row& row : kRows) {
    EXPECT_EQ(shown_code(row.dots, Glyphs::ascii), static_cast<char32_t>(row.likeness)) << to_utf8(row.dots);
    EXPECT_EQ(shown_code(row.dots, Glyphs::no_braille), static_cast<char32_t>(row.likeness)) << to_utf8(row.dots);
    EXPECT_EQ(shown_code(row.dots, Glyphs::all), row.dots);
  }
}

TEST(CellText, DEC_37_AConsoleWithoutBrailleKeepsFrameAndUmlauts) {
  for (const char32_t code : std::u32string_view(U"┌─│□●○↻→ä°a")) EXPECT_EQ(shown_code(code, Glyphs::no_braille), code);
}

TEST(CellText, TextsFromTheServerAreOneLine) { EXPECT_EQ(printable("a\nb\x1B[2Jc\xC2\x9B"), "a b [2Jc "); }

TEST(Overlays, ALostLineShowsSecondsAndNoLivePosition) {  // SEAT-005
  Screen last;
  last.write(3, 50, "X  +0085.000", Attribute::bold);
  const Screen lost = with_lost_line(last, std::chrono::seconds(12), "kein Anschluss", Language::german);
  EXPECT_TRUE(contains(lost, "VERBINDUNG VERLOREN  12 s"));
  EXPECT_TRUE(contains(lost, "gilt nicht mehr"));
  EXPECT_TRUE(contains(lost, "kein Anschluss"));
  EXPECT_EQ(lost.at(3, 50).attribute, Attribute::dim);
}

TEST(Overlays, SEAT_005_why_the_line_is_lost_is_read_to_its_end) {
  const Screen lost = with_lost_line(
      Screen(), std::chrono::seconds(1),
      "Kein Anschluss an 127.0.0.1:38365: dort antwortet kein Server. Läuft der Server, stimmt die Adresse?",
      Language::german);
  std::string all;
  for (int row = 0; row < Screen::kRows; ++row) {
    const std::string text = lost.text(row);
    const auto begin = text.find("│ "), end = text.rfind(" │");
    if (begin != std::string::npos && end > begin) all += text.substr(begin + 4, end - begin - 4);
  }
  std::string words;  // without the blanks at the rows' ends
  for (const char c : all)
    if (c != ' ' || !words.ends_with(' ')) words += c;
  EXPECT_NE(words.find("38365: dort antwortet kein Server. Läuft der Server, stimmt die Adresse?"), std::string::npos)
      << words;
  EXPECT_TRUE(contains(lost, "q beendet."));
}

TEST(Overlays, SEAT_005_the_help_page_says_that_the_line_is_lost) {
  const Screen help = with_lost_heading(help_screen(0, Language::english), std::chrono::seconds(7), Language::english);
  EXPECT_TRUE(contains(help, "CONNECTION LOST  7 s"));
  EXPECT_TRUE(contains(help, "all keys"));
}

TEST(Overlays, SEAT_006_who_looks_on_is_told_so_in_place_of_the_keys) {
  Screen seen;
  seen.write(3, 67, "TRAINING");
  seen.write(23, 1, "? alle Tasten   HAND Handbetrieb");
  const Screen shown = with_looking_on(seen, 5, Language::german);
  EXPECT_EQ(shown.text(0).substr(2, 22), " Nur zusehen: Platz 5 ");
  EXPECT_TRUE(contains(shown, "TRAINING"));
  EXPECT_FALSE(contains(shown, "alle Tasten"));
  EXPECT_EQ(shown.at(23, 2).attribute, Attribute::inverse);
  EXPECT_TRUE(contains(shown, "Tasten wirken hier nicht.   q beendet das Zusehen"));
  EXPECT_TRUE(contains(with_looking_on(seen, 5, Language::english), "Looking on: station 5"));
  EXPECT_TRUE(contains(with_log_out_question(shown, true, Language::german), "Zusehen beenden?"));
  EXPECT_FALSE(contains(with_log_out_question(shown, true, Language::german), "q beendet das Zusehen"));
  EXPECT_TRUE(contains(with_log_out_question(seen, false, Language::german), "Abmelden?"));
}

TEST(ConnectTrouble, IsSaidInTheReadersWords) {
  namespace basic = boost::asio::error;
  EXPECT_EQ(connect_trouble(basic::connection_refused, Language::german), "dort antwortet kein Server");
  EXPECT_EQ(connect_trouble(basic::connection_refused, Language::english), "no server answers there");
  EXPECT_EQ(connect_trouble(basic::host_not_found, Language::german), "diesen Namen kennt das Netz nicht");
  const boost::system::error_code other = basic::no_memory;
  EXPECT_EQ(connect_trouble(other, Language::german), other.message());
}

TEST(Overlays, ThePotentiometerIsReadFromTheSideColumn) {
  struct Row {
    const char* text;
    std::optional<int> percent;
  };
  const Row rows[] = {{"Poti   80 %", 80}, {"Feed  100 %", 100}, {"Poti    0 %", 0},
                      {"Poti", {}},        {"Poti  999 %", {}},  {"%", {}}};
  for (const Row& row : rows) {
    Screen screen;
    screen.write(8, 0, "12 %");  // the monitor is not meant
    screen.write(8, 66, row.text);
    EXPECT_EQ(shown_potentiometer(screen), row.percent) << row.text;
  }
}

TEST(LoginForm, NoLabelReachesItsMarker) {
  LoginQuestion question;
  question.refusal.emplace();
  question.refusal->set_result(v1::LOGIN_RESULT_ELSEWHERE);
  EXPECT_TRUE(contains(LoginForm(question, false, false, Language::german).screen(), "1 übernehmen 2 zusehen  >"));
}

TEST(Overlays, TheHelpPageScrollsToItsEnd) {
  const std::size_t last = last_help_start(Language::german);
  ASSERT_GT(last, 0U) << "longer than a screen";
  EXPECT_TRUE(contains(help_screen(0, Language::german), "HAND"));
  EXPECT_FALSE(contains(help_screen(0, Language::german), "neu zeichnen"));
  EXPECT_TRUE(contains(help_screen(last, Language::german), "neu zeichnen"));
  EXPECT_EQ(help_screen(last + 50, Language::german), help_screen(last, Language::german));
}

LoginQuestion question(std::optional<v1::LoginResult> refusal = {}) {
  LoginQuestion asked;
  for (std::uint32_t station = 1; station <= 15; ++station) {
    v1::Seat* const seat = asked.welcome.add_seats();
    seat->set_station(station);
    seat->set_is_free(station == 2 || station == 14);
  }
  if (refusal) {
    asked.refusal.emplace();
    asked.refusal->set_result(*refusal);
  }
  return asked;
}

LoginForm::State type(LoginForm& form, std::u32string_view text) {
  auto state = LoginForm::State::editing;
  for (const char32_t code : text) state = form.handle(code == U'\n' ? Input(Special::enter) : Input(code));
  return state;
}

TEST(LoginForm, AsksForSeatNameAndPasswordAndShowsFreeSeats) {  // SEAT-002
  LoginForm form(question(), false, false, Language::german);
  EXPECT_TRUE(contains(form.screen(), "Freie Plätze: 2 14"));
  EXPECT_EQ(type(form, U"14\nJürgen\ngeheim"), LoginForm::State::editing);
  const Screen screen = form.screen();
  EXPECT_TRUE(contains(screen, "Jürgen"));
  EXPECT_FALSE(contains(screen, "geheim")) << "no echo";
  EXPECT_FALSE(contains(screen, "******")) << "not even its length";
  EXPECT_EQ(type(form, U"\n"), LoginForm::State::submitted);
  const Credentials entered = form.credentials();
  EXPECT_EQ(entered.station, 14U);
  EXPECT_EQ(entered.user, "Jürgen");
  EXPECT_EQ(entered.password, "geheim");
}

TEST(LoginForm, AsksOnlyForWhatTheCommandLineLeavesOpen) {
  LoginQuestion asked = question();
  asked.so_far.station = 5;
  asked.so_far.user = "anna";
  LoginForm form(asked, true, true, Language::german);
  EXPECT_EQ(type(form, U"geheim\n"), LoginForm::State::submitted);
  EXPECT_EQ(form.credentials().user, "anna");
  EXPECT_EQ(form.credentials().station, 5U);
}

TEST(LoginForm, WrongEntriesAreExplainedAndKept) {
  LoginForm form(question(), false, false, Language::german);
  EXPECT_EQ(type(form, U"16\nanna\ngeheim\n"), LoginForm::State::editing);
  EXPECT_TRUE(contains(form.screen(), "1 bis 15"));
  EXPECT_TRUE(contains(form.screen(), "anna"));
  LoginForm empty(question(), false, false, Language::german);
  EXPECT_EQ(type(empty, U"2\n\n\n"), LoginForm::State::editing);
  EXPECT_TRUE(contains(empty.screen(), "Bitte ausfüllen: Name"));
}

TEST(LoginForm, ARefusalIsShown) {
  LoginForm form(question(v1::LOGIN_RESULT_REFUSED), false, false, Language::english);
  EXPECT_TRUE(contains(form.screen(), "Name or password wrong."));
}

TEST(LoginForm, SEAT_001_a_taken_seat_leads_back_to_the_seat_and_the_list_is_renewed) {
  LoginQuestion taken = question(v1::LOGIN_RESULT_SEAT_TAKEN);
  taken.refusal->set_occupant("bert");
  taken.so_far.station = 7;
  taken.so_far.user = "anna";
  LoginForm form(taken, false, false, Language::german);
  EXPECT_TRUE(contains(form.screen(), "bert"));
  v1::Welcome newer;
  newer.add_seats()->set_station(3);
  newer.mutable_seats(0)->set_is_free(true);
  form.renew_seats(newer);
  EXPECT_TRUE(contains(form.screen(), "Freie Plätze: 3 "));
  EXPECT_EQ(type(form, U"3\n\ngeheim\n"), LoginForm::State::submitted);
  EXPECT_EQ(form.credentials().station, 3U);
  EXPECT_EQ(form.credentials().user, "anna");
}

TEST(LoginForm, ANewPasswordIsEnteredTwice) {
  LoginForm form(question(v1::LOGIN_RESULT_PASSWORD_EXPIRED), true, true, Language::german);
  EXPECT_EQ(type(form, U"neues-wort\nanderes\n"), LoginForm::State::editing);
  EXPECT_TRUE(contains(form.screen(), "verschieden"));
  EXPECT_EQ(type(form, U"neues-wort\nneues-wort\n"), LoginForm::State::submitted);
  EXPECT_EQ(form.credentials().new_password, "neues-wort");
}

TEST(LoginForm, ALoginElsewhereIsTakenOverOrLookedAt) {  // SEAT-003
  LoginForm take(question(v1::LOGIN_RESULT_ELSEWHERE), true, true, Language::german);
  EXPECT_EQ(type(take, U"1\n"), LoginForm::State::submitted);
  EXPECT_EQ(take.credentials().elsewhere, v1::ELSEWHERE_TAKE_OVER);
  LoginForm look(question(v1::LOGIN_RESULT_ELSEWHERE), true, true, Language::german);
  EXPECT_EQ(type(look, U"32\n"), LoginForm::State::submitted) << "3 is no choice";
  EXPECT_EQ(look.credentials().elsewhere, v1::ELSEWHERE_LOOK_ON);
}

TEST(LoginForm, EntriesAreBoundedAndEscapeLeaves) {
  LoginForm form(question(), true, false, Language::german);
  type(form, std::u32string(100, U'ä') + U"\n" + std::u32string(1000, U'x') + U"\n");
  EXPECT_EQ(form.credentials().user.size(), 32U) << "bytes";
  EXPECT_EQ(form.credentials().password.size(), 256U);
  EXPECT_EQ(form.handle(Special::escape), LoginForm::State::cancelled);
  EXPECT_EQ(form.handle(Special::ctrl_c), LoginForm::State::cancelled);
}

}  // namespace
}  // namespace cnclab::station
