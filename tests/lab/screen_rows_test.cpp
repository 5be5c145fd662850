// What the lab writes on the students' screens: who bars a keyboard, who pressed MASCHINE HALT, and sentences that end
// when they are no longer true (INS-002, AUTH-005, AUTH-006, DEC-01).
#include <gmock/gmock.h>

#include "small_lab.hpp"

namespace cnclab::lab {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kTaken = "lehrer hat diese Tastatur übernommen: nur STOP und MASCHINE HALT wirken.";
const std::string kLocked = "Die Lehrkraft hat die Tastatur gesperrt: nur STOP und MASCHINE HALT wirken.";
const std::string kShown = "Während ein Bild allen gezeigt wird, wirken hier nur STOP und MASCHINE HALT.";

class ScreenRows : public testing::Test, protected SmallLab {
 protected:
  ScreenRows() {
    with_database([](db::Database& database) { database.set_language(database.person("udo")->id, "en"); });
    log_in(eva_, "eva", 7);
    log_in(udo_, "udo", 12);
    log_in(console_, "lehrer", 0);
    refresh();
  }

  /// What has changed is drawn and has arrived.
  void refresh() {
    constexpr int kOnTheWay = 3;  // a screen that waits for an acknowledgement, and one behind it
    for (int i = 0; i < kOnTheWay; ++i) {
      advance_ms(20);
      poll();
      look(eva_);
      look(udo_);
    }
  }
  void key(Caller& caller, Key pressed) {
    strike(caller, pressed);
    refresh();
  }
  template <class Fill>
  void order(Fill fill) {
    v1::InstructorRequest request;
    fill(request);
    EXPECT_EQ(ask(console_, request).error(), "");
    refresh();
  }
  void take() {
    order([](auto& request) { request.mutable_take()->set_station(7); });
  }
  void message(const std::string& text) {
    order([&](auto& request) {
      request.mutable_message()->set_station(7);
      request.mutable_message()->set_text(text);
    });
  }
  [[nodiscard]] static std::string below(const Caller& caller) {
    std::string text;
    for (int row = 18; row < Screen::kRows; ++row) text += caller.screen.text(row) + "\n";
    return text;
  }
  [[nodiscard]] static std::string side(const Caller& caller, int row) {
    constexpr std::size_t kColumn = 67;
    std::string text;
    for (const char32_t code : from_utf8(caller.screen.text(row)).substr(kColumn)) text += static_cast<char>(code);
    return text.substr(0, text.find_last_not_of(' ') + 1);
  }

