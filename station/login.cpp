// The conversation from Welcome to LoginAnswer, and what each refusal means.
#include "station/login.hpp"

#include <cnclab/v1/envelope.pb.h>
#include <fmt/format.h>

#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/system/system_error.hpp>

#include "station/cell_text.hpp"

namespace cnclab::station {

namespace asio = boost::asio;

namespace {

// Longer than the server needs to hash a room full of passwords one after the other (SEC-002).
constexpr std::chrono::seconds kAnswerDeadline{30};

asio::awaitable<std::expected<Client, ConnectError>> connect_through(const Door& door) {
  return Client::connect(door.address, door.trust, door.kind, Client::kConnectDeadline, door.language);
}

Ending lost(const Door& door) {
  constexpr Text kText{"{}:{} hat die Verbindung während der Anmeldung beendet. Noch einmal versuchen.",
                       "{}:{} ended the connection during the login. Try again."};
  return {ExitCode::cannot_connect,
          fmt::format(fmt::runtime(kText.in(door.language)), door.address.host, door.address.port)};
}

// Sends one message and reads its LoginAnswer; a Bye instead ends.
asio::awaitable<std::expected<v1::LoginAnswer, Ending>> ask_server(Client& client, const v1::ClientMessage& question) {
  co_await client.write(question);
  for (;;) {
    const v1::ServerMessage message = co_await client.read();
    if (message.has_login()) co_return message.login();
    if (message.has_bye()) {
      const Language language = language_named(client.welcome().language());
      co_return std::unexpected(ending_of(message.bye().exit_code(), message.bye().text(), language));
    }
  }
}

asio::awaitable<std::expected<v1::LoginAnswer, Ending>> ask_in_time(Client& client, const v1::ClientMessage& question) {
  asio::steady_timer timer(co_await asio::this_coro::executor, kAnswerDeadline);
  const auto is_over = std::make_shared<bool>(false);
  timer.async_wait([is_over, &client](const boost::system::error_code&) {
    if (!*is_over) client.close();
  });
  struct Over {
    std::shared_ptr<bool> flag;
    ~Over() { *flag = true; }
  };
  const Over over{is_over};
  co_return co_await ask_server(client, question);
}

std::expected<LoggedIn, LoginFailure> judged(Client client, std::expected<v1::LoginAnswer, Ending> answer) {
  if (!answer) return std::unexpected(LoginFailure(std::move(answer.error())));
  if (answer->result() != v1::LOGIN_RESULT_OK) return std::unexpected(LoginFailure(std::move(*answer)));
  return LoggedIn{std::move(client), std::move(*answer)};
}

v1::ClientMessage login_message(const Credentials& credentials, bool has_media) {
  v1::ClientMessage message;
  v1::Login& login = *message.mutable_login();
  login.set_user(credentials.user);
  login.set_password(credentials.password);
  login.set_station(credentials.station);
  login.set_elsewhere(credentials.elsewhere);
  login.set_has_media(has_media);
  return message;
}

}  // namespace

asio::awaitable<std::expected<LoggedIn, LoginFailure>> attempt_login(Door door, Credentials credentials) {
  auto client = co_await connect_through(door);
  if (!client) co_return std::unexpected(LoginFailure(std::move(client.error())));
  try {
    const v1::ClientMessage login = login_message(credentials, door.media.has_value());
    auto answer = co_await ask_in_time(*client, login);
    bool is_changed = false;
    if (answer && answer->result() == v1::LOGIN_RESULT_PASSWORD_EXPIRED && credentials.new_password) {
      v1::ClientMessage change;
      change.mutable_change_password()->set_new_password(*credentials.new_password);
      answer = co_await ask_in_time(*client, change);
      is_changed = true;
    }
    auto login_or_failure = judged(std::move(*client), std::move(answer));
    if (login_or_failure) login_or_failure->has_new_password = is_changed;
    co_return login_or_failure;
  } catch (const boost::system::system_error&) {
    // the line was lost: said below
  }
  co_return std::unexpected(LoginFailure(lost(door)));
}

asio::awaitable<std::expected<LoggedIn, LoginFailure>> attempt_resume(Door door, std::string ticket) {
  auto client = co_await connect_through(door);
  if (!client) co_return std::unexpected(LoginFailure(std::move(client.error())));
  try {
    v1::ClientMessage resume;
    resume.mutable_resume()->set_ticket(ticket);
    resume.mutable_resume()->set_has_media(door.media.has_value());
    auto answer = co_await ask_in_time(*client, resume);
    co_return judged(std::move(*client), std::move(answer));
  } catch (const boost::system::system_error&) {
    // the line was lost: said below
  }
  co_return std::unexpected(LoginFailure(lost(door)));
}

asio::awaitable<std::expected<LoggedIn, Ending>> log_in(Door door, Credentials credentials, bool ask_first, Asker ask,
                                                        std::optional<v1::LoginAnswer> refusal) {
  for (bool must_ask = ask_first;; must_ask = true) {
    if (must_ask) {
      LoginQuestion question{credentials, {}, refusal};
      {
        const auto client = co_await connect_through(door);
        if (!client) co_return std::unexpected(client.error());
        question.welcome = client->welcome();
      }
      auto answer = co_await ask(std::move(question));
      if (!answer) co_return std::unexpected(std::move(answer.error()));
      credentials = std::move(*answer);
    }
    auto attempt = co_await attempt_login(door, credentials);
    if (attempt) co_return std::move(*attempt);
    if (const auto* const ending = std::get_if<Ending>(&attempt.error())) co_return std::unexpected(*ending);
    refusal = std::get<v1::LoginAnswer>(attempt.error());
  }
}

std::string refusal_text(const v1::LoginAnswer& answer, Language language) {
  if (!answer.text().empty()) return printable(answer.text());
  const auto said = [&](std::string_view german, std::string_view english, auto... values) {
    return fmt::format(fmt::runtime(Text{german, english}.in(language)), values...);
  };
  switch (answer.result()) {
    case v1::LOGIN_RESULT_WAIT:
      return said("Zu viele falsche Passwörter: {} s warten.", "Too many wrong passwords: wait {} s.",
                  answer.wait_seconds());
    case v1::LOGIN_RESULT_SEAT_TAKEN:
      return said("Der Platz ist besetzt: {}. Einen anderen Platz wählen.",
                  "The station is taken: {}. Choose another one.", answer.occupant());
    case v1::LOGIN_RESULT_ELSEWHERE:
      return said("Schon angemeldet an Platz {}.", "Already logged in at station {}.", answer.other_station());
    case v1::LOGIN_RESULT_PASSWORD_EXPIRED:
      return said("Bitte ein neues Passwort wählen.", "Please choose a new password.");
    case v1::LOGIN_RESULT_NOT_ALLOWED:
      return said("Diese Rolle darf das nicht.", "This role may not do that.");
    case v1::LOGIN_RESULT_TICKET_VOID:
      return said("Bitte neu anmelden.", "Please log in again.");
    case v1::LOGIN_RESULT_PASSWORD_WEAK:
      return said("Das neue Passwort braucht 8 bis 256 Zeichen.", "The new password needs 8 to 256 characters.");
    case v1::LOGIN_RESULT_UNSPECIFIED:
    case v1::LOGIN_RESULT_OK:
    case v1::LOGIN_RESULT_REFUSED:
    case v1::LoginResult_INT_MIN_SENTINEL_DO_NOT_USE_:
    case v1::LoginResult_INT_MAX_SENTINEL_DO_NOT_USE_:
      break;
  }
  return said("Name oder Passwort falsch.", "Name or password wrong.");
}

Ending ending_of(const v1::LoginAnswer& answer, Language language) {
  const auto said = [&](std::string_view german, std::string_view english, auto... values) {
    return fmt::format(fmt::runtime(Text{german, english}.in(language)), values...);
  };
  if (answer.result() == v1::LOGIN_RESULT_ELSEWHERE)
    return {
        ExitCode::login_refused,
        said("Schon angemeldet an Platz {}: --take-over übernimmt, --look-on sieht zu.",
             "Already logged in at station {}: --take-over takes over, --look-on looks on.", answer.other_station())};
  if (answer.result() == v1::LOGIN_RESULT_PASSWORD_EXPIRED)
    return {ExitCode::login_refused, said("Ein neues Passwort ist nötig: --new-password-file angeben.",
                                          "A new password is needed: give --new-password-file.")};
  const bool is_taken = answer.result() == v1::LOGIN_RESULT_SEAT_TAKEN;
  return {is_taken ? ExitCode::seat_taken : ExitCode::login_refused, refusal_text(answer, language)};
}

Ending ending_of(std::uint32_t exit_code, const std::string& text, Language language) {
  const ExitCode code = exit_code_of(exit_code);
  if (!text.empty() || code == ExitCode::ended_by_user) return {code, printable(text)};
  constexpr Text kReplaced{"Von einer anderen Anmeldung abgelöst.", "Replaced by another login."};
  constexpr Text kExpelled{"Die Lehrkraft hat die Verbindung beendet.", "The instructor ended the connection."};
  constexpr Text kEnded{"Der Server hat die Verbindung beendet.", "The server ended the connection."};
  const Text& own = code == ExitCode::replaced ? kReplaced : code == ExitCode::expelled ? kExpelled : kEnded;
  return {code, std::string(own.in(language))};
}

}  // namespace cnclab::station
