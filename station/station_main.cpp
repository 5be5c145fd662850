// cnclab-station: a seat in the lab, on a terminal or headless.
#include <unistd.h>

#include <boost/asio/bind_cancellation_slot.hpp>
#include <boost/asio/cancellation_signal.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/system/system_error.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <utility>

#include "station/cell_text.hpp"
#include "station/headless_station.hpp"
#include "station/terminal_station.hpp"

namespace cnclab::station {
namespace {

namespace asio = boost::asio;

// The first signal logs out, as the user would; a second one, or one before the login, ends at once.
class SignalEnd {
 public:
  explicit SignalEnd(asio::io_context& context) : signals_(context, SIGINT, SIGTERM, SIGHUP) { wait(); }
  std::function<void()> leave;
  asio::cancellation_signal abort;

 private:
  void wait() {
    signals_.async_wait([this](const boost::system::error_code& error, int) {
      if (error) return;
      if (const auto log_out = std::exchange(leave, nullptr)) {
        log_out();
      } else {
        abort.emit(asio::cancellation_type::terminal);
      }
      wait();
    });
  }
  asio::signal_set signals_;
};

Ending run(const Options& options) {
  asio::io_context context(1);
  SignalEnd signals(context);
  Ending ending{ExitCode::ended_by_user, ""};
  std::exception_ptr failure;
  auto station = options.is_headless ? run_headless(options, STDIN_FILENO, STDOUT_FILENO, signals.leave)
                                     : run_terminal(options, signals.leave);
  const auto finish = [&](const std::exception_ptr& error, Ending result) {
    failure = error;
    ending = std::move(result);
    context.stop();
  };
  asio::co_spawn(context, std::move(station), asio::bind_cancellation_slot(signals.abort.slot(), finish));
  context.run();
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const boost::system::system_error& error) {
    if (error.code() != asio::error::operation_aborted) throw;
  }
  return ending;
}

int station_main(int count, char** arguments) {
  const auto options = parse_options(count, arguments);
  const auto ending = options ? run(*options) : options.error();
  // Headless, stdout carries replies and nothing else.
  const bool is_plain_end = ending.code == ExitCode::ended_by_user && !(options && options->is_headless);
  std::FILE* const to = is_plain_end ? stdout : stderr;
  if (!ending.text.empty()) std::fprintf(to, "%s\n", ending.text.c_str());
  return static_cast<int>(ending.code);
}

}  // namespace
}  // namespace cnclab::station

int main(int count, char** arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return cnclab::station::station_main(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cnclab-station: %s\n", error.what());
    return static_cast<int>(cnclab::station::ExitCode::server_ended);
  }
}
