// A lab server made of a script: one coroutine for each connection that arrives, over real TLS on loopback.
#pragma once

#include <cnclab/v1/envelope.pb.h>

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/screen.hpp"
#include "shared/tls.hpp"
#include "station/login.hpp"
#include "station/session.hpp"

namespace cnclab::station {

/// A station's pace in tests.
inline constexpr Pace kQuick{std::chrono::milliseconds(200), std::chrono::seconds(5), std::chrono::milliseconds(5),
                             std::chrono::milliseconds(20), std::chrono::milliseconds(500)};

namespace asio = boost::asio;

/// The server's end of one connection. Reads and writes throw boost::system::system_error when the station has gone.
class FakeLine {
 public:
  FakeLine(asio::ip::tcp::socket socket, asio::ssl::context& context) : stream_(std::move(socket), context) {}

  asio::awaitable<void> shake_hands();
  asio::awaitable<v1::ClientMessage> read();
  /// The next message of this kind; others are counted as noise (signs of life, acknowledgements).
  asio::awaitable<v1::ClientMessage> read(v1::ClientMessage::WhatCase kind);
  asio::awaitable<void> send(v1::ServerMessage message);
  asio::awaitable<void> send_bytes(std::string bytes);
  void cut();

  /// Hello and Welcome.
  asio::awaitable<v1::Hello> greet();
  /// Hello, Welcome, Login; then LOGIN_RESULT_OK with this ticket.
  asio::awaitable<v1::Login> admit(std::string ticket = "ticket-1");
  asio::awaitable<void> answer_login(v1::LoginAnswer answer);
  /// Sends what changed since the last screen of this connection.
  asio::awaitable<void> show(Screen screen, std::uint64_t handled_key = 0, std::uint64_t state = 1);
  asio::awaitable<void> show_text(std::string row_0, std::uint64_t handled_key = 0, std::uint64_t state = 1);
  asio::awaitable<void> say_bye(std::uint32_t exit_code, std::string text);
  /// Acknowledges every key and potentiometer event with a screen whose row 0 counts them, until the station logs out.
  asio::awaitable<void> serve_keys(std::vector<v1::ClientMessage>* seen = nullptr);

 private:
  asio::ssl::stream<asio::ip::tcp::socket> stream_;
  Screen shown_;
  std::uint64_t screens_ = 0;
};

class FakeServer {
 public:
  using Script = std::function<asio::awaitable<void>(FakeLine&)>;

  /// Connection i plays scripts[i]; later ones are closed at once.
  FakeServer(asio::io_context& context, std::vector<Script> scripts);

  [[nodiscard]] Address address() const;
  [[nodiscard]] std::string fingerprint() const { return fingerprint_of(certificate_.certificate_pem).value(); }
  [[nodiscard]] Door door(v1::ClientKind kind = v1::CLIENT_KIND_STATION) const {
    return {address(), {fingerprint()}, kind};
  }
  [[nodiscard]] std::size_t accepted() const { return accepted_; }
  /// What a script threw, other than the end of the connection.
  [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }

 private:
  asio::awaitable<void> accept_all();
  asio::awaitable<void> play(asio::ip::tcp::socket socket, std::size_t index);

  asio::io_context& context_;
  Certificate certificate_;
  asio::ssl::context tls_;
  asio::ip::tcp::acceptor acceptor_;
  std::vector<Script> scripts_;
  std::size_t accepted_ = 0;
  std::vector<std::string> failures_;
};

/// Runs the context until `test` has ended; false when that takes longer than 20 s. Rethrows what the test threw.
bool run_to_end(asio::io_context& context, asio::awaitable<void> test);

/// A folder of its own that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace cnclab::station
