// Passwords come from files, so that a void ticket can be answered by a new login without a person.
#include "station/headless_station.hpp"

#include <unistd.h>

#include <boost/asio/this_coro.hpp>

#include "station/headless.hpp"

namespace cnclab::station {

namespace asio = boost::asio;

namespace {

Credentials without_password(const Options& options) {
  return {options.user, {}, options.seat(), options.elsewhere, std::nullopt};
}

std::expected<Credentials, Ending> first_credentials(const Options& options) {
  Credentials credentials = without_password(options);
  if (options.new_password_file) {
    auto fresh = read_password(*options.new_password_file);
    if (!fresh) return std::unexpected(fresh.error());
    credentials.new_password = std::move(*fresh);
  }
  auto password = options.password_file ? read_password(*options.password_file) : ask_password("Password");
  if (!password) return std::unexpected(password.error());
  credentials.password = std::move(*password);
  return credentials;
}

asio::awaitable<std::expected<LoggedIn, Ending>> log_in_unasked(Door door, Credentials credentials) {
  auto attempt = co_await attempt_login(std::move(door), std::move(credentials));
  if (attempt) co_return std::move(*attempt);
  if (const auto* const ending = std::get_if<Ending>(&attempt.error())) co_return std::unexpected(*ending);
  co_return std::unexpected(ending_of(std::get<v1::LoginAnswer>(attempt.error()), language_of_locale()));
}

// With the file that holds the password now, or the one that was typed. Who is found logged in elsewhere by now has
// been replaced there while the line was broken (SEAT-003).
asio::awaitable<std::expected<LoggedIn, Ending>> log_in_again(Options options, bool has_new_password,
                                                              std::string typed) {
  const auto& file = has_new_password ? options.new_password_file : options.password_file;
  Credentials credentials = without_password(options);
  credentials.password = std::move(typed);
  if (file) {
    auto password = read_password(*file);
    if (!password) co_return std::unexpected(password.error());
    credentials.password = std::move(*password);
  }
  auto attempt = co_await attempt_login(options.door(), std::move(credentials));
  if (attempt) co_return std::move(*attempt);
  if (const auto* const ending = std::get_if<Ending>(&attempt.error())) co_return std::unexpected(*ending);
  const auto& answer = std::get<v1::LoginAnswer>(attempt.error());
  Ending refused = ending_of(answer, language_of_locale());
  if (answer.result() == v1::LOGIN_RESULT_ELSEWHERE) refused.code = ExitCode::replaced;
  co_return std::unexpected(std::move(refused));
}

bool write_whole(int descriptor, const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + written, text.size() - written);
    if (count <= 0) return false;
    written += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

asio::awaitable<Ending> run_headless(Options options, int input, int output, std::function<void()>& leave, Pace pace) {
  const auto executor = co_await asio::this_coro::executor;
  auto credentials = first_credentials(options);
  if (!credentials) co_return credentials.error();
  const Credentials given = *credentials;
  auto login = co_await log_in_unasked(options.door(), std::move(*credentials));
  if (!login) co_return login.error();
  const bool was_forced = login->has_new_password;
  const Session* begun = nullptr;
  const auto relogin = [&](const v1::LoginAnswer& /*why*/) {
    return log_in_again(options, was_forced || begun->has_new_password(), given.password);
  };
  std::optional<Headless::PasswordChange> change;
  if (given.new_password && !was_forced) change = {given.password, *given.new_password};
  Broadcast changed(executor);
  Session session(options.door(), std::move(*login), changed, relogin, pace);
  begun = &session;
  LineReader lines(executor, input);
  Headless headless(
      session, changed, options.is_ascii, [output](const std::string& reply) { return write_whole(output, reply); },
      std::move(change));
  leave = [&session] { session.log_out(); };
  Ending ending = co_await headless.run(lines);
  leave = nullptr;
  co_return ending;
}

}  // namespace cnclab::station
