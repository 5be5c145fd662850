// A connection to the lab server: TLS, pinned certificate, frames; used by the station, the instructor and the tests.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <chrono>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "station/language.hpp"

namespace cnclab::v1 {
class ClientMessage;
class ServerMessage;
class Welcome;
}  // namespace cnclab::v1

namespace cnclab::station {

/// Exit codes of the station (interfaces.md section 3).
enum class ExitCode : int {
  ended_by_user = 0,
  usage = 2,
  cannot_connect = 3,
  login_refused = 4,
  certificate_differs = 5,
  replaced = 6,
  seat_taken = 7,
  protocol_version = 8,
  expelled = 9,
  server_ended = 10,
};

/// The code that a Bye names; unknown ones count as server_ended.
[[nodiscard]] ExitCode exit_code_of(std::uint32_t code);

struct ConnectError {
  ExitCode code{};
  std::string text;  ///< what happened, where, what to do
};

struct Address {
  std::string host, port;
};
/// "HOST:PORT", "[::1]:3300"; port 1..65535.
[[nodiscard]] std::optional<Address> parse_address(const std::string& text);

/// How the server's certificate is judged: a given fingerprint, or the known-hosts file (first use pins it).
struct Trust {
  std::optional<std::string> fingerprint;
  std::filesystem::path known_hosts = {};  ///< empty: $XDG_STATE_HOME/cnclab/known_hosts
};

/// One TLS connection. One reader and one writer coroutine at a time, all on one thread.
class Client {
 public:
  /// Time for resolving, connecting, the handshake and the Welcome together.
  static constexpr std::chrono::seconds kConnectDeadline{5};

  /// Connects, shakes hands, judges the certificate and exchanges Hello for Welcome.
  /// client_kind  a v1::ClientKind
  /// language     of the error where there is no connection
  /// errors       cannot_connect, certificate_differs, protocol_version, or what the server's Bye says
  [[nodiscard]] static boost::asio::awaitable<std::expected<Client, ConnectError>> connect(
      Address address, Trust trust, int client_kind, std::chrono::milliseconds deadline = kConnectDeadline,
      Language language = language_of_locale());
  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;
  ~Client();

  [[nodiscard]] boost::asio::any_io_executor executor() const;
  [[nodiscard]] const v1::Welcome& welcome() const;
  /// The certificate was seen for the first time and is remembered from now on.
  [[nodiscard]] bool is_first_use() const;
  /// Of the server's certificate, "SHA256:…".
  [[nodiscard]] const std::string& fingerprint() const;
  /// The next message; throws boost::system::system_error when the line is lost or the frame is malformed.
  [[nodiscard]] boost::asio::awaitable<v1::ServerMessage> read();
  /// Sends one message; throws boost::system::system_error when the line is lost. `message` must live until then.
  [[nodiscard]] boost::asio::awaitable<void> write(const v1::ClientMessage& message);
  /// Ends the connection at once; a waiting read or write throws. May be called again.
  void close();

 private:
  struct Impl;
  explicit Client(std::shared_ptr<Impl> impl);
  std::shared_ptr<Impl> impl_;  // shared with coroutines that are still reading or writing
};

}  // namespace cnclab::station
