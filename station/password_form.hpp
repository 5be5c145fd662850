// The dialog for a new password, in the lab's rows 18 to 23: the old one, the new one twice. The monitor stays in view.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "shared/screen.hpp"
#include "station/keymap.hpp"
#include "station/language.hpp"

namespace cnclab::station {

/// Shows nothing of what is typed, not even its length.
class PasswordForm {
 public:
  enum class State : std::uint8_t { editing, submitted, cancelled };

  State handle(const Input& input, Language language);
  /// A sentence for row 18 in place of the heading.
  void say(const std::string& sentence) { notice_ = sentence; }
  /// `below` with the dialog over its rows 18 to 23.
  [[nodiscard]] Screen over(const Screen& below, Language language) const;

  // Once submitted
  [[nodiscard]] const std::string& old_password() const { return values_[0]; }
  [[nodiscard]] const std::string& new_password() const { return values_[1]; }

 private:
  State submit(Language language);
  std::array<std::string, 3> values_{};  ///< old, new, new once more; UTF-8
  std::size_t current_ = 0;
  std::string notice_;
};

}  // namespace cnclab::station
