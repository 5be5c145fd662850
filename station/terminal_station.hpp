// The whole run of `cnclab-station` on a terminal: login form, monitor, keyboard, farewell.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <functional>

#include "station/options.hpp"

namespace cnclab::station {

/// While logged in, `leave` is what a signal calls to log out.
[[nodiscard]] boost::asio::awaitable<Ending> run_terminal(Options options, std::function<void()>& leave);

}  // namespace cnclab::station
