// One command, its answer on stdout, and an exit code.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <cstdio>
#include <expected>
#include <optional>
#include <string>

#include "instructor/command_line.hpp"
#include "instructor/failure.hpp"
#include "instructor/session.hpp"

namespace cnclab::instructor {

/// User, password and, where given, new password from the access options; what is missing is asked for on the
/// terminal. errors: a file without a password, no terminal to ask on (usage, 2).
[[nodiscard]] std::expected<Credentials, Failure> credentials_for(Access& access);

/// Runs the command and prints its answer; `access.user` and the passwords are asked for where they are missing.
[[nodiscard]] boost::asio::awaitable<std::expected<void, Failure>> run_one_shot(Access access, Command command,
                                                                                std::FILE* out);

}  // namespace cnclab::instructor
