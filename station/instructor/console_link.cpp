// The console's line to the server: status five times a second, commands as they come, a new line when it is lost.
#include "instructor/console_link.hpp"

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/system/system_error.hpp>
#include <exception>

namespace cnclab::instructor {
namespace {

using boost::asio::awaitable;
using namespace std::chrono_literals;

constexpr auto kStatusPeriod = 200ms;
constexpr auto kSilence = 5s;  // as the server's own patience (SEAT-004)
constexpr auto kFirstPause = 250ms;
constexpr std::chrono::milliseconds kLongestPause = 5s;

void must_not_throw(const std::exception_ptr& error) {
  if (error) std::rethrow_exception(error);
}

/// Trying again would not help: the certificate differs, the password was changed, another protocol, expelled.
bool is_final(const Failure& failure) {
  const auto code = static_cast<station::ExitCode>(failure.exit_code);
  switch (code) {
    case station::ExitCode::cannot_connect:
    case station::ExitCode::server_ended:
      return false;
    case station::ExitCode::ended_by_user:
    case station::ExitCode::usage:
    case station::ExitCode::login_refused:
    case station::ExitCode::certificate_differs:
    case station::ExitCode::replaced:
    case station::ExitCode::seat_taken:
    case station::ExitCode::protocol_version:
    case station::ExitCode::expelled:
      return true;
  }
  return true;
}

}  // namespace

ConsoleLink::ConsoleLink(boost::asio::io_context& context, Access access, Credentials credentials, LinkEvents events)
    : context_(context),
      access_(std::move(access)),
      credentials_(std::move(credentials)),
      events_(std::move(events)),
      outgoing_signal_(context) {}

void ConsoleLink::start(station::Client client) {
  boost::asio::co_spawn(context_, keep_connected(std::move(client)), must_not_throw);
}

void ConsoleLink::enqueue(v1::ClientMessage message, bool is_urgent) {
  if (is_urgent) {
    outgoing_.push_front(std::move(message));
  } else {
    outgoing_.push_back(std::move(message));
  }
  outgoing_signal_.cancel();
}

void ConsoleLink::send(v1::InstructorRequest request, bool is_urgent) {
  if (!client_) return;
  request.set_number(++number_);
  asked_[number_] = request;
  v1::ClientMessage message;
  *message.mutable_request() = std::move(request);
  enqueue(std::move(message), is_urgent);
}

void ConsoleLink::stop() {
  has_ended_ = true;
  if (!client_) return;
  v1::ClientMessage message;
  message.mutable_logout();
  enqueue(std::move(message), false);
}

awaitable<void> ConsoleLink::keep_connected(station::Client client) {
  std::optional<station::Client> line(std::move(client));
  while (line && !has_ended_) {
    client_ = std::make_shared<station::Client>(std::move(*line));
    last_heard_ = Clock::now();
    outgoing_.clear();
    asked_.clear();
    status_number_ = 0;
    events_.line(true);
    boost::asio::co_spawn(context_, write_all(client_), must_not_throw);
    boost::asio::co_spawn(context_, watch(client_), must_not_throw);
    co_await talk(client_);
    client_->close();
    client_.reset();
    outgoing_signal_.cancel();
    if (has_ended_) break;
    events_.line(false);
    line = co_await reconnect();
  }
}

awaitable<std::optional<station::Client>> ConsoleLink::reconnect() {
  for (std::chrono::milliseconds wait = kFirstPause; !has_ended_; wait = std::min(wait * 2, kLongestPause)) {
    co_await pause(wait);
    auto entry = co_await enter(access_, credentials_);
    if (entry) co_return std::move(entry->client);
    if (is_final(entry.error())) {
      has_ended_ = true;
      events_.ended(entry.error());
    }
  }
  co_return std::nullopt;
}

awaitable<void> ConsoleLink::talk(std::shared_ptr<station::Client> client) {
  try {
    while (!has_ended_) {
      const v1::ServerMessage message = co_await client->read();
      last_heard_ = Clock::now();
      take(message);
    }
  } catch (const boost::system::system_error&) {
    co_return;  // the line is lost: keep_connected makes a new one
  }
}

void ConsoleLink::take(const v1::ServerMessage& message) {
  if (message.has_beat()) {
    v1::ClientMessage alive;
    alive.mutable_alive()->set_beat(message.beat().number());
    enqueue(std::move(alive), false);
  }
  if (message.has_bye()) {
    const Failure farewell{static_cast<int>(message.bye().exit_code()), message.bye().text()};
    if (farewell.exit_code == static_cast<int>(station::ExitCode::server_ended)) return;
    has_ended_ = true;
    events_.ended(farewell);
  }
  if (!message.has_answer()) return;
  const auto& answer = message.answer();
  if (answer.number() == status_number_) {
    status_number_ = 0;
    if (!answer.items().empty() && answer.items(0).has_status()) events_.status(answer.items(0).status());
    return;
  }
  const auto asked = asked_.find(answer.number());
  if (asked == asked_.end()) return;
  events_.answer(asked->second, answer);
  asked_.erase(asked);
}

awaitable<void> ConsoleLink::write_all(std::shared_ptr<station::Client> client) {
  try {
    while (client == client_) {
      if (outgoing_.empty()) {
        outgoing_signal_.expires_at(Clock::time_point::max());
        co_await outgoing_signal_.async_wait(boost::asio::as_tuple(boost::asio::use_awaitable));
        continue;
      }
      const v1::ClientMessage message = std::move(outgoing_.front());
      outgoing_.pop_front();
      co_await client->write(message);
      if (message.has_logout()) client->close();
    }
  } catch (const boost::system::system_error&) {
    client->close();  // ends `talk` too
  }
}

awaitable<void> ConsoleLink::watch(std::shared_ptr<station::Client> client) {
  while (client == client_ && !has_ended_) {
    if (Clock::now() - last_heard_ > kSilence) client->close();
    if (status_number_ == 0) {
      status_number_ = ++number_;
      v1::ClientMessage message;
      message.mutable_request()->set_number(status_number_);
      message.mutable_request()->mutable_status();
      enqueue(std::move(message), false);
    }
    co_await pause(kStatusPeriod);
  }
}

awaitable<void> ConsoleLink::pause(std::chrono::milliseconds time) {
  boost::asio::steady_timer timer(context_, time);
  co_await timer.async_wait(boost::asio::use_awaitable);
}

}  // namespace cnclab::instructor
