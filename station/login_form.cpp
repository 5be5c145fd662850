// Editing the fields and drawing them; no terminal here.
#include "station/login_form.hpp"

#include <charconv>

#include "shared/credential_limits.hpp"
#include "station/cell_text.hpp"
#include "station/form_keys.hpp"

namespace cnclab::station {
namespace {

constexpr int kFirstField = 7, kLabel = 4, kValue = 26, kNotice = 16, kLeadRow = 22, kWidth = 72;

std::uint32_t number_of(const std::u32string& text) {
  const std::string digits = to_utf8(text);
  std::uint32_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

LoginForm::LoginForm(const LoginQuestion& question, bool is_seat_fixed, bool is_user_fixed, Language language)
    : question_(question), language_(language) {
  const auto result = question_.refusal ? question_.refusal->result() : v1::LOGIN_RESULT_UNSPECIFIED;
  if (question_.refusal) notice_ = printable(refusal_text(*question_.refusal, language_));
  if (result == v1::LOGIN_RESULT_ELSEWHERE) {
    fields_.push_back({FieldKind::elsewhere, {"1 übernehmen 2 zusehen", "1 take over 2 look on"}, U""});
  } else if (result == v1::LOGIN_RESULT_PASSWORD_EXPIRED || result == v1::LOGIN_RESULT_PASSWORD_WEAK) {
    add_new_password_fields();
  } else {
    const bool is_other_seat_needed = result == v1::LOGIN_RESULT_SEAT_TAKEN && !is_seat_fixed;
    if (is_other_seat_needed) question_.so_far.station = 0;
    add_login_fields(is_seat_fixed, is_user_fixed);
  }
}

void LoginForm::add_login_fields(bool is_seat_fixed, bool is_user_fixed) {
  const Credentials& known = question_.so_far;
  if (!is_seat_fixed) {
    const std::string seat = known.station == 0 ? "" : std::to_string(known.station);
    fields_.push_back({FieldKind::seat, {"Platz", "Station"}, from_utf8(seat)});
  }
  if (!is_user_fixed) fields_.push_back({FieldKind::user, {"Name", "Name"}, from_utf8(known.user)});
  fields_.push_back({FieldKind::password, {"Passwort", "Password"}, U""});
  while (current_ + 1 < fields_.size() && !fields_[current_].value.empty()) ++current_;
}

void LoginForm::add_new_password_fields() {
  fields_.push_back({FieldKind::new_password, {"Neues Passwort", "New password"}, U""});
  fields_.push_back({FieldKind::repeated, {"noch einmal", "once more"}, U""});
}

LoginForm::State LoginForm::handle(const Input& input) {
  if (const auto* const character = std::get_if<char32_t>(&input)) {
    type(*character);
    return State::editing;
  }
  switch (lead_through(std::get<Special>(input), fields_.size(), current_)) {
    case FormAct::cancel:
      return State::cancelled;
    case FormAct::submit:
      return submit();
    case FormAct::erase:
      if (!fields_[current_].value.empty()) fields_[current_].value.pop_back();
      return State::editing;
    case FormAct::none:
      return State::editing;
  }
  return State::editing;
}

void LoginForm::type(char32_t character) {
  Field& field = fields_[current_];
  const bool is_digit = character >= U'0' && character <= U'9';
  switch (field.kind) {
    case FieldKind::seat:
      if (is_digit && field.value.size() < 2) field.value += character;
      break;
    case FieldKind::elsewhere:
      if (character == U'1' || character == U'2') field.value = std::u32string(1, character);
      break;
    case FieldKind::user:
      if (to_utf8(field.value).size() + to_utf8(character).size() <= kLongestName) field.value += character;
      break;
    case FieldKind::password:
    case FieldKind::new_password:
    case FieldKind::repeated:
      if (to_utf8(field.value).size() + to_utf8(character).size() <= kLongestPassword) field.value += character;
      break;
  }
}

LoginForm::State LoginForm::submit() {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!fields_[i].value.empty()) continue;
    current_ = i;
    notice_ = said("Bitte ausfüllen: ", "Please fill in: ") + std::string(fields_[i].label.in(language_));
    return State::editing;
  }
  if (is_seat_wrong()) {
    current_ = 0;
    notice_ = said("Plätze haben die Nummern 1 bis 15.", "Stations have the numbers 1 to 15.");
    return State::editing;
  }
  const auto* const fresh = value_of(FieldKind::new_password);
  if (fresh != nullptr && *fresh != *value_of(FieldKind::repeated)) {
    for (Field& field : fields_) field.value.clear();
    current_ = 0;
    notice_ = said("Die beiden Eingaben sind verschieden. Bitte beide noch einmal.",
                   "The two entries differ. Please enter both again.");
    return State::editing;
  }
  return State::submitted;
}

const std::u32string* LoginForm::value_of(FieldKind kind) const {
  for (const Field& field : fields_) {
    if (field.kind == kind) return &field.value;
  }
  return nullptr;
}

bool LoginForm::is_seat_wrong() const {
  const auto* const seat = value_of(FieldKind::seat);
  return seat != nullptr && (number_of(*seat) < 1 || number_of(*seat) > 15);
}

Credentials LoginForm::credentials() const {
  Credentials entered = question_.so_far;
  if (const auto* const seat = value_of(FieldKind::seat)) entered.station = number_of(*seat);
  if (const auto* const user = value_of(FieldKind::user)) entered.user = to_utf8(*user);
  if (const auto* const password = value_of(FieldKind::password)) entered.password = to_utf8(*password);
  if (const auto* const fresh = value_of(FieldKind::new_password)) entered.new_password = to_utf8(*fresh);
  if (const auto* const choice = value_of(FieldKind::elsewhere)) {
    entered.elsewhere = *choice == U"1" ? v1::ELSEWHERE_TAKE_OVER : v1::ELSEWHERE_LOOK_ON;
  }
  return entered;
}

void LoginForm::renew_seats(const v1::Welcome& welcome) { *question_.welcome.mutable_seats() = welcome.seats(); }

std::string LoginForm::free_seats() const {
  std::string seats;
  for (const v1::Seat& seat : question_.welcome.seats()) {
    if (seat.is_free()) seats += ' ' + std::to_string(seat.station());
  }
  return said("Freie Plätze:", "Free stations:") + (seats.empty() ? said(" keiner", " none") : seats);
}

void LoginForm::draw_field(Screen& screen, int row, std::size_t index) const {
  const Field& field = fields_[index];
  const bool is_current = index == current_;
  screen.write(row, kLabel, field.label.in(language_), is_current ? Attribute::bold : Attribute::normal);
  // A secret shows nothing, not even its length.
  const std::u32string shown = field.is_secret() ? U"" : field.value;
  const std::string text = to_utf8(shown.size() > 40 ? shown.substr(shown.size() - 40) : shown);
  screen.write(row, kValue + 4, text);
  if (is_current) {
    const int cursor = kValue + 4 + static_cast<int>(from_utf8(text).size());
    screen.put(row, cursor, {U' ', Attribute::inverse});
    screen.write(row, kValue + 2, ">");
  }
}

Screen LoginForm::screen() const {
  Screen screen;
  screen.write(1, kLabel, said("CNC 3300 – Anmeldung", "CNC 3300 – login"), Attribute::bold);
  screen.write(3, kLabel, free_seats(), Attribute::normal, kWidth);
  screen.write(5, kLabel,
               said("Die Anlage zeichnet Tasten, Programme und Läufe auf (Journal).",
                    "The lab records keys, programs and runs (journal)."),
               Attribute::dim);
  for (std::size_t i = 0; i < fields_.size(); ++i) draw_field(screen, kFirstField + 2 * static_cast<int>(i), i);
  int row = kNotice;
  for (const std::string& line : wrapped(notice_, kWidth))
    if (row < kLeadRow - 1) screen.write(row++, kLabel, line, Attribute::inverse);
  screen.write(kLeadRow, kLabel,
               said("Enter weiter   Tab nächstes Feld   Esc beendet", "Enter next   Tab next field   Esc ends"));
  return screen;
}

}  // namespace cnclab::station
