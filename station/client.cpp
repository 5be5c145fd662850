// Connecting with a deadline, judging the certificate, and reading and writing frames.
#include "station/client.hpp"

#include <cnclab/v1/envelope.pb.h>
#include <fmt/format.h>

#include <array>
#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/system/system_error.hpp>
#include <charconv>

#include "shared/frame.hpp"
#include "shared/tls.hpp"
#include "station/cell_text.hpp"
#include "station/connect_trouble.hpp"
#include "station/known_hosts.hpp"

namespace cnclab::station {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::system_error;

struct Client::Impl {
  explicit Impl(const asio::any_io_executor& executor)
      : resolver(executor), context(client_context()), stream(executor, context) {}

  void close() {
    resolver.cancel();
    boost::system::error_code ignored;
    stream.lowest_layer().close(ignored);
  }

  tcp::resolver resolver;
  asio::ssl::context context;
  asio::ssl::stream<tcp::socket> stream;
  v1::Welcome welcome;
  std::string fingerprint;
  bool is_first_use = false;
};

namespace {

// Acts when its time is over, unless it is destroyed before.
class Watchdog {
 public:
  Watchdog(const asio::any_io_executor& executor, std::chrono::milliseconds limit, std::function<void()> act)
      : timer_(executor, limit) {
    timer_.async_wait([state = state_, act = std::move(act)](const boost::system::error_code&) {
      if (state->is_disarmed) return;
      state->has_bitten = true;
      act();
    });
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog() { state_->is_disarmed = true; }
  [[nodiscard]] bool has_bitten() const { return state_->has_bitten; }

 private:
  // Outlives the watchdog: its handler may already be queued when the watchdog goes.
  struct State {
    bool is_disarmed = false, has_bitten = false;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
  asio::steady_timer timer_;
};

ConnectError unreachable(const Address& address, const std::string& reason, Language language) {
  constexpr Text kText{"Kein Anschluss an {}:{}: {}. Läuft der Server, stimmt die Adresse?",
                       "Cannot connect to {}:{}: {}. Is the server running, is the address right?"};
  return {ExitCode::cannot_connect, fmt::format(fmt::runtime(kText.in(language)), address.host, address.port, reason)};
}

ConnectError wrong_version(const v1::Welcome& welcome) {
  std::string versions;
  for (const auto version : welcome.versions()) versions += (versions.empty() ? "" : ", ") + std::to_string(version);
  return {ExitCode::protocol_version,
          fmt::format(fmt::runtime(in_language_of_locale(
                          "Der Server spricht eine andere Protokollversion: er kann {}, dieses Programm {}. "
                          "Auf beiden Seiten dieselbe cnclab-Version installieren. {}",
                          "The server speaks another protocol version: it knows {}, this program {}. Install "
                          "the same cnclab version on both sides. {}")),
                      versions.empty() ? "?" : versions, kProtocolVersion, printable(welcome.text()))};
}

asio::awaitable<v1::ServerMessage> read_message(asio::ssl::stream<tcp::socket>& stream) {
  std::array<std::uint8_t, kFrameHeader> header{};
  co_await asio::async_read(stream, asio::buffer(header), asio::use_awaitable);
  const auto length = body_length(header);
  if (!length) throw system_error(make_error_code(boost::system::errc::message_size));
  std::string body(*length, '\0');
  co_await asio::async_read(stream, asio::buffer(body), asio::use_awaitable);
  v1::ServerMessage message;
  if (!message.ParseFromString(body)) {
    throw system_error(make_error_code(boost::system::errc::bad_message));
  }
  co_return message;
}

asio::awaitable<void> write_message(asio::ssl::stream<tcp::socket>& stream, const v1::ClientMessage& message) {
  const std::string bytes = frame(message);
  co_await asio::async_write(stream, asio::buffer(bytes), asio::use_awaitable);
}

asio::awaitable<std::expected<v1::Welcome, ConnectError>> exchange_hello(asio::ssl::stream<tcp::socket>& stream,
                                                                         int client_kind) {
  v1::ClientMessage message;
  v1::Hello& hello = *message.mutable_hello();
  hello.set_version(kProtocolVersion);
  hello.set_kind(static_cast<v1::ClientKind>(client_kind));
  hello.set_software("cnclab " CNCLAB_VERSION);
  hello.set_takes_parts(true);
  co_await write_message(stream, message);
  const v1::ServerMessage answer = co_await read_message(stream);
  if (answer.has_bye())
    co_return std::unexpected(ConnectError{exit_code_of(answer.bye().exit_code()), printable(answer.bye().text())});
  if (!answer.has_welcome()) throw system_error(make_error_code(boost::system::errc::protocol_error));
  if (!answer.welcome().accepted()) co_return std::unexpected(wrong_version(answer.welcome()));
  co_return answer.welcome();
}

}  // namespace

ExitCode exit_code_of(std::uint32_t code) {
  const bool is_known = code == 0 || (code >= 2 && code <= static_cast<std::uint32_t>(ExitCode::server_ended));
  return is_known ? static_cast<ExitCode>(code) : ExitCode::server_ended;
}

std::optional<Address> parse_address(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) return std::nullopt;
  Address address{text.substr(0, colon), text.substr(colon + 1)};
  const bool has_brackets = address.host.starts_with('[') && address.host.ends_with(']');
  if (has_brackets) address.host = address.host.substr(1, address.host.size() - 2);
  if (address.host.empty() || (!has_brackets && address.host.find(':') != std::string::npos)) return std::nullopt;
  int port = 0;
  const char* const end = address.port.data() + address.port.size();
  const auto parsed = std::from_chars(address.port.data(), end, port);
  if (parsed.ec != std::errc{} || parsed.ptr != end || port < 1 || port > 65535) return std::nullopt;
  return address;
}

asio::awaitable<std::expected<Client, ConnectError>> Client::connect(Address address, Trust trust, int client_kind,
                                                                     std::chrono::milliseconds deadline,
                                                                     Language language) {
  const auto executor = co_await asio::this_coro::executor;
  const auto impl = std::make_shared<Impl>(executor);
  const Watchdog watchdog(executor, deadline, [impl] { impl->close(); });
  std::string reason;
  try {
    const auto endpoints = co_await impl->resolver.async_resolve(address.host, address.port, asio::use_awaitable);
    co_await asio::async_connect(impl->stream.lowest_layer(), endpoints, asio::use_awaitable);
    impl->stream.lowest_layer().set_option(tcp::no_delay(true));
    co_await impl->stream.async_handshake(asio::ssl::stream_base::client, asio::use_awaitable);
    impl->fingerprint = peer_fingerprint(impl->stream.native_handle());
    const auto acquaintance = judge(trust, address, impl->fingerprint);
    if (!acquaintance) co_return std::unexpected(acquaintance.error());
    impl->is_first_use = *acquaintance == Acquaintance::pinned_now;
    auto welcome = co_await exchange_hello(impl->stream, client_kind);
    if (!welcome) co_return std::unexpected(std::move(welcome.error()));
    impl->welcome = std::move(*welcome);
    co_return Client(impl);
  } catch (const system_error& error) {
    reason = connect_trouble(error.code(), language);
  }
  if (watchdog.has_bitten()) {
    constexpr Text kSilent{"keine Antwort in {} s", "no answer within {} s"};
    reason = fmt::format(fmt::runtime(kSilent.in(language)), static_cast<double>(deadline.count()) / 1000);
  }
  co_return std::unexpected(unreachable(address, reason, language));
}

Client::Client(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
Client::Client(Client&&) noexcept = default;
Client& Client::operator=(Client&& other) noexcept {
  if (this != &other) {
    close();
    impl_ = std::move(other.impl_);
  }
  return *this;
}
Client::~Client() { close(); }

asio::any_io_executor Client::executor() const { return impl_->resolver.get_executor(); }
const v1::Welcome& Client::welcome() const { return impl_->welcome; }
bool Client::is_first_use() const { return impl_->is_first_use; }
const std::string& Client::fingerprint() const { return impl_->fingerprint; }

asio::awaitable<v1::ServerMessage> Client::read() {
  const auto impl = impl_;
  co_return co_await read_message(impl->stream);
}

asio::awaitable<void> Client::write(const v1::ClientMessage& message) {
  const auto impl = impl_;
  co_await write_message(impl->stream, message);
}

void Client::close() {
  if (impl_) impl_->close();
}

}  // namespace cnclab::station
