// From the login form to the monitor, and back to the form where a ticket has become void.
#include "station/terminal_station.hpp"

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>
#include <utility>

#include "station/login_form.hpp"
#include "station/monitor.hpp"

namespace cnclab::station {

namespace asio = boost::asio;
using asio::experimental::awaitable_operators::operator||;

namespace {

// What the login needs from the command line, and the terminal to ask on.
struct Desk {
  Options options;
  Terminal& terminal;
  TerminalEvents& events;
  Broadcast& changed;
  bool is_form_open = false;
  bool is_form_touched = false;   // since the free seats were asked for
  bool has_new_password = false;  // the file of the new password holds from now on
  std::string last_user = {};     // proposed when the form comes back
  std::uint32_t last_seat = 0;
  Credentials typed = {};  // in the form, for the way back after the server was started anew (SEAT-005)
};

std::expected<Credentials, Ending> known_credentials(const Desk& desk) {
  const Options& options = desk.options;
  Credentials credentials{options.user.empty() ? desk.last_user : options.user,
                          {},
                          options.seat() == 0 ? desk.last_seat : options.seat(),
                          options.elsewhere,
                          std::nullopt};
  if (options.new_password_file) {
    auto fresh = read_password(*options.new_password_file);
    if (!fresh) return std::unexpected(fresh.error());
    credentials.new_password = std::move(*fresh);
  }
  if (desk.has_new_password && credentials.new_password) {
    credentials.password = *credentials.new_password;
  } else if (options.password_file) {
    auto password = read_password(*options.password_file);
    if (!password) return std::unexpected(password.error());
    credentials.password = std::move(*password);
  } else {
    credentials.password = desk.typed.password;
    if (desk.typed.elsewhere == v1::ELSEWHERE_LOOK_ON) credentials.elsewhere = desk.typed.elsewhere;
  }
  return credentials;
}

// Asking again cannot help where the command line itself is refused.
bool is_final(const Options& options, const v1::LoginAnswer& refusal) {
  switch (refusal.result()) {
    case v1::LOGIN_RESULT_SEAT_TAKEN:
      return options.seat() != 0;
    case v1::LOGIN_RESULT_NOT_ALLOWED:
      return options.seat() != 0 && !options.user.empty();
    case v1::LOGIN_RESULT_REFUSED:
    case v1::LOGIN_RESULT_WAIT:
      return options.password_file.has_value() && !options.user.empty();
    default:
      return false;
  }
}

// A pasted character is text like a typed one.
std::optional<Input> form_input(const TerminalEvent& event) {
  if (const auto* const stray = std::get_if<Stray>(&event)) return stray->character;
  const auto* const input = std::get_if<Input>(&event);
  return input == nullptr ? std::nullopt : std::optional(*input);
}

using Entered = std::expected<Credentials, Ending>;

asio::awaitable<Entered> edit(Desk& desk, LoginForm& form, Language language) {
  for (;;) {
    if (desk.events.take_resized()) desk.terminal.redraw();
    while (const auto event = desk.events.take()) {
      const auto input = form_input(*event);
      if (!input) continue;
      desk.is_form_touched = true;
      const auto state = form.handle(*input);
      if (state == LoginForm::State::submitted) {
        desk.typed = form.credentials();
        co_return desk.typed;
      }
      if (state == LoginForm::State::cancelled) co_return std::unexpected(Ending{ExitCode::ended_by_user, ""});
    }
    if (has_room(desk.terminal, language)) {
      desk.terminal.clear();
      desk.terminal.draw(form.screen());
      desk.terminal.flush();
    }
    co_await desk.changed.wait_until(Broadcast::Clock::time_point::max());
  }
}

// Others take their seats meanwhile. Asked for only while somebody types: a form that stands there all night would fill
// the server's log.
asio::awaitable<void> renew_seats(Desk& desk, LoginForm& form) {
  constexpr std::chrono::seconds kRenewal{2};
  asio::steady_timer timer(co_await asio::this_coro::executor);
  for (;;) {
    timer.expires_after(kRenewal);
    co_await timer.async_wait(asio::use_awaitable);
    if (!std::exchange(desk.is_form_touched, false)) continue;
    const Door door = desk.options.door();
    const auto client = co_await Client::connect(door.address, door.trust, door.kind);
    if (!client) continue;
    form.renew_seats(client->welcome());
    desk.changed.notify();
  }
}

asio::awaitable<Entered> fill_in(Desk& desk, LoginQuestion question) {
  const Language language = language_named(question.welcome.language());
  if (question.refusal && is_final(desk.options, *question.refusal)) {
    co_return std::unexpected(ending_of(*question.refusal, language));
  }
  LoginForm form(question, desk.options.seat() != 0, !desk.options.user.empty(), language);
  auto first = co_await (edit(desk, form, language) || renew_seats(desk, form));
  co_return std::get<0>(std::move(first));
}

asio::awaitable<std::expected<LoggedIn, Ending>> log_in_here(Desk& desk, std::optional<v1::LoginAnswer> why) {
  auto credentials = known_credentials(desk);
  if (!credentials) co_return std::unexpected(credentials.error());
  const bool must_ask = credentials->user.empty() || credentials->station == 0 || credentials->password.empty();
  desk.is_form_open = true;
  auto login = co_await log_in(
      desk.options.door(), std::move(*credentials), must_ask,
      [&desk](LoginQuestion question) { return fill_in(desk, std::move(question)); }, std::move(why));
  desk.is_form_open = false;
  if (login) {
    desk.has_new_password = desk.has_new_password || login->has_new_password;
    if (login->has_new_password && desk.typed.new_password) desk.typed.password = *desk.typed.new_password;
    desk.last_user = login->answer.user();
    desk.last_seat = login->answer.station();
  }
  desk.changed.notify();
  co_return login;
}

asio::awaitable<Ending> sit(Desk& desk, std::function<void()>& leave) {
  auto login = co_await log_in_here(desk, std::nullopt);
  if (!login) co_return login.error();
  const Session* begun = nullptr;
  Session session(desk.options.door(), std::move(*login), desk.changed, [&desk, &begun](v1::LoginAnswer why) {
    if (begun->has_new_password()) {  // the files hold what was before
      desk.options.password_file.reset();
      desk.options.new_password_file.reset();
      desk.typed.password.clear();
    }
    return log_in_here(desk, std::move(why));
  });
  begun = &session;
  leave = [&session] { session.log_out(); };
  Monitor monitor(desk.terminal, desk.events, desk.changed, session);
  auto first = co_await (session.run() || monitor.run(desk.is_form_open));
  leave = nullptr;
  if (const auto* const ending = std::get_if<0>(&first)) co_return *ending;
  co_return Ending{ExitCode::ended_by_user, ""};
}

}  // namespace

asio::awaitable<Ending> run_terminal(Options options, std::function<void()>& leave) {
  const auto executor = co_await asio::this_coro::executor;
  auto terminal = Terminal::open(options.is_ascii);
  if (!terminal) co_return terminal.error();
  Broadcast changed(executor);
  TerminalEvents events(executor, **terminal, changed);
  Desk desk{std::move(options), **terminal, events, changed};
  auto first = co_await (sit(desk, leave) || events.collect());
  if (const auto* const ending = std::get_if<0>(&first)) co_return *ending;
  co_return Ending{ExitCode::ended_by_user, ""};  // nobody at the terminal any more
}

}  // namespace cnclab::station
