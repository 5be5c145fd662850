// The listener: accepts connections and beats the lab's time.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <expected>
#include <memory>
#include <string>

#include "lab/lab.hpp"
#include "shared/tls.hpp"

namespace cnclab::net {

class Server {
 public:
  /// Binds to "ADDR:PORT" (port 0: any). errors: what is wrong with the address, or who may have it.
  [[nodiscard]] static std::expected<std::unique_ptr<Server>, std::string> listen(boost::asio::io_context& loop,
                                                                                  const std::string& address,
                                                                                  const Certificate& certificate);
  Server(boost::asio::io_context& loop, boost::asio::ip::tcp::acceptor acceptor, const Certificate& certificate);

  /// Accepts for `lab` from now on, and polls it every 10 ms.
  void serve(lab::Lab& lab);
  /// No new connections, no more polling.
  void stop();
  /// "127.0.0.1:3300" with the real port.
  [[nodiscard]] std::string address() const;

 private:
  boost::asio::awaitable<void> accept(lab::Lab& lab);
  boost::asio::awaitable<void> beat(lab::Lab& lab);

  boost::asio::io_context& loop_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::ssl::context tls_;
  boost::asio::steady_timer poll_;
  bool is_open_ = true;
};

}  // namespace cnclab::net
