// GET, answer, close.
#include "net/metrics.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>

#include "net/listen.hpp"

namespace cnclab::net {

namespace asio = boost::asio;
using asio::use_awaitable;
using asio::ip::tcp;

namespace {

constexpr std::size_t kLargestRequest = 4096;
constexpr std::chrono::seconds kPatience{2};

std::string answer_to(const std::string& request, const Metrics::Text& text) {
  const auto reply = [](const char* status, const std::string& body) {
    return std::string("HTTP/1.1 ") + status +
           "\r\nContent-Type: text/plain; version=0.0.4\r\nContent-Length: " + std::to_string(body.size()) +
           "\r\nConnection: close\r\n\r\n" + body;
  };
  if (!request.starts_with("GET ")) return reply("405 Method Not Allowed", "");
  const std::string path = request.substr(4, request.find(' ', 4) - 4);
  return path == "/metrics" ? reply("200 OK", text()) : reply("404 Not Found", "");
}

asio::awaitable<void> converse(tcp::socket& socket, const Metrics::Text& text) {
  std::string request;
  co_await asio::async_read_until(socket, asio::dynamic_buffer(request, kLargestRequest), "\r\n\r\n", use_awaitable);
  const std::string answer = answer_to(request, text);
  co_await asio::async_write(socket, asio::buffer(answer), use_awaitable);
  socket.shutdown(tcp::socket::shutdown_both);
}

}  // namespace

std::expected<std::unique_ptr<Metrics>, std::string> Metrics::listen(asio::io_context& loop,
                                                                     const std::string& address) {
  const auto endpoint = endpoint_of(address);
  if (endpoint && !endpoint->address().is_loopback())
    return std::unexpected("[server] metrics = '" + address + "': only a loopback address, e.g. 127.0.0.1:9300");
  auto acceptor = listen_on(loop, address, "[server] metrics in lab.toml");
  if (!acceptor) return std::unexpected("[server] metrics: " + acceptor.error());
  return std::make_unique<Metrics>(std::move(*acceptor));
}

Metrics::Metrics(tcp::acceptor acceptor) : acceptor_(std::move(acceptor)) {}

void Metrics::serve(Text text) {
  asio::co_spawn(acceptor_.get_executor(), accept(std::move(text)), [](const std::exception_ptr& failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const std::exception& error) {  // the lab goes on without
      spdlog::error("metrics ended: {}", error.what());
    }
  });
}

std::string Metrics::address() const {
  const auto endpoint = acceptor_.local_endpoint();
  return endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
}

asio::awaitable<void> Metrics::accept(Text text) {
  while (acceptor_.is_open()) {
    tcp::socket socket = co_await acceptor_.async_accept(use_awaitable);
    asio::steady_timer patience(acceptor_.get_executor(), kPatience);
    patience.async_wait([&socket](const boost::system::error_code& cancelled) {
      if (!cancelled) socket.cancel();
    });
    try {
      co_await converse(socket, text);
    } catch (const boost::system::system_error& error) {
      spdlog::debug("metrics: {}", error.code().message());
    }
  }
}

}  // namespace cnclab::net
