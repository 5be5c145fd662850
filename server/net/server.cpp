// Accepting connections and polling the lab.
#include "net/server.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>

#include "net/connection.hpp"
#include "net/listen.hpp"

namespace cnclab::net {

namespace asio = boost::asio;
using asio::use_awaitable;
using asio::ip::tcp;

namespace {

constexpr std::chrono::milliseconds kPollPeriod{10};

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
  auto acceptor = listen_on(loop, address, "--listen ADDR:PORT");
  if (!acceptor) return std::unexpected(acceptor.error());
  return std::make_unique<Server>(loop, std::move(*acceptor), certificate);
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
