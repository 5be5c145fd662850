// The floor of key-to-screen: a bare Asio server that answers each frame over TLS with a screen-sized one.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <memory>
#include <thread>

#include "shared/frame.hpp"
#include "shared/tls.hpp"

namespace cnclab::bench {

class EchoServer {
 public:
  /// answer   a whole frame
  explicit EchoServer(std::string answer)
      : answer_(std::move(answer)),
        tls_(server_context(make_certificate().value())),
        acceptor_(loop_, {boost::asio::ip::address_v4::loopback(), 0}) {
    boost::asio::co_spawn(loop_, accept(), [](const std::exception_ptr&) {});
    thread_ = std::jthread([this] { loop_.run(); });
  }
  ~EchoServer() { loop_.stop(); }
  EchoServer(const EchoServer&) = delete;
  EchoServer& operator=(const EchoServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

 private:
  using Stream = boost::asio::ssl::stream<boost::asio::ip::tcp::socket>;

  boost::asio::awaitable<void> accept() {
    for (;;) {
      auto socket = co_await acceptor_.async_accept(boost::asio::use_awaitable);
      socket.set_option(boost::asio::ip::tcp::no_delay(true));
      auto stream = std::make_shared<Stream>(std::move(socket), tls_);
      boost::asio::co_spawn(loop_, answer(stream), [](const std::exception_ptr&) {});
    }
  }

  boost::asio::awaitable<void> answer(std::shared_ptr<Stream> stream) {
    using boost::asio::use_awaitable;
    co_await stream->async_handshake(boost::asio::ssl::stream_base::server, use_awaitable);
    std::array<std::uint8_t, kFrameHeader> header{};
    std::string body;
    for (;;) {
      co_await boost::asio::async_read(*stream, boost::asio::buffer(header), use_awaitable);
      body.resize(body_length(header).value());
      co_await boost::asio::async_read(*stream, boost::asio::buffer(body), use_awaitable);
      co_await boost::asio::async_write(*stream, boost::asio::buffer(answer_), use_awaitable);
    }
  }

  std::string answer_;
  boost::asio::io_context loop_{1};
  boost::asio::ssl::context tls_;
  boost::asio::ip::tcp::acceptor acceptor_;
  std::jthread thread_;
};

}  // namespace cnclab::bench
