// The conversation after the login: reading, writing and signs of life beside each other.
#include "station/session.hpp"

#include <cnclab/v1/envelope.pb.h>

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/system/system_error.hpp>

#include "shared/screen_wire.hpp"

namespace cnclab::station {

namespace asio = boost::asio;
using boost::system::system_error;

namespace {

// A server that does not read this many messages is as good as lost.
constexpr std::size_t kLongestQueue = 512;
constexpr std::chrono::milliseconds kLook{100};

}  // namespace

Session::Session(Door door, LoggedIn login, Broadcast& changed, Relogin relogin, Pace pace)
    : door_(std::move(door)),
      client_(std::move(login.client)),
      changed_(changed),
      relogin_(std::move(relogin)),
      pace_(pace),
      to_write_(client_.executor()) {
  begin({std::move(client_), std::move(login.answer)});
}

Session::~Session() = default;

// Everything counts from the beginning again: numbers, beats and the screen that the server compares with. Only what
// has come of a file is kept.
void Session::begin(LoggedIn login) {
  client_ = std::move(login.client);
  ticket_ = login.answer.ticket();
  station_ = login.answer.station();
  language_ = language_named(login.answer.language().empty() ? client_.welcome().language() : login.answer.language());
  door_.language = language_;
  if (!door_.media || !may_press())
    media_.reset();
  else if (!media_ || media_->user() != login.answer.user())
    media_.emplace(*door_.media, login.answer.user());
  screen_ = Screen();
  last_number_ = handled_key_ = last_beat_ = state_ = 0;
  outgoing_.clear();
  is_connected_ = true;
  last_received_ = last_alive_ = Clock::now();
  changed_.notify();
}

asio::awaitable<Ending> Session::run() {
  for (;;) {
    if (auto ending = co_await converse()) co_return *ending;
    if (is_logging_out_) co_return Ending{ExitCode::ended_by_user, ""};
    lose();
    if (auto ending = co_await come_back()) co_return *ending;
  }
}

void Session::lose() {
  client_.close();
  if (media_) media_->pause();  // the server asks again
  is_connected_ = is_online_ = has_alarm_tone_ = is_password_wanted_ = false;
  lost_since_ = Clock::now();
  outgoing_.clear();
  ++connection_;
  trouble_.clear();
  changed_.notify();
}

asio::awaitable<std::optional<Ending>> Session::converse() {
  using asio::experimental::awaitable_operators::operator||;
  auto first = co_await (read_all() || write_all() || keep_alive());
  if (auto* const ending = std::get_if<0>(&first)) co_return std::move(*ending);
  co_return std::nullopt;
}

asio::awaitable<std::optional<Ending>> Session::read_all() {
  try {
    for (;;) {
      const v1::ServerMessage message = co_await client_.read();
      last_received_ = Clock::now();
      if (message.has_bye()) co_return ending_of(message.bye().exit_code(), message.bye().text(), language_);
      take(message);
    }
  } catch (const system_error&) {
    co_return std::nullopt;
  }
}

void Session::take(const v1::ServerMessage& message) {
  switch (message.what_case()) {
    case v1::ServerMessage::kScreen:
      return apply(message.screen());
    case v1::ServerMessage::kBeat:
      last_beat_ = message.beat().number();
      return queue_alive();
    case v1::ServerMessage::kAskPassword:
      is_password_wanted_ = true;
      return changed_.notify();
    case v1::ServerMessage::kLogin:
      return take_answer(message.login());
    case v1::ServerMessage::kLanguageChosen:
      door_.language = language_ = language_named(message.language_chosen().language());
      return changed_.notify();
    case v1::ServerMessage::kPutMedia:
    case v1::ServerMessage::kGetMedia:
    case v1::ServerMessage::kChunk:
    case v1::ServerMessage::kChunkAck:
      return take_media(message);
    case v1::ServerMessage::kWelcome:
    case v1::ServerMessage::kBye:
    case v1::ServerMessage::kAnswer:
    case v1::ServerMessage::WHAT_NOT_SET:
      return;  // nothing for a terminal
  }
}

void Session::apply(const v1::ScreenUpdate& update) {
  auto newer = apply_rows(screen_, update);
  if (!newer) throw system_error(make_error_code(boost::system::errc::bad_message), newer.error());
  screen_ = std::move(*newer);
  handled_key_ = std::max(handled_key_, update.handled_key());
  state_ = update.state();
  beeps_ += std::min<std::uint32_t>(update.beeps(), 10);
  has_alarm_tone_ = update.alarm_tone();
  is_online_ = true;
  v1::ClientMessage message;
  message.mutable_screen_ack()->set_number(update.number());
  queue(std::move(message));
  changed_.notify();
}

void Session::take_answer(const v1::LoginAnswer& answer) {
  has_new_password_ = has_new_password_ || answer.result() == v1::LOGIN_RESULT_OK;
  password_answer_ = answer;
  changed_.notify();
}

void Session::take_media(const v1::ServerMessage& message) {
  if (!media_) return;
  if (auto answer = media_->take(message)) queue(std::move(*answer));
}

asio::awaitable<void> Session::write_all() {
  for (bool is_open = true; is_open;) {
    try {
      while (!outgoing_.empty()) {
        const v1::ClientMessage message = std::move(outgoing_.front());
        outgoing_.pop_front();
        co_await client_.write(message);
      }
      co_await to_write_.wait_until(Clock::time_point::max());
    } catch (const system_error&) {
      is_open = false;
    }
  }
  // The reader finds out why: a Bye may still stand in the line.
  co_await to_write_.wait_until(Clock::now() + pace_.silence);
}

asio::awaitable<void> Session::keep_alive() {
  asio::steady_timer timer(co_await asio::this_coro::executor);
  for (;;) {
    const auto now = Clock::now();
    if (now - last_received_ > pace_.silence || (is_logging_out_ && now > log_out_limit_)) break;
    if (now - last_alive_ >= pace_.alive) queue_alive();
    timer.expires_after(std::min(kLook, pace_.alive));
    boost::system::error_code cancelled;
    co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
  }
  client_.close();
}

asio::awaitable<std::optional<Ending>> Session::come_back() {
  for (auto pause = pace_.first_pause;; pause = std::min(2 * pause, pace_.longest_pause)) {
    const auto limit = Clock::now() + pause;
    while (!is_logging_out_ && Clock::now() < limit) co_await to_write_.wait_until(limit);
    if (is_logging_out_) co_return Ending{ExitCode::ended_by_user, ""};
    if (auto ending = co_await come_back_once()) co_return *ending;
    if (is_connected_) co_return std::nullopt;
    changed_.notify();
  }
}

// Nothing while it is worth trying again, and after success.
asio::awaitable<std::optional<Ending>> Session::come_back_once() {
  if (ticket_.empty()) co_return co_await log_in_anew(v1::LoginAnswer());
  auto resumed = co_await attempt_resume(door_, ticket_);
  if (resumed) {
    begin(std::move(*resumed));
    co_return std::nullopt;
  }
  if (const auto* const ending = std::get_if<Ending>(&resumed.error())) {
    trouble_ = ending->text;
    const bool may_pass = ending->code == ExitCode::cannot_connect || ending->code == ExitCode::server_ended;
    co_return may_pass ? std::nullopt : std::optional(*ending);
  }
  const auto& answer = std::get<v1::LoginAnswer>(resumed.error());
  if (answer.result() == v1::LOGIN_RESULT_TICKET_VOID) co_return co_await log_in_anew(answer);
  if (answer.result() == v1::LOGIN_RESULT_WAIT) co_return std::nullopt;
  co_return ending_of(answer, language_);
}

asio::awaitable<std::optional<Ending>> Session::log_in_anew(v1::LoginAnswer why) {
  auto login = co_await relogin_(std::move(why));
  media_.reset();  // nothing of the former session goes on
  if (login) {
    begin(std::move(*login));
    co_return std::nullopt;
  }
  trouble_ = login.error().text;
  if (login.error().code == ExitCode::cannot_connect) co_return std::nullopt;
  co_return login.error();
}

std::uint32_t Session::take_beeps() { return std::exchange(beeps_, 0); }

bool Session::take_password_question() { return std::exchange(is_password_wanted_, false); }

std::optional<v1::LoginAnswer> Session::take_password_answer() { return std::exchange(password_answer_, std::nullopt); }

void Session::change_password(const std::string& old_password, const std::string& new_password) {
  v1::ClientMessage message;
  message.mutable_change_password()->set_old_password(old_password);
  message.mutable_change_password()->set_new_password(new_password);
  queue(std::move(message));
}

std::optional<std::uint64_t> Session::send_keys(std::span<const Key> keys, bool pressed, bool is_repeat) {
  if (!is_online_ || !may_press()) return std::nullopt;
  v1::ClientMessage message;
  v1::KeyEvent& event = *message.mutable_key();
  event.set_number(++last_number_);
  for (const Key key : keys) event.add_keys(static_cast<v1::Key>(key));
  event.set_pressed(pressed);
  event.set_is_repeat(is_repeat);
  fill_seen(*event.mutable_seen());
  queue(std::move(message));
  return last_number_;
}

std::optional<std::uint64_t> Session::send_potentiometer(std::uint32_t percent) {
  if (!is_online_ || !may_press()) return std::nullopt;
  v1::ClientMessage message;
  v1::Potentiometer& event = *message.mutable_potentiometer();
  event.set_number(++last_number_);
  event.set_percent(std::min<std::uint32_t>(percent, 100));
  fill_seen(*event.mutable_seen());
  queue(std::move(message));
  return last_number_;
}

void Session::log_out() {
  if (is_logging_out_) return;
  is_logging_out_ = true;
  log_out_limit_ = Clock::now() + pace_.farewell;
  v1::ClientMessage message;
  message.mutable_logout();
  queue(std::move(message));
}

void Session::fill_seen(v1::Seen& seen) const {
  seen.set_beat(last_beat_);
  seen.set_state(state_);
}

void Session::queue_alive() {
  v1::ClientMessage message;
  message.mutable_alive()->set_beat(last_beat_);
  last_alive_ = Clock::now();
  queue(std::move(message));
}

void Session::queue(v1::ClientMessage message) {
  if (outgoing_.size() >= kLongestQueue) {
    client_.close();
    return;
  }
  outgoing_.push_back(std::move(message));
  to_write_.notify();
}

}  // namespace cnclab::station
