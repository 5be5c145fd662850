// An address from the configuration becomes a listening socket.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <expected>
#include <optional>
#include <string>

namespace cnclab::net {

/// "127.0.0.1:3300" or "[::1]:3300"; nothing when it is neither.
[[nodiscard]] std::optional<boost::asio::ip::tcp::endpoint> endpoint_of(const std::string& address);

/// Binds and listens; port 0 takes any. errors: what is wrong with the address, or who may have it.
///
/// setting     where the user chooses another address, e.g. "--listen ADDR:PORT"
[[nodiscard]] std::expected<boost::asio::ip::tcp::acceptor, std::string> listen_on(boost::asio::io_context& loop,
                                                                                   const std::string& address,
                                                                                   const std::string& setting);

}  // namespace cnclab::net
