// A client that need not keep to the rules: TLS bytes and protocol messages, sent as the test wants them.
#include "harness/raw_client.hpp"

#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>

#include "harness/failure.hpp"
#include "shared/frame.hpp"
#include "shared/tls.hpp"

namespace cnclab::harness {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

}  // namespace

struct RawClient::Impl {
  asio::io_context context;
  asio::ssl::context tls = client_context();
  asio::ssl::stream<tcp::socket> stream{context, tls};

  /// Runs one operation; false when it failed or did not end in time, the line is closed then.
  bool run(asio::awaitable<void> operation, Milliseconds limit) {
    bool is_done = false;
    asio::co_spawn(context, std::move(operation), [&](const std::exception_ptr& error) { is_done = !error; });
    context.restart();
    context.run_for(limit);
    if (is_done) return true;
    boost::system::error_code ignored;
    stream.lowest_layer().close(ignored);
    context.restart();
    context.run();
    return false;
  }

  asio::awaitable<void> connect(std::uint16_t port) {
    co_await stream.lowest_layer().async_connect({asio::ip::address_v4::loopback(), port}, asio::use_awaitable);
    co_await stream.async_handshake(asio::ssl::stream_base::client, asio::use_awaitable);
  }

  asio::awaitable<void> write(std::string_view bytes) {
    co_await asio::async_write(stream, asio::buffer(bytes.data(), bytes.size()), asio::use_awaitable);
  }

  asio::awaitable<void> read(v1::ServerMessage& message) {
    std::array<std::uint8_t, kFrameHeader> header{};
    co_await asio::async_read(stream, asio::buffer(header), asio::use_awaitable);
    const auto length = body_length(header);
    if (!length) throw Failure("the server sent a frame of a forbidden length");
    std::string body(*length, '\0');
    co_await asio::async_read(stream, asio::buffer(body), asio::use_awaitable);
    if (!message.ParseFromString(body)) throw Failure("the server sent a message that cannot be read");
  }
};

RawClient::RawClient(std::uint16_t port) : impl_(std::make_unique<Impl>()) {
  if (!impl_->run(impl_->connect(port), kLimit)) {
    throw Failure("no TLS connection to 127.0.0.1:" + std::to_string(port));
  }
}

RawClient::~RawClient() = default;

bool RawClient::send_bytes(std::string_view bytes) { return impl_->run(impl_->write(bytes), kLimit); }

bool RawClient::send(const v1::ClientMessage& message) { return send_bytes(frame(message)); }

std::optional<v1::ServerMessage> RawClient::read(Milliseconds limit) {
  v1::ServerMessage message;
  if (!impl_->run(impl_->read(message), limit)) return std::nullopt;
  return message;
}

std::optional<v1::ServerMessage> RawClient::read_until(v1::ServerMessage::WhatCase kind, Milliseconds limit) {
  const Deadline deadline(limit);
  while (auto message = read(Milliseconds(deadline.remaining_ms()))) {
    if (message->what_case() == kind) return message;
    if (message->has_beat()) {
      v1::ClientMessage alive;
      alive.mutable_alive()->set_beat(message->beat().number());
      send(alive);
    }
  }
  return std::nullopt;
}

bool RawClient::is_closed_within(Milliseconds limit) {
  const Deadline deadline(limit);
  while (read(Milliseconds(deadline.remaining_ms()))) {
  }
  return !deadline.has_passed();
}

std::optional<v1::Welcome> RawClient::greet(v1::ClientKind kind, std::uint32_t version) {
  v1::ClientMessage message;
  message.mutable_hello()->set_version(version);
  message.mutable_hello()->set_kind(kind);
  message.mutable_hello()->set_software("system test");
  send(message);
  auto answer = read_until(v1::ServerMessage::kWelcome);
  return answer ? std::optional(answer->welcome()) : std::nullopt;
}

std::optional<v1::LoginAnswer> RawClient::log_in(const std::string& user, const std::string& password,
                                                 std::uint32_t station) {
  v1::ClientMessage message;
  message.mutable_login()->set_user(user);
  message.mutable_login()->set_password(password);
  message.mutable_login()->set_station(station);
  send(message);
  auto answer = read_until(v1::ServerMessage::kLogin);
  return answer ? std::optional(answer->login()) : std::nullopt;
}

}  // namespace cnclab::harness
