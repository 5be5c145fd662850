// One TLS connection: a reader coroutine, a writer coroutine, a bounded queue between (SEC-005, SEC-006).
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <memory>
#include <string>

#include "lab/lab.hpp"
#include "lab/peer.hpp"

namespace cnclab::net {

/// Lives as long as its coroutines run; the lab holds it as a Peer.
class Connection final : public lab::Peer, public std::enable_shared_from_this<Connection> {
 public:
  Connection(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context& tls, lab::Lab& lab);

  /// Starts both coroutines.
  void start();

  void send(const v1::ServerMessage& message) override;
  void hang_up(const std::string& reason) override;
  [[nodiscard]] std::string address() const override { return address_; }

 private:
  boost::asio::awaitable<void> converse();
  boost::asio::awaitable<void> shake_hands();
  boost::asio::awaitable<void> read_messages();
  boost::asio::awaitable<void> write_messages();
  void close();

  /// A console may wait for a long answer; a station never has more than some frames waiting.
  static constexpr std::size_t kMostWaiting_bytes = 4 * 1024 * 1024;

  boost::asio::ssl::stream<boost::asio::ip::tcp::socket> stream_;
  lab::Lab& lab_;
  std::string address_;
  std::weak_ptr<lab::Visit> visit_;  ///< the lab keeps it until it hangs up, and it keeps this connection
  std::deque<std::string> waiting_;
  std::size_t waiting_bytes_ = 0;
  boost::asio::steady_timer wake_;      ///< rings when there is something to write
  boost::asio::steady_timer deadline_;  ///< of the handshake, and of the farewell
  bool is_open_ = true;
  bool is_ending_ = false;  ///< write what waits, then close
};

}  // namespace cnclab::net
