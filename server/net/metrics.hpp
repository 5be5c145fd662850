// The lab's counters as Prometheus text over plain HTTP, on a loopback address only ([server] metrics).
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <expected>
#include <functional>
#include <memory>
#include <string>

namespace cnclab::net {

/// One connection at a time, one answer to each: whoever reads slowly keeps only other readers waiting, 2 s at most.
class Metrics {
 public:
  using Text = std::function<std::string()>;

  /// errors: no loopback address, or who may have it
  [[nodiscard]] static std::expected<std::unique_ptr<Metrics>, std::string> listen(boost::asio::io_context& loop,
                                                                                   const std::string& address);
  explicit Metrics(boost::asio::ip::tcp::acceptor acceptor);

  void serve(Text text);
  /// "127.0.0.1:9300" with the real port.
  [[nodiscard]] std::string address() const;

 private:
  boost::asio::awaitable<void> accept(Text text);

  boost::asio::ip::tcp::acceptor acceptor_;
};

}  // namespace cnclab::net
