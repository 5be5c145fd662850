// Passwords change: one that held once at the login, or the own one at the seat (SEC-002, SEC-003).
#include <spdlog/spdlog.h>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"
#include "shared/credential_limits.hpp"

namespace cnclab::lab {

void Lab::answer_password(const VisitPtr& visit, v1::LoginResult result, const std::string& text) const {
  v1::ServerMessage message;
  message.mutable_login()->set_result(result);
  message.mutable_login()->set_text(text);
  visit->peer->send(message);
}

void Lab::change_password(const VisitPtr& visit, const v1::ChangePassword& change) {
  const std::string& wish = change.new_password();
  if (wish.size() < kShortestPassword || wish.size() > kLongestPassword)
    return answer_password(visit, v1::LOGIN_RESULT_PASSWORD_WEAK,
                           say(tongue_with(*visit), "Das Passwort muss 8 bis 256 Zeichen haben.",
                               "The password must have 8 to 256 characters."));
  if (visit->stage == Stage::new_password) return change_expired_password(visit, wish);
  if (visit->stage != Stage::at_desk || visit->is_changing_password)
    return hang_up(visit, "password change out of order");
  change_own_password(visit, change);
}

void Lab::refuse_same_password(const VisitPtr& visit) const {
  answer_password(visit, v1::LOGIN_RESULT_PASSWORD_WEAK,
                  say(tongue_with(*visit), "Das neue Passwort muss ein anderes sein als das alte.",
                      "The new password must differ from the old one."));
}

void Lab::change_expired_password(const VisitPtr& visit, const std::string& wish) {
  visit->stage = Stage::checking;
  passwords_.verify(wish, visit->person.password_hash, [this, visit, wish, alive = alive_](bool is_same) {
    if (!*alive || visit->stage != Stage::checking) return;
    if (is_same) {
      visit->stage = Stage::new_password;
      return refuse_same_password(visit);
    }
    keep_password(visit, wish, [this, visit] {
      if (visit->stage == Stage::checking) admit(visit);
    });
  });
}

void Lab::change_own_password(const VisitPtr& visit, const v1::ChangePassword& change) {
  const std::string& name = visit->person.name;
  const auto tongue = tongue_of(visit->person);
  if (change.old_password().size() > kLongestPassword) return hang_up(visit, "password too long");
  if (change.old_password() == change.new_password()) return refuse_same_password(visit);
  if (const int wait = guard_.wait_seconds(name, visit->peer->address(), clock_.monotonic_ns()); wait > 0)
    return answer_password(visit, v1::LOGIN_RESULT_WAIT,
                           say(tongue, "Zu viele falsche Passwörter: bitte warten, Sekunden: ",
                               "Too many wrong passwords: please wait, seconds: ") +
                               std::to_string(wait));
  visit->is_changing_password = true;
  const auto compared = [this, visit, tongue, wish = change.new_password(), alive = alive_](bool fits) {
    if (!*alive || visit->stage != Stage::at_desk) return;
    if (!fits) {
      visit->is_changing_password = false;
      guard_.failed(visit->person.name, visit->peer->address(), clock_.monotonic_ns());
      journal_.write("password_refused", visit->peer->address(), visit->desk->station, visit->person.name);
      return answer_password(visit, v1::LOGIN_RESULT_REFUSED,
                             say(tongue, "Das alte Passwort ist falsch.", "The old password is wrong."));
    }
    guard_.succeeded(visit->person.name);
    keep_password(visit, wish, [this, visit, tongue] {
      if (visit->stage != Stage::at_desk) return;
      const std::string text = say(tongue, "Das Passwort ist geändert.", "The password is changed.");
      answer_password(visit, v1::LOGIN_RESULT_OK, text);
      note(*visit->desk, text);
    });
  };
  // As it is now: an instructor may have given a new one meanwhile.
  store_.run([name](db::Database& database) { return database.person(name); },
             [this, visit, old = change.old_password(), compared,
              alive = alive_](const std::expected<std::optional<db::Person>, db::StoreError>& found) {
               if (!*alive || visit->stage != Stage::at_desk) return;
               const bool is_known = found && found->has_value();
               passwords_.verify(old, is_known ? (*found)->password_hash : std::string(), compared);
             });
}

void Lab::keep_password(const VisitPtr& visit, const std::string& wish, std::function<void()> kept) {
  passwords_.hash(wish, [this, visit, kept = std::move(kept), alive = alive_](const std::string& hash) {
    if (!*alive || visit->stage == Stage::gone) return;
    store_.run([id = visit->person.id, hash](db::Database& database) { database.set_password(id, hash, false); },
               [this, visit, hash, kept, alive](const std::expected<void, db::StoreError>& result) {
                 visit->is_changing_password = false;
                 if (!*alive || visit->stage == Stage::gone) return;
                 if (!result) {
                   const std::string why = sentence_for(result.error(), tongue_of(visit->person));
                   if (visit->stage == Stage::checking) return refuse(visit, v1::LOGIN_RESULT_REFUSED, why);
                   return answer_password(visit, v1::LOGIN_RESULT_REFUSED, why);
                 }
                 visit->person.password_hash = hash;
                 visit->person.must_change = false;
                 journal_.write("password_changed", "", 0, visit->person.name);
                 kept();
               });
  });
}

}  // namespace cnclab::lab
