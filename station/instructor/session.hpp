// Logging in, asking one thing after the other, and answering the server's beats meanwhile.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <expected>
#include <functional>
#include <optional>
#include <string>

#include "cnclab/v1/envelope.pb.h"
#include "instructor/bulk_file.hpp"
#include "instructor/command_line.hpp"
#include "instructor/failure.hpp"
#include "shared/screen.hpp"
#include "station/client.hpp"

namespace cnclab::instructor {

/// A roster or a tool list has to go in one message.
inline constexpr station::Text kTooLarge{"die Datei ist zu groß: höchstens 60000 Bytes, bitte in mehrere teilen",
                                         "the file is too large: at most 60000 bytes, please make several of it"};

/// Who logs in. What is to be asked for on the terminal is asked before a connection is made: no server waits for a
/// typist.
struct Credentials {
  std::string user;
  std::string password;
  std::optional<std::string> new_password;  ///< answers a forced change
  bool may_ask = false;                     ///< a new password that is missing or too weak is asked for
};

/// A connection on which the user has logged in.
struct Entry {
  station::Client client;
  std::string password;           ///< the one that is valid now
  std::string language;           ///< "de" or "en"
  bool changed_password = false;  ///< a forced change has been made
};

/// Connects and logs in as an instructor; makes a forced change of the password.
/// errors: the exit codes of interfaces.md section 3
[[nodiscard]] boost::asio::awaitable<std::expected<Entry, Failure>> enter(const Access& access,
                                                                          Credentials credentials);

using Sink = std::function<void(const v1::InstructorItem&)>;

/// Asks and takes the whole answer: items go to `sink` as they come, content into `file` if there is one.
/// errors: the server refused (exit code 1), ended the conversation, or the line was lost.
[[nodiscard]] boost::asio::awaitable<std::expected<void, Failure>> ask(station::Client& client,
                                                                       v1::InstructorRequest request, Sink sink,
                                                                       BulkFile* file);

/// Shows each new screen; false when nobody looks any more.
using ScreenSink = std::function<bool(const Screen&)>;

/// `watch`: the station's screen now and whenever it changes, until `sink` has seen enough.
/// errors: as `ask`
[[nodiscard]] boost::asio::awaitable<std::expected<void, Failure>> follow_screen(station::Client& client,
                                                                                 v1::InstructorRequest request,
                                                                                 ScreenSink sink);

/// Tells the server that this client leaves; errors do not matter any more.
[[nodiscard]] boost::asio::awaitable<void> log_out(station::Client& client);

}  // namespace cnclab::instructor
