// A connection to the lab server: TLS, pinned certificate, frames; used by the station, the instructor and the tests.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace cnclab::v1 {
class ClientMessage;
class ServerMessage;
class Welcome;
}  // namespace cnclab::v1

namespace cnclab::station {

/// Exit codes of the station (interfaces.md section 3).
enum class ExitCode : int {
  ended_by_user = 0, usage = 2, cannot_connect = 3, login_refused = 4, certificate_differs = 5, replaced = 6,
  seat_taken = 7, protocol_version = 8, expelled = 9, server_ended = 10,
};

struct ConnectError {
  ExitCode code{};
  std::string text;  ///< what happened, where, what to do
};

struct Address {
  std::string host, port;
};
/// "HOST:PORT", "[::1]:3300".
[[nodiscard]] std::optional<Address> parse_address(const std::string& text);

/// How the server's certificate is judged: a given fingerprint, or the known-hosts file (first use pins it).
struct Trust {
  std::optional<std::string> fingerprint;
  std::filesystem::path known_hosts;  ///< default: $XDG_STATE_HOME/cnclab/known_hosts
};

/// One TLS connection. One reader and one writer coroutine at a time.
class Client {
 public:
  /// Connects, shakes hands, judges the certificate and exchanges Hello for Welcome.
  [[nodiscard]] static boost::asio::awaitable<std::expected<Client, ConnectError>> connect(
      const Address& address, const Trust& trust, int client_kind);
  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;
  ~Client();

  [[nodiscard]] const v1::Welcome& welcome() const;
  /// The next message; throws boost::system::system_error when the line is lost or the frame is malformed.
  [[nodiscard]] boost::asio::awaitable<v1::ServerMessage> read();
  [[nodiscard]] boost::asio::awaitable<void> write(const v1::ClientMessage& message);
  void close();

 private:
  struct Impl;
  explicit Client(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::station
