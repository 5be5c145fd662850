// The errors that a user meets, each with its words.
#include "station/connect_trouble.hpp"

#include <algorithm>
#include <array>
#include <boost/asio/error.hpp>
#include <boost/asio/ssl/error.hpp>

namespace cnclab::station {

std::string connect_trouble(const boost::system::error_code& error, Language language) {
  namespace basic = boost::asio::error;
  struct Row {
    boost::system::error_code error;
    Text text;
  };
  constexpr Text kCut{"die Verbindung wurde getrennt", "the connection was cut"};
  constexpr Text kNoName{"diesen Namen kennt das Netz nicht", "the network does not know that name"};
  constexpr Text kNoWay{"dorthin führt kein Weg im Netz", "the network has no route to it"};
  const std::array<Row, 9> rows{{{basic::connection_refused, {"dort antwortet kein Server", "no server answers there"}},
                                 {basic::timed_out, {"keine Antwort", "no answer"}},
                                 {basic::host_unreachable, kNoWay},
                                 {basic::network_unreachable, kNoWay},
                                 {basic::host_not_found, kNoName},
                                 {basic::host_not_found_try_again, kNoName},
                                 {basic::connection_reset, kCut},
                                 {basic::eof, kCut},
                                 {boost::asio::ssl::error::stream_truncated, kCut}}};
  const auto* const found = std::ranges::find(rows, error, &Row::error);
  return found == rows.end() ? error.message() : std::string(found->text.in(language));
}

}  // namespace cnclab::station
