// Editing the three fields and drawing them.
#include "station/password_form.hpp"

#include "station/cell_text.hpp"
#include "station/form_keys.hpp"

namespace cnclab::station {
namespace {

constexpr std::size_t kShortest = 8, kLongest = 256;  // bytes, as the server wants them
constexpr int kHeading = 18, kFirst = 19, kKeys = 23, kMark = 26;

constexpr std::array<Text, 3> kLabels{{{"Altes Passwort", "Old password"},
                                       {"Neues Passwort", "New password"},
                                       {"Neues noch einmal", "New one once more"}}};

void remove_last_character(std::string& utf8) {
  while (!utf8.empty() && (static_cast<unsigned char>(utf8.back()) & 0xC0U) == 0x80U) utf8.pop_back();
  if (!utf8.empty()) utf8.pop_back();
}

}  // namespace

PasswordForm::State PasswordForm::handle(const Input& input, Language language) {
  std::string& value = values_.at(current_);
  if (const auto* const character = std::get_if<char32_t>(&input)) {
    const std::string typed = to_utf8(*character);
    if (value.size() + typed.size() <= kLongest) value += typed;
    return State::editing;
  }
  switch (lead_through(std::get<Special>(input), values_.size(), current_)) {
    case FormAct::cancel:
      return State::cancelled;
    case FormAct::submit:
      return submit(language);
    case FormAct::erase:
      remove_last_character(value);
      return State::editing;
    case FormAct::none:
      return State::editing;
  }
  return State::editing;
}

PasswordForm::State PasswordForm::submit(Language language) {
  const auto begin_anew = [&](const Text& why) {
    *this = PasswordForm();
    notice_ = why.in(language);
    return State::editing;
  };
  if (values_[1] != values_[2])
    return begin_anew({"Die neuen Passwörter sind verschieden. Bitte noch einmal.",
                       "The new passwords differ. Please enter them again."});
  if (new_password().size() < kShortest)
    return begin_anew(
        {"Das neue Passwort braucht mindestens 8 Zeichen.", "The new password needs at least 8 characters."});
  return State::submitted;
}

Screen PasswordForm::over(const Screen& below, Language language) const {
  constexpr Text kTitle{"Neues Passwort: wie Sie es tippen, ist nicht zu sehen.",
                        "New password: what you type is not shown."};
  constexpr Text kHelp{"Enter weiter   Tab nächstes Feld   Esc bricht ab   F12 MASCHINE HALT",
                       "Enter next   Tab next field   Esc cancels   F12 MACHINE HALT"};
  Screen screen = below;
  for (int row = kHeading; row < Screen::kRows; ++row) screen.set_row(row, Screen::Row{});
  screen.write(kHeading, 0, notice_.empty() ? std::string(kTitle.in(language)) : printable(notice_),
               notice_.empty() ? Attribute::normal : Attribute::inverse);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const int row = kFirst + static_cast<int>(i);
    const bool is_current = i == current_;
    screen.write(row, 1, kLabels[i].in(language), is_current ? Attribute::bold : Attribute::normal);
    if (!is_current) continue;
    screen.write(row, kMark - 2, ">");
    screen.put(row, kMark, {U' ', Attribute::inverse});
  }
  screen.write(kKeys, 1, kHelp.in(language));
  return screen;
}

}  // namespace cnclab::station
