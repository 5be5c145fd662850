// Read, opened, bound.
#include "net/listen.hpp"

#include <charconv>

namespace cnclab::net {

namespace asio = boost::asio;
using asio::ip::tcp;

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

std::expected<tcp::acceptor, std::string> listen_on(asio::io_context& loop, const std::string& address,
                                                    const std::string& setting) {
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
                           ": the port is in use. Is another server running? Choose another with " + setting);
  if (error == boost::system::errc::address_not_available)
    return std::unexpected("cannot listen on " + address +
                           ": this computer does not have that address. 127.0.0.1 serves this computer alone, 0.0.0.0 "
                           "every network; choose with " +
                           setting);
  if (error == asio::error::access_denied)
    return std::unexpected("cannot listen on " + address +
                           ": this user may not take that port. Choose one from 1024 on with " + setting);
  if (error) return std::unexpected("cannot listen on " + address + ": " + error.message());
  return acceptor;
}

}  // namespace cnclab::net
