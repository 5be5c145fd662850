// The dialog for a new password: what is typed never shows, what cannot be right is refused before it travels
// (SEC-002).
#include "station/password_form.hpp"

#include <gtest/gtest.h>

namespace cnclab::station {
namespace {

using State = PasswordForm::State;

State type(PasswordForm& form, std::string_view utf8) {
  State state = State::editing;
  for (const char32_t code : from_utf8(utf8))
    state = form.handle(code == U'\r' ? Input(Special::enter) : Input(code), Language::german);
  return state;
}

std::string text_of(const PasswordForm& form, Language language = Language::german) {
  const Screen screen = form.over(Screen(), language);
  std::string text;
  for (int row = 0; row < Screen::kRows; ++row) text += screen.text(row) + "\n";
  return text;
}

TEST(PasswordForm, OldAndTwiceNewIsSubmitted) {
  PasswordForm form;
  EXPECT_EQ(type(form, "alt\rgrüner Frosch\rgrüner Frosch"), State::editing);
  EXPECT_EQ(text_of(form).find("Frosch"), std::string::npos);
  EXPECT_EQ(type(form, "\r"), State::submitted);
  EXPECT_EQ(form.old_password(), "alt");
  EXPECT_EQ(form.new_password(), "grüner Frosch");
}

TEST(PasswordForm, DifferentOrShortOnesBeginAnew) {
  struct Row {
    const char* keys;
    const char* notice;
  };
  for (const Row& row : {Row{"alt\reins zwei\reins drei\r", "verschieden"}, Row{"alt\rkurz\rkurz\r", "mindestens 8"}}) {
    PasswordForm form;
    EXPECT_EQ(type(form, row.keys), State::editing);
    EXPECT_NE(text_of(form).find(row.notice), std::string::npos) << text_of(form);
    EXPECT_EQ(form.old_password(), "");
  }
}

TEST(PasswordForm, EscapeCancelsAndBackspaceTakesAWholeCharacter) {
  PasswordForm form;
  static_cast<void>(type(form, "aü"));
  EXPECT_EQ(form.handle(Special::backspace, Language::german), State::editing);
  EXPECT_EQ(form.old_password(), "a");
  EXPECT_EQ(form.handle(Special::escape, Language::german), State::cancelled);
}

TEST(PasswordForm, TheMonitorStaysInViewAndNoRowIsCut) {
  Screen below;
  below.write(3, 51, "X  +0085.000");
  for (const Language language : {Language::german, Language::english}) {
    const Screen screen = PasswordForm().over(below, language);
    EXPECT_EQ(screen.row(3), below.row(3));
    for (int row = 18; row < Screen::kRows; ++row) EXPECT_EQ(screen.at(row, 79).code, U' ') << screen.text(row);
  }
}

}  // namespace
}  // namespace cnclab::station
