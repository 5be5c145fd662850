// The live console in a terminal: fifteen seats, the machine, and the keys that command them.
#include "instructor/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <chrono>
#include <csignal>
#include <exception>
#include <optional>

#include "instructor/console_link.hpp"
#include "instructor/console_model.hpp"
#include "instructor/console_view.hpp"
#include "instructor/one_shot.hpp"
#include "instructor/window.hpp"
#include "station/terminal_fault.hpp"

namespace cnclab::instructor {
namespace {

using Clock = std::chrono::steady_clock;

using Entered = std::expected<Entry, Failure>;

boost::asio::awaitable<void> enter_into(const Access& access, const Credentials& credentials,
                                        std::optional<Entered>& result) {
  result.emplace(co_await enter(access, credentials));
}

Entered enter_now(boost::asio::io_context& context, const Access& access, const Credentials& credentials) {
  std::optional<Entered> result;
  boost::asio::co_spawn(context, enter_into(access, credentials, result), [](const std::exception_ptr& error) {
    if (error) std::rethrow_exception(error);
  });
  context.run();
  context.restart();
  return std::move(*result);
}

/// Model, line and window together; the loop is the only place that waits.
class Console {
 public:
  Console(boost::asio::io_context& context, const Access& access, const Credentials& credentials)
      : context_(context), link_(context, access, credentials, events()), ends_(context, SIGINT, SIGTERM, SIGHUP) {
    ends_.add(SIGQUIT);
    ends_.async_wait([this](const boost::system::error_code& cancelled, int) { quits_ = quits_ || !cancelled; });
    model_.server = fmt::format("{}:{}", access.address.host, access.address.port);
    model_.user = credentials.user;
  }

  std::expected<void, Failure> run(Entry entry, bool is_ascii) {
    constexpr std::chrono::milliseconds kLook(20);
    model_.language = station::language_named(entry.language);
    link_.start(std::move(entry.client));
    Window window(is_ascii);
    while (!quits_ && !failure_) {
      count_lost_seconds();
      model_.is_too_small = !Window::has_room();
      if (model_.is_too_small)
        window.show_too_small(model_.language);
      else
        window.show(draw_console(model_, Window::columns()));
      context_.run_for(kLook);
      while (const auto input = window.next_input()) take(*input);
    }
    ends_.cancel();
    link_.stop();
    constexpr std::chrono::milliseconds kFarewell(300);
    context_.run_for(kFarewell);
    if (failure_) return std::unexpected(*failure_);
    return {};
  }

 private:
  LinkEvents events() {
    return {.status = [this](const v1::Status& status) { model_ = with_status(std::move(model_), status); },
            .answer =
                [this](const v1::InstructorRequest& request, const v1::InstructorAnswer& answer) {
                  model_ = with_answer(std::move(model_), request, answer);
                },
            .screen = [this](const Screen& screen) { model_ = with_screen(std::move(model_), screen); },
            .line =
                [this](bool is_connected) {
                  model_ = with_line(std::move(model_), is_connected ? Link::connected : Link::lost);
                  lost_since_ = Clock::now();
                },
            .ended = [this](const Failure& failure) { failure_ = failure; }};
  }

  void take(const Input& input) {
    Reaction reaction = react(std::move(model_), input);
    model_ = std::move(reaction.model);
    quits_ = quits_ || reaction.quits;
    if (!reaction.keys.empty()) link_.press(reaction.keys);
    if (!reaction.request) return;
    Command command;
    command.request = std::move(*reaction.request);
    command.content_file = reaction.content_file;
    command.is_collection = reaction.is_collection;
    command.sent_file = reaction.sent_file;
    link_.send(std::move(command), reaction.is_urgent);
  }

  void count_lost_seconds() {
    const auto lost_for = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - lost_since_);
    model_.lost_for_s = model_.link == Link::lost ? static_cast<int>(lost_for.count()) : 0;
  }

  boost::asio::io_context& context_;
  ConsoleModel model_;
  ConsoleLink link_;
  boost::asio::signal_set ends_;
  Clock::time_point lost_since_{};
  std::optional<Failure> failure_;
  bool quits_ = false;
};

}  // namespace

std::expected<void, Failure> run_console(Access access, bool is_ascii) {
  constexpr int kUsage = static_cast<int>(station::ExitCode::usage);
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    return std::unexpected(
        Failure{kUsage, own_words({"die Konsole braucht ein Terminal; ein Befehl (siehe --help) braucht keines",
                                   "the console needs a terminal; a command (see --help) needs none"})});
  }
  if (const auto fault = station::terminal_fault()) return std::unexpected(Failure{kUsage, own_words(*fault)});
  auto credentials = credentials_for(access);
  if (!credentials) return std::unexpected(credentials.error());
  boost::asio::io_context context;
  auto entry = enter_now(context, access, *credentials);
  if (!entry) return std::unexpected(entry.error());
  credentials->password = entry->password;
  credentials->new_password.reset();
  credentials->may_ask = false;
  Console console(context, access, *credentials);
  return console.run(std::move(*entry), is_ascii);
}

}  // namespace cnclab::instructor
