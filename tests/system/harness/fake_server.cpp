// A server of another protocol version: TLS with a certificate of its own, and a Welcome that accepts nobody.
#include "harness/fake_server.hpp"

#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/system/system_error.hpp>
#include <thread>

#include "cnclab/v1/envelope.pb.h"
#include "harness/failure.hpp"
#include "shared/frame.hpp"
#include "shared/tls.hpp"

namespace cnclab::harness {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

Certificate new_certificate() {
  auto made = make_certificate();
  if (!made) throw Failure("no certificate: " + made.error());
  return std::move(*made);
}

v1::ServerMessage foreign_welcome() {
  v1::ServerMessage message;
  message.mutable_welcome()->set_accepted(false);
  constexpr std::uint32_t kForeignVersion = 999;
  message.mutable_welcome()->add_versions(kForeignVersion);
  message.mutable_welcome()->set_text("version 999 only");
  return message;
}

}  // namespace

struct FakeServer::Impl {
  explicit Impl(const Certificate& certificate)
      : tls(server_context(certificate)), fingerprint(fingerprint_of(certificate.certificate_pem).value()) {}

  asio::io_context context;
  asio::ssl::context tls;
  std::string fingerprint;
  std::uint16_t port = 0;
  std::thread thread;

  void start(std::uint16_t wanted_port) {
    tcp::acceptor acceptor(context, tcp::endpoint(asio::ip::address_v4::loopback(), wanted_port));
    port = acceptor.local_endpoint().port();
    asio::co_spawn(context, listen(std::move(acceptor)), [](const std::exception_ptr&) {});
    thread = std::thread([this] { context.run(); });
  }

  asio::awaitable<void> listen(tcp::acceptor acceptor) {
    for (;;) {
      tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
      try {
        co_await refuse(std::move(socket));
      } catch (const boost::system::system_error&) {
        continue;  // that client has gone; the next one comes
      }
    }
  }

  asio::awaitable<void> refuse(tcp::socket socket) {
    asio::ssl::stream<tcp::socket> stream(std::move(socket), tls);
    co_await stream.async_handshake(asio::ssl::stream_base::server, asio::use_awaitable);
    std::array<std::uint8_t, kFrameHeader> header{};
    co_await asio::async_read(stream, asio::buffer(header), asio::use_awaitable);
    std::string body(body_length(header).value_or(0), '\0');
    co_await asio::async_read(stream, asio::buffer(body), asio::use_awaitable);
    const std::string answer = frame(foreign_welcome());
    co_await asio::async_write(stream, asio::buffer(answer), asio::use_awaitable);
    co_await stream.async_shutdown(asio::use_awaitable);
  }
};

FakeServer::FakeServer(std::uint16_t port) : impl_(std::make_unique<Impl>(new_certificate())) { impl_->start(port); }

FakeServer::~FakeServer() {
  impl_->context.stop();
  impl_->thread.join();
}

std::uint16_t FakeServer::port() const { return impl_->port; }

std::string FakeServer::address() const { return "127.0.0.1:" + std::to_string(port()); }

const std::string& FakeServer::fingerprint() const { return impl_->fingerprint; }

}  // namespace cnclab::harness
