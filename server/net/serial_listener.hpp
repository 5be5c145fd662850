// The serial line over TCP ([dnc] listen, interfaces.md section 8): plain on loopback, TLS everywhere else (SEC-001).
//
//   connect ──▶ "STATION N TOKEN" LF within 10 s ──▶ bound ──▶ the line's bytes in both directions
//                     └── anything else: closed without a word, the reason is logged (SEC-006)
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <expected>
#include <memory>
#include <string>

#include "lab/media/serial_lines.hpp"
#include "shared/tls.hpp"

namespace cnclab::net {

class SerialListener {
 public:
  /// Binds to "ADDR:PORT" (port 0: any). errors: what is wrong with the address, or who may have it.
  [[nodiscard]] static std::expected<std::unique_ptr<SerialListener>, std::string> listen(
      boost::asio::io_context& loop, const std::string& address, const Certificate& certificate);
  SerialListener(boost::asio::ip::tcp::acceptor acceptor, const Certificate& certificate);

  /// Accepts for `lab` from now on; both outlive the loop's work.
  void serve(lab::SerialLines& lines);
  /// No new connections.
  void stop();
  /// "127.0.0.1:3301" with the real port.
  [[nodiscard]] std::string address() const;
  [[nodiscard]] bool is_plain() const { return is_plain_; }

 private:
  boost::asio::awaitable<void> accept(lab::SerialLines& lines);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::ssl::context tls_;
  bool is_plain_;
  std::shared_ptr<int> unbound_ = std::make_shared<int>(0);  ///< connections whose first line is to come (SEC-005)
};

}  // namespace cnclab::net
