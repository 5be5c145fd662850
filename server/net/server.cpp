// Accepting connections and polling the lab.
#include "net/server.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <charconv>
#include <chrono>

#include "net/connection.hpp"

namespace cnclab::net {

namespace asio = boost::asio;
using asio::use_awaitable;
using asio::ip::tcp;

namespace {

constexpr std::chrono::milliseconds kPollPeriod{10};

/// "127.0.0.1:3300" or "[::1]:3300"; nothing when it is neither.
std::optional<tcp::endpoint> endpoint_of(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  std::string host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  unsigned port = 0;
  const char* const end = address.data() + address.size();
  const auto [read, error] = std::from_chars(address.data() + colon + 1, end, port);
  boost::system::error_code malformed;
  const auto ip = asio::ip::make_address(host, malformed);
  if (malformed || error != std::errc{} || read != end || port > 65'535) return std::nullopt;
  return tcp::endpoint(ip, static_cast<unsigned short>(port));
}

void report(const std::exception_ptr& failure) {
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    spdlog::critical("the server's loop failed: {}", error.what());
    throw;
  }
}

}  // namespace

std::expected<std::unique_ptr<Server>, std::string> Server::listen(asio::io_context& loop, const std::string& address,
                                                                   const Certificate& certificate) {
  const auto endpoint = endpoint_of(address);
  if (!endpoint)
    return std::unexpected("cannot listen on '" + address + "': give an address and a port, e.g. 127.0.0.1:3300");
  tcp::acceptor acceptor(loop);
  boost::system::error_code error;
  acceptor.open(endpoint->protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(*endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error == asio::error::address_in_use)
    return std::unexpected("cannot listen on " + address +
                           ": the port is in use. Is another server running? Choose another with --listen ADDR:PORT");
  if (error) return std::unexpected("cannot listen on " + address + ": " + error.message());
  return std::make_unique<Server>(loop, std::move(acceptor), certificate);
}

Server::Server(asio::io_context& loop, tcp::acceptor acceptor, const Certificate& certificate)
    : loop_(loop), acceptor_(std::move(acceptor)), tls_(server_context(certificate)), poll_(loop) {}

void Server::serve(lab::Lab& lab) {
  asio::co_spawn(loop_, accept(lab), report);
  asio::co_spawn(loop_, beat(lab), report);
}

void Server::stop() {
  is_open_ = false;
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  poll_.cancel();
}

std::string Server::address() const {
  const auto endpoint = acceptor_.local_endpoint();
  const std::string host = endpoint.address().to_string();
  return (endpoint.address().is_v6() ? "[" + host + "]" : host) + ":" + std::to_string(endpoint.port());
}

asio::awaitable<void> Server::accept(lab::Lab& lab) {
  while (is_open_) {
    boost::system::error_code error;
    tcp::socket socket = co_await acceptor_.async_accept(asio::redirect_error(use_awaitable, error));
    if (!error) {
      std::make_shared<Connection>(std::move(socket), tls_, lab)->start();
    } else if (is_open_) {  // out of descriptors, for instance: those who sit go on, newcomers wait
      spdlog::warn("a connection could not be accepted: {}", error.message());
      asio::steady_timer pause(loop_, std::chrono::milliseconds(100));
      co_await pause.async_wait(use_awaitable);
    }
  }
}

asio::awaitable<void> Server::beat(lab::Lab& lab) {
  poll_.expires_at(std::chrono::steady_clock::now());
  while (is_open_) {
    // From one due time to the next; after a long halt of the process the lost ones are not made up for.
    const auto due = poll_.expiry() + kPollPeriod;
    poll_.expires_at(std::max(due, std::chrono::steady_clock::now()));
    boost::system::error_code cancelled;
    co_await poll_.async_wait(asio::redirect_error(use_awaitable, cancelled));
    if (cancelled || !is_open_) co_return;
    lab.poll();
  }
}

}  // namespace cnclab::net
