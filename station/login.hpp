// Logging in: one connection for each attempt, questions to the user between them, so that no server waits for a
// typist.
#pragma once

#include <cnclab/v1/session.pb.h>

#include <boost/asio/awaitable.hpp>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "station/client.hpp"
#include "station/language.hpp"
#include "station/media_folder.hpp"

namespace cnclab::station {

/// How a station's run ends, or why it cannot begin.
using Ending = ConnectError;

/// Where and as what to connect.
struct Door {
  Address address;
  Trust trust;
  v1::ClientKind kind = v1::CLIENT_KIND_STATION;
  std::optional<MediaPlace> media = {};      ///< for the files of EXTERNE DATEN; nothing: there are none here
  Language language = language_of_locale();  ///< of what is said where there is no connection
};

struct Credentials {
  std::string user, password;
  std::uint32_t station = 0;
  v1::Elsewhere elsewhere = v1::ELSEWHERE_UNSPECIFIED;
  std::optional<std::string> new_password;  ///< answers a forced change
};

struct LoggedIn {
  Client client;
  v1::LoginAnswer answer;
  bool has_new_password = false;  ///< the forced change was made
};

/// No connection at all, or the server's refusal.
using LoginFailure = std::variant<Ending, v1::LoginAnswer>;

/// Logs in; where the password has expired and `new_password` is given, changes it.
[[nodiscard]] boost::asio::awaitable<std::expected<LoggedIn, LoginFailure>> attempt_login(Door door,
                                                                                          Credentials credentials);
/// Comes back with the ticket of an earlier login (SEAT-004).
[[nodiscard]] boost::asio::awaitable<std::expected<LoggedIn, LoginFailure>> attempt_resume(Door door,
                                                                                           std::string ticket);

/// What the user is asked before the next attempt.
struct LoginQuestion {
  Credentials so_far;
  v1::Welcome welcome;                     ///< seats and language
  std::optional<v1::LoginAnswer> refusal;  ///< of the last attempt
};
/// Gives the credentials for the next attempt, or ends.
using Asker = std::function<boost::asio::awaitable<std::expected<Credentials, Ending>>(LoginQuestion)>;

/// Attempts and asks until logged in. With `ask_first` the user is asked before the first attempt,
/// too, and told of `refusal`.
[[nodiscard]] boost::asio::awaitable<std::expected<LoggedIn, Ending>> log_in(
    Door door, Credentials credentials, bool ask_first, Asker ask,
    std::optional<v1::LoginAnswer> refusal = std::nullopt);

/// The server's sentence, or one of our own where it sent none.
[[nodiscard]] std::string refusal_text(const v1::LoginAnswer& answer, Language language);
/// As it is told where no form can ask: with the options that help. Exit code 7 for a taken seat, 4 otherwise.
[[nodiscard]] Ending ending_of(const v1::LoginAnswer& answer, Language language);
/// What a Bye means for this program; unknown codes count as server_ended.
[[nodiscard]] Ending ending_of(std::uint32_t exit_code, const std::string& text, Language language);

}  // namespace cnclab::station
