// The whole run of `cnclab-station --headless`: login from files, commands, farewell.
#pragma once

#include <boost/asio/awaitable.hpp>

#include "station/options.hpp"
#include "station/session.hpp"

namespace cnclab::station {

/// Reads commands from `input`, writes replies to `output` (file descriptors). While logged in, `leave` is what a
/// signal calls to log out.
[[nodiscard]] boost::asio::awaitable<Ending> run_headless(Options options, int input, int output,
                                                          std::function<void()>& leave, Pace pace = {});

}  // namespace cnclab::station
