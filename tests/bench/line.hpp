// A blocking TLS line for benchmarks: one message out, one in, with a limit that does not end it.
#pragma once

#include <poll.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cstdint>
#include <optional>

#include "cnclab/v1/envelope.pb.h"
#include "shared/frame.hpp"
#include "shared/tls.hpp"

namespace cnclab::bench {

class Line {
 public:
  /// Throws boost::system::system_error when there is no server.
  explicit Line(std::uint16_t port) {
    stream_.next_layer().connect({boost::asio::ip::address_v4::loopback(), port});
    stream_.next_layer().set_option(boost::asio::ip::tcp::no_delay(true));
    stream_.handshake(boost::asio::ssl::stream_base::client);
  }

  void send(const v1::ClientMessage& message) { boost::asio::write(stream_, boost::asio::buffer(frame(message))); }

  /// The next message; nothing when none begins within the limit.
  [[nodiscard]] std::optional<v1::ServerMessage> read(std::chrono::milliseconds limit) {
    if (SSL_pending(stream_.native_handle()) == 0) {
      pollfd waiting{stream_.next_layer().native_handle(), POLLIN, 0};
      if (poll(&waiting, 1, static_cast<int>(limit.count())) <= 0) return std::nullopt;
    }
    std::array<std::uint8_t, kFrameHeader> header{};
    boost::asio::read(stream_, boost::asio::buffer(header));
    std::string body(body_length(header).value(), '\0');
    boost::asio::read(stream_, boost::asio::buffer(body));
    received_bytes_ += header.size() + body.size();
    v1::ServerMessage message;
    if (!message.ParseFromString(body)) return std::nullopt;
    return message;
  }

  /// Frames, without what TLS adds.
  [[nodiscard]] std::uint64_t received_bytes() const { return received_bytes_; }

 private:
  std::uint64_t received_bytes_ = 0;
  boost::asio::io_context context_;
  boost::asio::ssl::context tls_ = client_context();
  boost::asio::ssl::stream<boost::asio::ip::tcp::socket> stream_{context_, tls_};
};

}  // namespace cnclab::bench
