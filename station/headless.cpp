// Obeying one command after the other; every command gets exactly one reply, also when the session ends beneath it.
#include "station/headless.hpp"

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>

#include "station/cell_text.hpp"

namespace cnclab::station {

namespace asio = boost::asio;
using Clock = Broadcast::Clock;

namespace {

constexpr const char* kOffline = "error VERBINDUNG VERLOREN\n";
constexpr Text kOnlyLook{"error nur zusehen: diese Anmeldung darf keine Tasten drücken\n",
                         "error look only: this login may not press keys\n"};

}  // namespace

std::string screen_reply(const Screen& stands, bool is_ascii) {
  const Screen screen = is_ascii ? spelled_out(stands) : stands;
  std::string reply;
  for (int row = 0; row < Screen::kRows; ++row) {
    reply += '|';
    for (const Cell& cell : screen.row(row))
      reply += to_utf8(shown_code(cell.code, is_ascii ? Glyphs::ascii : Glyphs::all));
    reply += "|\n";
  }
  return reply + "end\n";
}

std::string marks_reply(const Screen& stands, bool is_ascii) {
  const Screen screen = is_ascii ? spelled_out(stands) : stands;
  std::string reply;
  for (int row = 0; row < Screen::kRows; ++row) {
    for (int column = 0; column < Screen::kColumns;) {
      int length = 0;
      while (screen.at(row, column + length).attribute == Attribute::inverse) ++length;
      if (length > 0) {
        reply += std::to_string(row) + ' ' + std::to_string(column) + ' ' + std::to_string(length) + '\n';
      }
      column += length + 1;
    }
  }
  return reply + "end\n";
}

bool contains(const Screen& screen, const std::string& text) {
  for (int row = 0; row < Screen::kRows; ++row) {
    if (screen.text(row).find(text) != std::string::npos) return true;
  }
  return false;
}

asio::awaitable<Ending> Headless::run(LineReader& lines) {
  using asio::experimental::awaitable_operators::operator||;
  auto first = co_await (session_.run() || obey_all(lines) || answer_password_questions());
  const auto* const ending = std::get_if<0>(&first);
  if (ending == nullptr) co_return Ending{ExitCode::ended_by_user, ""};
  if (owes_reply_) output_("error " + printable(ending->text) + '\n');
  co_return *ending;
}

asio::awaitable<void> Headless::answer_password_questions() {
  for (;;) {
    co_await changed_.wait_until(Clock::time_point::max());
    if (!session_.take_password_question() || !change_) continue;
    session_.change_password(change_->old_password, change_->new_password);
    change_.reset();
  }
}

asio::awaitable<void> Headless::obey_all(LineReader& lines) {
  // The first command waits for the first screen.
  while (!session_.is_online()) co_await changed_.wait_until(Clock::time_point::max());
  bool is_read = true, has_quit = false;
  while (is_read && !has_quit) {
    const auto line = co_await lines.next();
    if (!line) break;
    owes_reply_ = true;
    const auto command = parse_headless(*line, session_.language());
    std::string reply;
    if (!command) {
      reply = "error " + command.error() + '\n';
    } else if (std::holds_alternative<QuitCommand>(*command)) {
      reply = "ok\n";
      has_quit = true;
    } else {
      reply = co_await reply_to(*command);
    }
    is_read = output_(reply);
    owes_reply_ = false;
  }
  session_.log_out();
  // `run` of the session ends first, when the server has said Bye; without a line there is nothing to wait for.
  while (session_.is_online()) co_await changed_.wait_until(Clock::time_point::max());
}

asio::awaitable<std::string> Headless::reply_to(HeadlessCommand command) {
  if (auto* const c = std::get_if<WaitCommand>(&command)) co_return co_await wait_for(*c);
  if (!session_.is_online()) co_return kOffline;
  if (std::holds_alternative<ScreenCommand>(command)) co_return screen_reply(session_.screen(), is_ascii_);
  if (std::holds_alternative<MarksCommand>(command)) co_return marks_reply(session_.screen(), is_ascii_);
  if (auto* const c = std::get_if<PressCommand>(&command)) co_return co_await press(c->chords);
  if (auto* const c = std::get_if<HoldCommand>(&command)) co_return co_await hold(*c);
  if (auto* const c = std::get_if<PotCommand>(&command)) co_return co_await turn(c->percent);
  co_return refusal();
}

// One after the other, each with the screen in view that the one before has made (AUTH-008).
asio::awaitable<std::string> Headless::press(std::vector<Chord> chords) {
  for (const Chord& chord : chords) {
    if (!session_.send_keys(chord, true)) co_return refusal();
    std::string reply = co_await handled(session_.send_keys(chord, false));
    if (reply != "ok\n") co_return reply;
  }
  co_return "ok\n";
}

asio::awaitable<std::string> Headless::hold(HoldCommand command) {
  if (!session_.send_keys(command.chord, true)) co_return refusal();
  asio::steady_timer timer(co_await asio::this_coro::executor, command.duration);
  co_await timer.async_wait(asio::use_awaitable);
  const auto released = session_.send_keys(command.chord, false);
  co_return co_await handled(released);
}

asio::awaitable<std::string> Headless::turn(std::uint32_t percent) {
  const auto turned = session_.send_potentiometer(percent);
  co_return co_await handled(turned);
}

asio::awaitable<std::string> Headless::handled(std::optional<std::uint64_t> number) {
  if (!number) co_return refusal();
  const std::uint64_t connection = session_.connection();
  while (session_.connection() == connection) {
    if (session_.handled_key() >= *number) co_return "ok\n";
    co_await changed_.wait_until(Clock::time_point::max());
  }
  co_return kOffline;
}

asio::awaitable<std::string> Headless::wait_for(WaitCommand command) {
  const auto limit = Clock::now() + command.limit;
  for (;;) {
    if (!session_.is_online()) co_return kOffline;
    if (contains(session_.screen(), command.text) == command.until_present) co_return "ok\n";
    if (Clock::now() >= limit) co_return "timeout\n";
    co_await changed_.wait_until(limit);
  }
}

std::string Headless::refusal() const {
  return session_.is_online() ? std::string(kOnlyLook.in(session_.language())) : kOffline;
}

}  // namespace cnclab::station
