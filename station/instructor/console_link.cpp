// The console's line to the server: status five times a second, commands as they come, a new line when it is lost.
#include "instructor/console_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/system/system_error.hpp>
#include <exception>

#include "instructor/collection.hpp"
#include "instructor/tape_parts.hpp"
#include "shared/frame.hpp"
#include "shared/screen_wire.hpp"

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

void ConsoleLink::send(Command command, bool is_urgent) {
  if (!client_) return;
  v1::ClientMessage message;
  if (auto part = take_part(command.request)) {
    part->set_number(++number_);
    *message.mutable_request() = std::move(*part);
    begun_[number_] = std::move(command);
    return enqueue(std::move(message), false);
  }
  command.request.set_number(++number_);
  *message.mutable_request() = command.request;
  if (message.ByteSizeLong() > kLargestFrame)
    return conclude(command, std::unexpected(Failure{kRefused, own_words(kTooLarge)}));
  if (command.request.has_take()) {  // a keyboard without its screen would be typed on blindly
    v1::ClientMessage watch;
    watch.mutable_request()->set_number(++number_);
    watch.mutable_request()->mutable_watch()->set_station(command.request.take().station());
    enqueue(std::move(watch), false);
  }
  const bool gives_back = command.request.has_give();
  asked_[message.request().number()] = std::move(command);
  enqueue(std::move(message), is_urgent);
  if (!gives_back) return;
  v1::ClientMessage unwatch;
  unwatch.mutable_request()->set_number(++number_);
  unwatch.mutable_request()->mutable_watch();
  enqueue(std::move(unwatch), false);
}

void ConsoleLink::press(const std::vector<Key>& keys) {
  if (!client_) return;
  for (const bool pressed : {true, false}) {
    v1::ClientMessage message;
    auto& event = *message.mutable_key();
    event.set_number(++keys_);
    for (const Key key : keys) event.add_keys(static_cast<v1::Key>(key));
    event.set_pressed(pressed);
    event.mutable_seen()->set_beat(beat_);
    event.mutable_seen()->set_state(state_);
    enqueue(std::move(message), false);
  }
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
    begun_.clear();
    parts_.clear();
    content_.reset();
    screen_ = Screen();
    beat_ = state_ = keys_ = 0;
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
    beat_ = message.beat().number();
    alive.mutable_alive()->set_beat(beat_);
    enqueue(std::move(alive), false);
  }
  if (message.has_bye()) {
    const Failure farewell{static_cast<int>(message.bye().exit_code()), message.bye().text()};
    if (farewell.exit_code == static_cast<int>(station::ExitCode::server_ended)) return;
    has_ended_ = true;
    events_.ended(farewell);
  }
  if (message.has_answer()) take_answer(message.answer());
  if (message.has_chunk()) take_chunk(message.chunk());
  if (message.has_screen()) take_screen(message.screen());
}

void ConsoleLink::take_answer(const v1::InstructorAnswer& answer) {
  if (answer.number() == status_number_) {
    status_number_ = 0;
    if (!answer.items().empty() && answer.items(0).has_status()) events_.status(answer.items(0).status());
    return;
  }
  if (auto begun = begun_.extract(answer.number()); !begun.empty()) {
    if (answer.error().empty()) return send(std::move(begun.mapped()), false);
    return conclude(begun.mapped(), std::unexpected(Failure{kRefused, answer.error()}));
  }
  const auto asked = asked_.find(answer.number());
  if (asked == asked_.end()) return;
  auto& whole = parts_[answer.number()];
  whole.MergeFrom(answer);
  if (answer.more() && !asked->second.request.has_watch()) return;
  if (!whole.error().empty()) whole.set_error(with_sent_file(asked->second, whole.error()));
  if (answer.transfer() != 0 && !asked->second.content_file.empty())
    content_.emplace(std::piecewise_construct, std::forward_as_tuple(asked->second),
                     std::forward_as_tuple(asked->second.content_file));
  else
    events_.answer(asked->second.request, whole);
  parts_.erase(answer.number());
  asked_.erase(asked);
}

void ConsoleLink::take_chunk(const v1::Chunk& chunk) {
  if (!content_) return;
  auto& [command, file] = *content_;
  const auto acknowledgement = file.take(chunk);
  v1::ClientMessage message;
  auto& ack = *message.mutable_chunk_ack();
  ack.set_transfer(chunk.transfer());
  if (acknowledgement)
    ack = *acknowledgement;
  else
    ack.set_abort(true);
  enqueue(std::move(message), false);
  if (!acknowledgement) {
    conclude(command, std::unexpected(acknowledgement.error()));
  } else if (file.is_complete() && command.is_collection) {
    const auto files = split_collection(command.content_file, command.content_file.parent_path());
    if (files)
      conclude(command, fmt::format("{}: {}", command.content_file.parent_path().string(), files->size()));
    else
      conclude(command, std::unexpected(files.error()));
  } else if (file.is_complete()) {
    conclude(command, command.content_file.string());
  } else {
    return;
  }
  content_.reset();
}

void ConsoleLink::take_screen(const v1::ScreenUpdate& update) {
  auto newer = apply_rows(screen_, update);
  if (!newer) return client_->close();
  screen_ = std::move(*newer);
  state_ = update.state();
  v1::ClientMessage acknowledgement;
  acknowledgement.mutable_screen_ack()->set_number(update.number());
  enqueue(std::move(acknowledgement), false);
  events_.screen(screen_);
}

/// Tells how a command ended that this side has carried out itself.
void ConsoleLink::conclude(const Command& command, const std::expected<std::string, Failure>& result) {
  v1::InstructorAnswer answer;
  if (result)
    answer.add_items()->mutable_done()->set_detail(*result);
  else
    answer.set_error(result.error().text);
  events_.answer(command.request, answer);
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
