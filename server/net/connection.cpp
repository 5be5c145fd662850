// Reading and writing frames over TLS.
#include "net/connection.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/bind_executor.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>

#include "cnclab/v1/envelope.pb.h"
#include "shared/frame.hpp"

namespace cnclab::net {

namespace asio = boost::asio;
using asio::use_awaitable;
using std::chrono::seconds;

namespace {
constexpr seconds kHandshakeLimit{10};
constexpr seconds kFarewellLimit{2};
}  // namespace

Connection::Connection(asio::ip::tcp::socket socket, asio::ssl::context& tls, lab::Lab& lab)
    : stream_(std::move(socket), tls), lab_(lab), wake_(stream_.get_executor()), deadline_(stream_.get_executor()) {
  boost::system::error_code ignored;
  const auto remote = stream_.next_layer().remote_endpoint(ignored);
  address_ = remote.address().to_string() + ":" + std::to_string(remote.port());
  stream_.next_layer().set_option(asio::ip::tcp::no_delay(true), ignored);
  wake_.expires_at(asio::steady_timer::time_point::max());
}

void Connection::start() {
  asio::co_spawn(
      stream_.get_executor(), [self = shared_from_this()] { return self->converse(); },
      [self = shared_from_this()](const std::exception_ptr& failure) {
        try {
          if (failure) std::rethrow_exception(failure);
        } catch (const boost::system::system_error& error) {
          spdlog::info("{}: {}", self->address_, error.code().message());
        } catch (const std::exception& error) {
          spdlog::error("{}: {}", self->address_, error.what());
        }
        self->close();
        if (const auto visit = self->visit_.lock()) self->lab_.lost(visit);
      });
}

asio::awaitable<void> Connection::converse() {
  co_await shake_hands();
  visit_ = lab_.welcome(shared_from_this());
  asio::co_spawn(
      stream_.get_executor(), [self = shared_from_this()] { return self->write_messages(); },
      [self = shared_from_this()](const std::exception_ptr& failure) {
        if (failure) spdlog::debug("{}: writing ended", self->address_);
        self->close();  // the reader ends with it and tells the lab
      });
  co_await read_messages();
}

asio::awaitable<void> Connection::shake_hands() {
  deadline_.expires_after(kHandshakeLimit);
  deadline_.async_wait([weak = weak_from_this()](const boost::system::error_code& cancelled) {
    if (const auto self = weak.lock(); self && !cancelled) self->close();
  });
  co_await stream_.async_handshake(asio::ssl::stream_base::server, use_awaitable);
  deadline_.cancel();
}

asio::awaitable<void> Connection::read_messages() {
  std::array<std::uint8_t, kFrameHeader> header{};
  std::string body;
  v1::ClientMessage message;
  while (is_open_ && !is_ending_) {
    co_await asio::async_read(stream_, asio::buffer(header), use_awaitable);
    const auto length = body_length(header);
    if (!length) {
      spdlog::warn("{}: frame of a forbidden length", address_);
      co_return;
    }
    body.resize(*length);
    co_await asio::async_read(stream_, asio::buffer(body), use_awaitable);
    if (!message.ParseFromString(body)) {
      spdlog::warn("{}: frame that is no message", address_);
      co_return;
    }
    if (const auto visit = visit_.lock(); visit && !is_ending_) lab_.receive(visit, message);
  }
  // Hung up: stay until the writer has said goodbye or the time for it is over.
  boost::system::error_code ignored;
  while (is_open_) co_await stream_.async_read_some(asio::buffer(header), asio::redirect_error(use_awaitable, ignored));
}

asio::awaitable<void> Connection::write_messages() {
  while (is_open_) {
    if (waiting_.empty()) {
      if (is_ending_) break;
      boost::system::error_code woken;
      co_await wake_.async_wait(asio::redirect_error(use_awaitable, woken));
      wake_.expires_at(asio::steady_timer::time_point::max());
      continue;
    }
    std::string bytes;
    bytes.swap(waiting_.front());
    waiting_.pop_front();
    while (!waiting_.empty() && bytes.size() < 16'384) {  // small frames travel in one TLS record
      bytes += waiting_.front();
      waiting_.pop_front();
    }
    waiting_bytes_ -= bytes.size();
    co_await asio::async_write(stream_, asio::buffer(bytes), use_awaitable);
  }
  // A proper end of the TLS conversation, so that the other side can tell it from a cut line.
  boost::system::error_code ignored;
  if (is_open_) co_await stream_.async_shutdown(asio::redirect_error(use_awaitable, ignored));
}

void Connection::send(const v1::ServerMessage& message) {
  if (!is_open_ || is_ending_) return;
  std::string bytes = frame(message);
  if (waiting_bytes_ + bytes.size() > kMostWaiting_bytes) {
    spdlog::warn("{}: does not read what it is sent, connection ended", address_);
    return close();
  }
  waiting_bytes_ += bytes.size();
  waiting_.push_back(std::move(bytes));
  wake_.cancel();
}

void Connection::hang_up(const std::string& reason) {
  if (is_ending_) return;
  spdlog::debug("{}: hung up: {}", address_, reason);
  is_ending_ = true;
  wake_.cancel();
  deadline_.expires_after(kFarewellLimit);
  deadline_.async_wait([weak = weak_from_this()](const boost::system::error_code& cancelled) {
    if (const auto self = weak.lock(); self && !cancelled) self->close();
  });
}

void Connection::close() {
  if (!is_open_) return;
  is_open_ = false;
  boost::system::error_code ignored;
  stream_.next_layer().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
  stream_.next_layer().close(ignored);
  wake_.cancel();
  deadline_.cancel();
}

}  // namespace cnclab::net
