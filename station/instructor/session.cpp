// Logging in, asking one thing after the other, and answering the server's beats meanwhile.
#include "instructor/session.hpp"

#include <boost/system/system_error.hpp>
#include <variant>

#include "instructor/prompts.hpp"
#include "instructor/tape_parts.hpp"
#include "shared/frame.hpp"
#include "shared/screen_wire.hpp"
#include "station/login.hpp"

namespace cnclab::instructor {
namespace {

using boost::asio::awaitable;
using station::Client;
using station::ExitCode;
template <class T>
using Result = std::expected<T, Failure>;

constexpr station::Text kLineLost{"die Verbindung zum Server ist verloren: ", "the line to the server is lost: "};

Failure failure(ExitCode code, std::string text) { return {static_cast<int>(code), std::move(text)}; }

/// The server's farewell as a failure; a farewell without a code of its own is its end.
Failure farewell(const v1::Bye& bye) {
  const int code = bye.exit_code() == 0 ? static_cast<int>(ExitCode::server_ended) : static_cast<int>(bye.exit_code());
  return {code, bye.text()};
}

/// The next message that is neither a beat (answered here) nor a farewell.
awaitable<Result<v1::ServerMessage>> next_message(Client& client) {
  try {
    for (;;) {
      v1::ServerMessage message = co_await client.read();
      if (message.has_bye()) co_return std::unexpected(farewell(message.bye()));
      if (!message.has_beat()) co_return message;
      v1::ClientMessage alive;
      alive.mutable_alive()->set_beat(message.beat().number());
      co_await client.write(alive);
    }
  } catch (const boost::system::system_error& error) {
    co_return std::unexpected(failure(ExitCode::server_ended, own_words(kLineLost) + error.code().message()));
  }
}

awaitable<Result<void>> send(Client& client, const v1::ClientMessage& message) {
  try {
    co_await client.write(message);
    co_return Result<void>();
  } catch (const boost::system::system_error& error) {
    co_return std::unexpected(failure(ExitCode::server_ended, own_words(kLineLost) + error.code().message()));
  }
}

Failure failure_of(const station::LoginFailure& failure) {
  if (const auto* const ending = std::get_if<station::Ending>(&failure))
    return {static_cast<int>(ending->code), ending->text};
  const auto ending = station::ending_of(std::get<v1::LoginAnswer>(failure), station::language_of_locale());
  return {static_cast<int>(ending.code), ending.text};
}

/// Whether another new password would help.
bool needs_new_password(const station::LoginFailure& failure) {
  const auto* const answer = std::get_if<v1::LoginAnswer>(&failure);
  return answer != nullptr &&
         (answer->result() == v1::LOGIN_RESULT_PASSWORD_EXPIRED || answer->result() == v1::LOGIN_RESULT_PASSWORD_WEAK);
}

/// What one message of the answer to `number` means.
struct Progress {
  bool has_ended = false;
  bool expects_content = false;
};

Result<void> take_answer(const v1::InstructorAnswer& answer, const Sink& sink, Progress& progress) {
  if (!answer.error().empty()) return std::unexpected(Failure{kRefused, answer.error()});
  for (const auto& item : answer.items()) sink(item);
  progress.has_ended = !answer.more();
  progress.expects_content = progress.expects_content || answer.transfer() != 0;
  return {};
}

awaitable<Result<void>> take_chunk(Client& client, const v1::Chunk& chunk, BulkFile* file) {
  if (file == nullptr)
    co_return std::unexpected(Failure{kRefused, own_words({"der Server hat ungefragt Inhalt geschickt",
                                                           "the server sent content that was not asked for"})});
  const auto acknowledgement = file->take(chunk);
  v1::ClientMessage message;
  if (acknowledgement) {
    *message.mutable_chunk_ack() = *acknowledgement;
  } else {
    message.mutable_chunk_ack()->set_transfer(chunk.transfer());
    message.mutable_chunk_ack()->set_abort(true);
    message.mutable_chunk_ack()->set_reason(acknowledgement.error().text);
  }
  const auto sent = co_await send(client, message);
  if (!acknowledgement) co_return std::unexpected(acknowledgement.error());
  co_return sent;
}

}  // namespace

awaitable<Result<Entry>> enter(const Access& access, Credentials credentials) {
  const station::Door door{.address = access.address, .trust = access.trust, .kind = v1::CLIENT_KIND_INSTRUCTOR};
  for (;;) {
    const station::Credentials shown{.user = credentials.user,
                                     .password = credentials.password,
                                     .station = 0,
                                     .elsewhere = v1::ELSEWHERE_UNSPECIFIED,
                                     .new_password = credentials.new_password};
    auto attempt = co_await station::attempt_login(door, shown);
    if (attempt) {
      co_return Entry{.client = std::move(attempt->client),
                      .password = attempt->has_new_password ? *credentials.new_password : credentials.password,
                      .language = attempt->answer.language(),
                      .changed_password = attempt->has_new_password};
    }
    if (!needs_new_password(attempt.error()) || !credentials.may_ask)
      co_return std::unexpected(failure_of(attempt.error()));
    credentials.new_password = ask_new_password();
    if (!credentials.new_password) co_return std::unexpected(failure_of(attempt.error()));
  }
}

awaitable<Result<void>> ask(Client& client, v1::InstructorRequest request, Sink sink, BulkFile* file) {
  while (auto part = take_part(request)) {
    Sink nothing_to_print = [](const v1::InstructorItem&) {};
    const auto taken = co_await ask(client, std::move(*part), std::move(nothing_to_print), nullptr);
    if (!taken) co_return taken;
  }
  request.set_number(1);
  v1::ClientMessage message;
  *message.mutable_request() = std::move(request);
  if (message.ByteSizeLong() > kLargestFrame) co_return std::unexpected(Failure{kRefused, own_words(kTooLarge)});
  const auto sent = co_await send(client, message);
  if (!sent) co_return sent;
  Progress progress;
  while (!progress.has_ended || (progress.expects_content && !(file != nullptr && file->is_complete()))) {
    const auto received = co_await next_message(client);
    if (!received) co_return std::unexpected(received.error());
    Result<void> taken;
    if (received->has_answer()) taken = take_answer(received->answer(), sink, progress);
    if (received->has_chunk()) taken = co_await take_chunk(client, received->chunk(), file);
    if (!taken) co_return taken;
  }
  if (file != nullptr && !file->is_complete()) {
    co_return std::unexpected(
        Failure{kRefused, own_words({"der Server hat keinen Inhalt geschickt", "the server sent no content"})});
  }
  co_return Result<void>();
}

awaitable<Result<void>> follow_screen(Client& client, v1::InstructorRequest request, ScreenSink sink) {
  request.set_number(1);
  v1::ClientMessage message;
  *message.mutable_request() = std::move(request);
  if (const auto sent = co_await send(client, message); !sent) co_return sent;
  Screen screen;
  for (;;) {
    const auto received = co_await next_message(client);
    if (!received) co_return std::unexpected(received.error());
    if (received->has_answer() && !received->answer().error().empty())
      co_return std::unexpected(Failure{kRefused, received->answer().error()});
    if (!received->has_screen()) continue;
    auto newer = apply_rows(screen, received->screen());
    if (!newer) co_return std::unexpected(failure(ExitCode::server_ended, "a malformed screen: " + newer.error()));
    screen = std::move(*newer);
    v1::ClientMessage acknowledgement;
    acknowledgement.mutable_screen_ack()->set_number(received->screen().number());
    if (const auto sent = co_await send(client, acknowledgement); !sent) co_return sent;
    if (!sink(screen)) co_return Result<void>();
  }
}

awaitable<void> log_out(Client& client) {
  v1::ClientMessage message;
  message.mutable_logout();
  static_cast<void>(co_await send(client, message));
  client.close();
}

}  // namespace cnclab::instructor
