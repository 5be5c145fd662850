// Logging in, coming back, leaving (SEAT-001 to SEAT-004, SEC-002 to SEC-004).
#include <sodium.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"
#include "lab/stored_control.hpp"
#include "shared/credential_limits.hpp"
#include "shared/frame.hpp"
#include "shared/station_id.hpp"

namespace cnclab::lab {

namespace {

v1::ServerMessage answer_with(v1::LoginResult result, const std::string& text) {
  v1::ServerMessage message;
  message.mutable_login()->set_result(result);
  message.mutable_login()->set_text(text);
  return message;
}

panel::Settings settings_for(const Configuration& configuration, const db::Person& person, language::Tongue tongue) {
  panel::Settings settings;
  settings.student = person.name;
  settings.vocabulary.model = configuration.model;
  if (person.model == "3300") settings.vocabulary.model = language::Model::cnc3300;
  if (person.model == "3250") settings.vocabulary.model = language::Model::cnc3250;
  settings.vocabulary.planned_functions = configuration.planned_functions;
  settings.tongue = tongue;
  settings.hints = configuration.hints;
  settings.start_in_middle_rebuilds = configuration.start_in_middle == "rebuilt";
  settings.memory_bytes = configuration.memory_bytes;
  settings.rests_accumulate = configuration.rests == "original";
  settings.io_cards = {};
  for (const int card : configuration.io_cards) settings.io_cards.at(static_cast<std::size_t>(card - 1)) = true;
  settings.keys_19inch = configuration.keys_19inch;
  settings.remote = configuration.remote;
  return settings;
}

constexpr int kExpelled = 9;  ///< exit code of a station

std::string expelled_text(language::Tongue tongue) {
  return say(tongue, "Die Lehrkraft hat die Verbindung beendet.", "The instructor has ended the connection.");
}

}  // namespace

void Lab::greet(const VisitPtr& visit, const v1::ClientMessage& message) {
  const auto stage = visit->stage;
  if (stage == Stage::checking && message.has_alive()) return;
  if (stage == Stage::greeting && message.has_hello()) {
    const auto& hello = message.hello();
    const bool known = hello.version() == kProtocolVersion && hello.kind() != v1::CLIENT_KIND_UNSPECIFIED &&
                       v1::ClientKind_IsValid(hello.kind());
    v1::ServerMessage answer;
    auto& welcome = *answer.mutable_welcome();
    welcome.set_accepted(known);
    welcome.add_versions(kProtocolVersion);
    welcome.set_language(configuration_.tongue == language::Tongue::german ? "de" : "en");
    welcome.set_text(known ? "cnclab"
                           : say(configuration_.tongue,
                                 "Dieser Server spricht Protokollversion 1: bitte die Station aktualisieren.",
                                 "This server speaks protocol version 1: please update the station."));
    for (int station = StationId::kFirst; station <= StationId::kLast; ++station) {
      auto& seat = *welcome.add_seats();
      seat.set_station(static_cast<std::uint32_t>(station));
      seat.set_is_free(!seats_.at(station));
    }
    visit->peer->send(answer);
    if (!known) return hang_up(visit, "protocol version " + std::to_string(hello.version()));
    visit->kind = hello.kind();
    if (hello.takes_parts()) visit->row_form = RowForm::changed_part;
    visit->stage = Stage::login;
    return;
  }
  if (stage == Stage::login && message.has_login()) return log_in(visit, message.login());
  if (stage == Stage::login && message.has_resume()) return resume(visit, message.resume());
  if (stage == Stage::new_password && message.has_change_password())
    return change_password(visit, message.change_password());
  hang_up(visit, "message out of order");
}

void Lab::log_in(const VisitPtr& visit, const v1::Login& login) {
  if (login.user().size() > kLongestName || login.password().size() > kLongestPassword)
    return hang_up(visit, "name or password too long");
  const int wait = guard_.wait_seconds(login.user(), visit->peer->address(), clock_.monotonic_ns());
  if (wait > 0) {
    auto message = answer_with(v1::LOGIN_RESULT_WAIT,
                               say(configuration_.tongue, "Zu viele falsche Passwörter: bitte warten, Sekunden: ",
                                   "Too many wrong passwords: please wait, seconds: ") +
                                   std::to_string(wait));
    message.mutable_login()->set_wait_seconds(static_cast<std::uint32_t>(wait));
    visit->peer->send(message);
    return;
  }
  visit->login = login;
  visit->has_media = login.has_media();
  visit->stage = Stage::checking;
  store_.run([name = login.user()](db::Database& database) { return database.person(name); },
             [this, visit, alive = alive_](const std::expected<std::optional<db::Person>, db::StoreError>& found) {
               if (!*alive || visit->stage != Stage::checking) return;
               if (!found)
                 return refuse(visit, v1::LOGIN_RESULT_REFUSED, sentence_for(found.error(), configuration_.tongue));
               const auto& person = *found;
               const bool active = person && !person->archived_ms;
               passwords_.verify(visit->login.password(), active ? person->password_hash : std::string(),
                                 [this, visit, person, alive](bool fits) {
                                   if (*alive && visit->stage == Stage::checking) password_checked(visit, person, fits);
                                 });
             });
}

void Lab::password_checked(const VisitPtr& visit, const std::optional<db::Person>& person, bool fits) {
  auto& typed = *visit->login.mutable_password();
  sodium_memzero(typed.data(), typed.size());
  if (!fits || !person) {
    guard_.failed(visit->login.user(), visit->peer->address(), clock_.monotonic_ns());
    journal_.write("login_refused", visit->peer->address(), static_cast<int>(visit->login.station()),
                   visit->login.user());
    return refuse(visit, v1::LOGIN_RESULT_REFUSED,
                  say(configuration_.tongue, "Name oder Passwort ist falsch.", "Name or password is wrong."));
  }
  guard_.succeeded(visit->login.user());
  visit->person = *person;
  if (person->must_change) {
    visit->stage = Stage::new_password;
    visit->peer->send(answer_with(v1::LOGIN_RESULT_PASSWORD_EXPIRED,
                                  say(tongue_with(*visit), "Bitte ein neues Passwort wählen (mindestens 8 Zeichen).",
                                      "Please choose a new password (at least 8 characters).")));
    return;
  }
  admit(visit);
}

void Lab::admit(const VisitPtr& visit) {
  visit->heard_ns = clock_.monotonic_ns();  // while its password was compared it had nothing to say
  const bool instructor = visit->person.role == "instructor";
  const bool may_observe = instructor || visit->person.role == "observer";
  const auto not_allowed = [&] {
    refuse(visit, v1::LOGIN_RESULT_NOT_ALLOWED,
           say(tongue_with(*visit), "Diese Rolle darf das nicht.", "This role may not do that."));
  };
  switch (visit->kind) {
    case v1::CLIENT_KIND_INSTRUCTOR:
      if (!instructor) return not_allowed();
      visit->stage = Stage::at_console;
      break;
    case v1::CLIENT_KIND_OBSERVER:
      if (!may_observe || !StationId::of(visit->login.station())) return not_allowed();
      visit->stage = Stage::looking_on;
      visit->watched_station = static_cast<int>(visit->login.station());
      break;
    default:
      if (visit->person.role == "observer") return not_allowed();
      return admit_station(visit);
  }
  auto message = answer_with(v1::LOGIN_RESULT_OK, "");
  message.mutable_login()->set_user(visit->person.name);
  message.mutable_login()->set_role(visit->person.role);
  message.mutable_login()->set_station(visit->login.station());
  message.mutable_login()->set_language(tongue_of(visit->person) == language::Tongue::german ? "de" : "en");
  visit->peer->send(message);
  journal_.write("login", visit->peer->address(), static_cast<int>(visit->login.station()), visit->person.name);
  everybody_changed();
}

void Lab::admit_station(const VisitPtr& visit) {
  const auto tongue = tongue_with(*visit);
  const auto station = StationId::of(visit->login.station());
  if (!station)
    return refuse(visit, v1::LOGIN_RESULT_NOT_ALLOWED,
                  say(tongue, "Plätze haben die Nummern 1 bis 15.", "Stations have the numbers 1 to 15."));
  const DeskPtr mine = seats_.of(visit->person.id);
  if (const DeskPtr other = seats_.at(station->number()); other && other != mine) {
    auto message = answer_with(
        v1::LOGIN_RESULT_SEAT_TAKEN,
        say(tongue, "An diesem Platz sitzt schon ", "This station is taken by ") + other->person.name + ".");
    message.mutable_login()->set_occupant(other->person.name);
    visit->peer->send(message);
    visit->stage = Stage::login;
    return;
  }
  if (!mine) return load_desk(visit);
  if (!mine->is_seated()) return sit_down(visit, mine, station->number());
  admit_elsewhere(visit, mine, station->number());
}

/// The student sits somewhere already: one of the two goes on (SEAT-003).
void Lab::admit_elsewhere(const VisitPtr& visit, const DeskPtr& mine, int station) {
  switch (visit->login.elsewhere()) {
    case v1::ELSEWHERE_TAKE_OVER: {
      const VisitPtr former = mine->visit.lock();
      vacate(former, "taken over");
      farewell(former, 6,
               say(tongue_of(mine->person), "Anmeldung an einem anderen Platz übernommen.",
                   "Taken over at another station."));
      return sit_down(visit, mine, station);
    }
    case v1::ELSEWHERE_LOOK_ON: {
      visit->stage = Stage::looking_on;
      visit->own_control = mine;
      auto message = answer_with(v1::LOGIN_RESULT_OK, "");
      message.mutable_login()->set_user(visit->person.name);
      message.mutable_login()->set_station(static_cast<std::uint32_t>(mine->station));
      message.mutable_login()->set_language(tongue_of(mine->person) == language::Tongue::german ? "de" : "en");
      visit->peer->send(message);
      mine->is_dirty = true;
      return;
    }
    default: {
      auto message = answer_with(v1::LOGIN_RESULT_ELSEWHERE, say(tongue_with(*visit), "Schon angemeldet an Platz ",
                                                                 "Already logged in at station ") +
                                                                 std::to_string(mine->station) + ".");
      message.mutable_login()->set_other_station(static_cast<std::uint32_t>(mine->station));
      visit->peer->send(message);
      visit->stage = Stage::login;
    }
  }
}

void Lab::load_desk(const VisitPtr& visit) {
  visit->stage = Stage::checking;
  store_.run([id = visit->person.id](db::Database& database) { return read_control(database, id); },
             [this, visit, alive = alive_](const std::expected<StoredControl, db::StoreError>& stored) {
               if (!*alive || visit->stage != Stage::checking) return;
               if (!stored)
                 return refuse(visit, v1::LOGIN_RESULT_REFUSED, sentence_for(stored.error(), tongue_with(*visit)));
               if (seats_.of(visit->person.id)) return admit_station(visit);  // the same student was faster elsewhere
               const auto& person = visit->person;
               panel::Settings settings = settings_for(configuration_, person, tongue_of(person));
               settings.workpiece = machine_.workpiece();
               settings.long_work = [this](std::function<void()> job) { long_work_.enqueue(std::move(job)); };
               settings.picture_work = [this](std::function<void()> job) { pictures_.enqueue(std::move(job)); };
               const auto desk = std::make_shared<Desk>(
                   person, std::move(settings), memory_of(stored->programs, configuration_.memory_bytes),
                   machine_data_of(stored->machine_data), ticks_, workpieces_, store_);
               if (!stored->state.empty()) desk->control.restore_state(stored->state);
               if (is_damaged(stored->machine_data)) restore_machine_data(desk);
               desk->made_ns = clock_.monotonic_ns();
               desk->saved_state = stored->state;
               take_up_cassettes(desk, stored->cassettes);
               seats_.add(desk);
               admit_station(visit);
             });
}

void Lab::restore_machine_data(const DeskPtr& desk) {
  desk->control.tell_data_restored();
  store_.run([id = desk->person.id, author = db::Author{desk->person.name, desk->station, clock_.unix_ms()}](
                 db::Database& database) { lab::carry_out(database, id, panel::PutMachineData{}, author); },
             [name = desk->person.name](const std::expected<void, db::StoreError>& result) {
               if (!result) spdlog::error("{}: machine data not restored: {}", name, result.error().text);
             });
}

void Lab::resume(const VisitPtr& visit, const v1::Resume& resume) {
  if (std::ranges::find(expelled_, resume.ticket()) != expelled_.end())
    return farewell(visit, kExpelled, expelled_text(configuration_.tongue));
  const auto desks = seats_.all();
  const auto found = std::ranges::find_if(desks, [&](const DeskPtr& desk) {
    const std::string& ticket = desk->ticket;
    return !ticket.empty() && ticket.size() == resume.ticket().size() &&
           sodium_memcmp(ticket.data(), resume.ticket().data(), ticket.size()) == 0;
  });
  if (visit->kind != v1::CLIENT_KIND_STATION || found == desks.end())
    return refuse(visit, v1::LOGIN_RESULT_TICKET_VOID,
                  say(configuration_.tongue, "Bitte neu anmelden.", "Please log in again."));
  const DeskPtr& desk = *found;
  visit->person = desk->person;
  visit->has_media = resume.has_media();
  if (const DeskPtr other = seats_.at(desk->station); other && other != desk) {
    auto message = answer_with(v1::LOGIN_RESULT_SEAT_TAKEN, say(tongue_of(desk->person), "An diesem Platz sitzt jetzt ",
                                                                "This station is now taken by ") +
                                                                other->person.name + ".");
    message.mutable_login()->set_occupant(other->person.name);
    visit->peer->send(message);
    visit->stage = Stage::login;
    return;
  }
  if (const VisitPtr former = desk->visit.lock()) hang_up(former, "replaced by its own reconnect");
  sit_down(visit, desk, desk->station);
}

void Lab::sit_down(const VisitPtr& visit, const DeskPtr& desk, int station) {
  visit->stage = Stage::at_desk;
  visit->heard_ns = clock_.monotonic_ns();  // while its password was compared it had nothing to say
  visit->desk = desk;
  visit->feed = ScreenFeed{};
  desk->visit = visit;
  if (desk->person.language != visit->person.language) {  // the instructor has set it while the control was kept
    desk->person.language = visit->person.language;
    desk->control.set_tongue(tongue_of(desk->person));
  }
  if (desk->station != station) end_looking_on(desk);
  desk->station = station;
  desk->login = LoginId{++logins_};
  desk->ticket = random_ticket();
  desk->received = 0;
  desk->waiting.clear();
  if (desk->storing) desk->storing = 0;  // an input of the former connection: nothing to acknowledge here
  desk->labor.reset();
  desk->is_dirty = true;
  lines_.fit(*desk, !visit->login.user().empty());  // a reconnect has no login of its own: its token stays
  auto message = answer_with(v1::LOGIN_RESULT_OK, "");
  auto& login = *message.mutable_login();
  login.set_user(desk->person.name);
  login.set_role(desk->person.role);
  login.set_station(static_cast<std::uint32_t>(station));
  login.set_ticket(desk->ticket);
  login.set_language(tongue_of(desk->person) == language::Tongue::german ? "de" : "en");
  visit->peer->send(message);
  send_beat(visit);
  journal_.write("login", visit->peer->address(), station, desk->person.name);
  store_.run(
      [id = desk->person.id, time = clock_.unix_ms()](db::Database& database) { database.set_last_seen(id, time); },
      [](const std::expected<void, db::StoreError>&) {});
  seat_media(visit, desk);
  static_cast<void>(decide(LoggedIn{station, desk->login}, tongue_of(desk->person)));
  set_locked(desk, locked_.contains(desk->person.id));
  if (!desk->unread.empty()) note(*desk, std::exchange(desk->unread, {}));
  everybody_changed();
}

void Lab::refuse(const VisitPtr& visit, v1::LoginResult result, const std::string& text) {
  visit->stage = Stage::login;
  visit->peer->send(answer_with(result, text));
}

void Lab::vacate(const VisitPtr& visit, const std::string& why) {
  const DeskPtr desk = visit->desk;
  if (!desk) return;
  visit->desk.reset();
  if (desk->visit.lock() != visit) return;
  desk->visit.reset();
  static_cast<void>(decide(LoggedOut{desk->login, why}, configuration_.tongue));
  desk->login = kNoLogin;
  desk->stop_training();
  lines_.cut_of(*desk);
  pause_media(*desk);
  desk->waiting.clear();
  desk->keep_until_ns = clock_.monotonic_ns() + configuration_.keep_minutes * 60'000'000'000LL;
  journal_.write("left", why, desk->station, desk->person.name);
  if (desk->station == shown_station_) show_to_all(0);
  save_state(desk);
  everybody_changed();
}

void Lab::log_out(const VisitPtr& visit, const std::string& why) {
  const DeskPtr desk = visit->desk;
  vacate(visit, why);
  if (desk) dismiss(desk);
  farewell(visit, 0, say(tongue_of(visit->person), "Abgemeldet.", "Logged out."));
}

void Lab::expel(const DeskPtr& desk) {
  constexpr std::size_t kRemembered = 64;
  if (const VisitPtr visit = desk->visit.lock()) {
    vacate(visit, "expelled");
    dismiss(desk);
    return farewell(visit, kExpelled, expelled_text(tongue_of(desk->person)));
  }
  expelled_.push_back(desk->ticket);  // the station is told when its line is back
  if (expelled_.size() > kRemembered) expelled_.pop_front();
  dismiss(desk);
}

void Lab::end_looking_on(const DeskPtr& desk) {
  const std::vector<VisitPtr> visits = visits_;
  for (const VisitPtr& visit : visits)
    if (visit->stage == Stage::looking_on && visit->own_control.lock() == desk)
      farewell(visit, 0,
               say(tongue_of(desk->person), "Die Anmeldung, der hier zugesehen wurde, ist beendet.",
                   "The login that was looked at here has ended."));
}

void Lab::dismiss(const DeskPtr& desk) {
  end_looking_on(desk);
  seats_.lower_hand(*desk);
  if (desk->on_lab_machine) {  // its run is still coming to rest: poll asks again
    desk->keep_until_ns = 0;
    return;
  }
  save_state(desk);
  end_recording(desk, *desk->recorder, machine::StopCause::operator_stop);
  desk->leave_machines();
  seats_.remove(*desk);
  everybody_changed();
}

}  // namespace cnclab::lab
