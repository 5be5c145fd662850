// The login form: seat, name, password; a new password where one is due; what to do with a login elsewhere.
#pragma once

#include <expected>
#include <string>
#include <vector>

#include "shared/screen.hpp"
#include "station/keymap.hpp"
#include "station/login.hpp"

namespace cnclab::station {

/// What the form asks for. Decided by the last refusal.
class LoginForm {
 public:
  enum class State : std::uint8_t { editing, submitted, cancelled };

  /// Asks for what `question` leaves open; `is_seat_fixed` when the seat came with the command line.
  LoginForm(const LoginQuestion& question, bool is_seat_fixed, bool is_user_fixed, Language language);

  State handle(const Input& input);
  /// Others have come and gone while the form was filled in.
  void renew_seats(const v1::Welcome& welcome);
  [[nodiscard]] Screen screen() const;
  /// What was entered, once submitted.
  [[nodiscard]] Credentials credentials() const;

 private:
  enum class FieldKind : std::uint8_t { seat, user, password, new_password, repeated, elsewhere };
  struct Field {
    FieldKind kind;
    Text label;
    std::u32string value;
    [[nodiscard]] bool is_secret() const {
      return kind == FieldKind::password || kind == FieldKind::new_password || kind == FieldKind::repeated;
    }
  };
  void add_login_fields(bool is_seat_fixed, bool is_user_fixed);
  void add_new_password_fields();
  State submit();
  void type(char32_t character);
  [[nodiscard]] const std::u32string* value_of(FieldKind kind) const;
  [[nodiscard]] bool is_seat_wrong() const;
  [[nodiscard]] std::string said(std::string_view german, std::string_view english) const {
    return std::string(Text{german, english}.in(language_));
  }
  [[nodiscard]] std::string free_seats() const;
  void draw_field(Screen& screen, int row, std::size_t index) const;

  LoginQuestion question_;
  Language language_;
  std::vector<Field> fields_;
  std::size_t current_ = 0;
  std::string notice_;
};

}  // namespace cnclab::station