  Caller eva_ = call(), udo_ = call(), console_ = call(v1::CLIENT_KIND_INSTRUCTOR);
};

TEST_F(ScreenRows, INS_002_ATakenKeyboardIsToldAboveMessagesAndHintsUntilItIsGivenBack) {
  message("Pause");
  EXPECT_THAT(eva_.screen.text(18), StartsWith("lehrer: Pause"));
  take();
  EXPECT_THAT(eva_.screen.text(18), StartsWith(kTaken)) << "not after the next key only";
  EXPECT_THAT(eva_.screen.text(19), StartsWith("lehrer: Pause"));
  for (const Key typed : {Key::MENU, Key::AUTOMAT, Key::SIGN}) {  // the first and the last are ignored, with a hint
    key(console_, typed);
    EXPECT_THAT(eva_.screen.text(18), StartsWith(kTaken));
  }
  EXPECT_THAT(eva_.screen.text(19), StartsWith("+/- hat hier keine Wirkung.")) << "for whoever types";
  EXPECT_THAT(below(eva_), HasSubstr("0-9 Ziffern"));
  key(eva_, Key::MENU);
  EXPECT_THAT(eva_.screen.text(18), StartsWith(kTaken));
  order([](auto& request) { request.mutable_give()->set_station(7); });
  EXPECT_THAT(below(eva_), Not(HasSubstr("übernommen")));
}

TEST_F(ScreenRows, INS_002_ALockedKeyboardIsToldAboveMessagesAndNoKeysAreListed) {
  message("Bitte alle hersehen");
  order([](auto& request) { request.mutable_lock()->set_station(7); });
  EXPECT_THAT(eva_.screen.text(18), StartsWith(kLocked));
  EXPECT_THAT(eva_.screen.text(19), StartsWith("lehrer: Bitte alle hersehen"));
  EXPECT_THAT(below(eva_), Not(HasSubstr("AUTOMAT Automat")));
  key(eva_, Key::AUTOMAT);
  order([](auto& request) { request.mutable_unlock()->set_station(7); });
  EXPECT_THAT(below(eva_), Not(HasSubstr("gesperrt")));
  EXPECT_THAT(below(eva_), HasSubstr("AUTOMAT Automat"));
}

TEST_F(ScreenRows, INS_002_TheBarStaysWhileTheMenuOfLaborIsOpen) {
  key(eva_, Key::LABOR);
  take();
  EXPECT_THAT(eva_.screen.text(18), StartsWith(kTaken));
  EXPECT_THAT(below(eva_), HasSubstr("1 Versionen"));
}

TEST_F(ScreenRows, INS_002_AShownScreenSaysWhatActsHereAndNothingOfItStaysBehind) {
  order([](auto& request) { request.mutable_show()->set_station(12); });
  EXPECT_THAT(eva_.screen.text(23), StartsWith(kShown));
  message("Hierher sehen");
  EXPECT_THAT(eva_.screen.text(22), StartsWith("lehrer: Hierher sehen"));
  key(eva_, Key::AUTOMAT);
  EXPECT_THAT(udo_.screen.text(18), StartsWith("Choose an operating mode with its key."));
  order([](auto& request) { request.mutable_show()->set_station(0); });
  EXPECT_THAT(below(eva_), Not(HasSubstr(kShown)));
}

TEST_F(ScreenRows, AUTH_006_HaltIsNamedWithSeatAndNameInTheReadersLanguage) {
  key(udo_, Key::MASCHINE_HALT);
  EXPECT_EQ(side(eva_, 16), "HALT Platz 12");
  EXPECT_EQ(side(eva_, 17), "udo");
  EXPECT_EQ(side(udo_, 16), "HALT Station");
  key(eva_, Key::MASCHINE_HALT);
  EXPECT_EQ(side(eva_, 16), "HALT Platz 12") << "the first of those who hold it";
  key(udo_, Key::MASCHINE_HALT);
  EXPECT_EQ(side(eva_, 16), "HALT Platz 07") << "her own press holds still";
  key(eva_, Key::MASCHINE_HALT);
  EXPECT_EQ(side(eva_, 16), "");
  EXPECT_EQ(side(eva_, 17), "");
  order([](auto& request) { request.mutable_halt(); });
  EXPECT_EQ(side(udo_, 16), "HALT lehrer");
}

TEST_F(ScreenRows, AUTH_006_TheSentenceUnderHaltNamesWhoPressedInTheReadersLanguage) {
  order([](auto& request) { request.mutable_select()->set_station(12); });
  key(udo_, Key::START);
  ASSERT_THAT(side(udo_, 3), HasSubstr("MACHINE"));
  key(eva_, Key::MASCHINE_HALT);
  key(udo_, Key::START);
  EXPECT_THAT(below(udo_), HasSubstr("MASCHINE HALT was pressed by station 7, eva"));
}

TEST_F(ScreenRows, AUTH_005_StopThatDeclinesSaysSo) {
  order([](auto& request) { request.mutable_select()->set_station(7); });
  ASSERT_THAT(eva_.screen.text(18), HasSubstr("STOP lehnt ab"));
  key(eva_, Key::STOP);
  EXPECT_THAT(eva_.screen.text(18), StartsWith("Die Maschine ist abgelehnt."));
  constexpr int kNoticeEnds_ms = 8500;
  advance_ms(kNoticeEnds_ms);
  refresh();
  EXPECT_THAT(eva_.screen.text(18), StartsWith("Betriebsart mit ihrer Taste wählen."));
}

TEST_F(ScreenRows, DEC_39_ResetSaysThatItGaveTheMachineBackAndNothingThatIsOver) {
  order([](auto& request) { request.mutable_select()->set_station(7); });
  key(eva_, Key::START);
  ASSERT_THAT(side(eva_, 3), HasSubstr("MASCHINE"));
  v1::ClientMessage chord;
  chord.mutable_key()->set_number(++eva_.number);
  chord.mutable_key()->add_keys(v1::KEY_ENTER);
  chord.mutable_key()->add_keys(v1::KEY_RESET);
  chord.mutable_key()->set_pressed(true);
  lab().receive(eva_.visit, chord);
  settle_until([&] {
    refresh();
    return side(eva_, 3).contains("TRAINING");
  });
  EXPECT_THAT(eva_.screen.text(18), StartsWith("RESET hat die Maschine abgegeben."));
  constexpr int kNoticeEnds_ms = 8500;
  advance_ms(kNoticeEnds_ms);
  refresh();
  EXPECT_THAT(below(eva_), Not(HasSubstr("solange dieser Platz die Maschine")));
}

TEST_F(ScreenRows, SEC_002_ThePasswordDialogLeavesNoSentenceBehind) {
  key(eva_, Key::LABOR);
  strike(eva_, Key::D2);
  refresh();
  EXPECT_THAT(eva_.screen.text(18), StartsWith("Betriebsart mit ihrer Taste wählen.")) << "whether or not Esc ends it";
}

}  // namespace
}  // namespace cnclab::lab
