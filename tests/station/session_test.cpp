// The conversation after the login: acknowledgements, signs of life, numbers, cut lines (SEAT-004, SEAT-005, AUTH-007).
#include "station/session.hpp"

#include <gtest/gtest.h>

#include <boost/asio/experimental/awaitable_operators.hpp>

#include "fake_server.hpp"
#include "shared/digest.hpp"

namespace cnclab::station {
namespace {

using namespace std::chrono_literals;
using asio::experimental::awaitable_operators::operator||;
using Test = std::function<asio::awaitable<void>(Session&, Broadcast&)>;

// Waits for a condition of the session; the test as a whole has a limit.
asio::awaitable<void> until(Broadcast& changed, std::function<bool()> condition) {
  while (!condition()) co_await changed.wait_until(Broadcast::Clock::now() + 20ms);
}

struct Played {
  std::optional<Ending> ending;  ///< nothing when the test ended first
  std::size_t connections = 0;
};

// Logs in at a server of these scripts and runs the test beside the session.
Played play(std::vector<FakeServer::Script> scripts, Test test, Pace pace = kQuick, Session::Relogin relogin = {},
            std::optional<MediaPlace> media = {}) {
  asio::io_context context;
  FakeServer server(context, std::move(scripts));
  Door door = server.door();
  door.media = std::move(media);
  Played played;
  const bool has_ended = run_to_end(context, [&]() -> asio::awaitable<void> {
    Credentials credentials{"anna", "geheim", 7, v1::ELSEWHERE_UNSPECIFIED, std::nullopt};
    auto login = co_await attempt_login(door, credentials);
    if (!login) throw std::runtime_error("no login");
    Broadcast changed(context.get_executor());
    if (!relogin) {
      relogin = [&](const v1::LoginAnswer&) { return log_in(door, credentials, false, {}); };
    }
    Session session(door, std::move(*login), changed, relogin, pace);
    auto first = co_await (session.run() || test(session, changed));
    if (auto* const ending = std::get_if<0>(&first)) played.ending = std::move(*ending);
  }());
  EXPECT_TRUE(has_ended) << "still not at its end after 20 s";
  for (const std::string& failure : server.failures()) ADD_FAILURE() << failure;
  played.connections = server.accepted();
  return played;
}

asio::awaitable<void> idle(Broadcast& changed) { co_await changed.wait_until(Broadcast::Clock::time_point::max()); }

Test only_listens() {
  return [](Session&, Broadcast& changed) -> asio::awaitable<void> {
    for (;;) co_await idle(changed);
  };
}

TEST(Session, ScreensAreShownAndAcknowledgedAtOnce) {
  std::vector<std::uint64_t> acknowledged;
  std::string row;
  play({[&](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit();
         for (const char* const text : {"eins", "zwei"}) {
           co_await line.show_text(text);
           acknowledged.push_back((co_await line.read(v1::ClientMessage::kScreenAck)).screen_ack().number());
         }
         co_await line.say_bye(0, "");
       }},
       [&](Session& session, Broadcast& changed) -> asio::awaitable<void> {
         EXPECT_FALSE(session.is_online()) << "no screen yet";
         co_await until(changed, [&] { return session.screen().text(0).starts_with("zwei"); });
         EXPECT_TRUE(session.is_online());
         row = session.screen().text(0);
         for (;;) co_await idle(changed);
       });
  EXPECT_EQ(acknowledged, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_TRUE(row.starts_with("zwei "));
}

TEST(Session, EachBeatIsAnsweredAtOnceWithItsNumber) {  // AUTH-007
  std::vector<std::uint64_t> beats;
  play({[&](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit();
         for (const std::uint64_t number : {41U, 42U}) {
           v1::ServerMessage beat;
           beat.mutable_beat()->set_number(number);
           co_await line.send(beat);
           beats.push_back((co_await line.read(v1::ClientMessage::kAlive)).alive().beat());
         }
         co_await line.say_bye(0, "");
       }},
       only_listens(), {1h, 1h, 5ms, 20ms, 500ms});
  EXPECT_EQ(beats, (std::vector<std::uint64_t>{41, 42}));
}

TEST(Session, SignsOfLifeComeWithoutBeatsToo) {  // SEAT-004
  int signs = 0;
  play({[&](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit();
         for (; signs < 2; ++signs) co_await line.read(v1::ClientMessage::kAlive);
         co_await line.say_bye(0, "");
       }},
       only_listens(), {10ms, 5s, 5ms, 20ms, 500ms});
  EXPECT_EQ(signs, 2);
}

TEST(Session, KeysCountAndSayWhatWasSeen) {  // AUTH-007, AUTH-008
  std::vector<v1::ClientMessage> seen;
  play({[&](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit();
         v1::ServerMessage beat;
         beat.mutable_beat()->set_number(9);
         co_await line.send(beat);
         co_await line.show_text("bereit", 0, 17);
         seen.push_back(co_await line.read(v1::ClientMessage::kKey));
         seen.push_back(co_await line.read(v1::ClientMessage::kKey));
         seen.push_back(co_await line.read(v1::ClientMessage::kPotentiometer));
         co_await line.say_bye(0, "");
       }},
       [](Session& session, Broadcast& changed) -> asio::awaitable<void> {
         const std::array keys{Key::ENTER, Key::RESET};
         EXPECT_FALSE(session.send_keys(keys, true)) << "before the first screen nothing was seen";
         co_await until(changed, [&] { return session.is_online(); });
         EXPECT_EQ(session.send_keys(keys, true, true), 1U);
         EXPECT_EQ(session.send_keys(keys, false), 2U);
         EXPECT_EQ(session.send_potentiometer(35), 3U);
         for (;;) co_await idle(changed);
       });
  ASSERT_EQ(seen.size(), 3U);
  const v1::KeyEvent& first = seen[0].key();
  EXPECT_EQ(first.number(), 1U);
  EXPECT_EQ(first.keys_size(), 2);
  EXPECT_EQ(first.keys(0), v1::KEY_ENTER);
  EXPECT_EQ(first.keys(1), v1::KEY_RESET);
  EXPECT_TRUE(first.pressed());
  EXPECT_TRUE(first.is_repeat());
  EXPECT_EQ(first.seen().beat(), 9U);
  EXPECT_EQ(first.seen().state(), 17U);
  EXPECT_FALSE(seen[1].key().pressed());
  EXPECT_EQ(seen[2].potentiometer().number(), 3U);
  EXPECT_EQ(seen[2].potentiometer().percent(), 35U);
}

TEST(Session, ACutLineIsResumedWithTheTicketAndNothingIsSentAgain) {  // SEAT-004, SEAT-005
  std::string resumed_with;
  std::uint64_t first_number = 0;
  v1::Key first_key = v1::KEY_UNSPECIFIED;
  bool was_lost = false;
  const Played played = play({[](FakeLine& line) -> asio::awaitable<void> {
                                co_await line.admit("ticket-1");
                                co_await line.show_text("vor dem Schnitt");
                                co_await line.read(v1::ClientMessage::kKey);
                                line.cut();
                              },
                              [&](FakeLine& line) -> asio::awaitable<void> {
                                co_await line.greet();
                                resumed_with = (co_await line.read(v1::ClientMessage::kResume)).resume().ticket();
                                v1::LoginAnswer answer;
                                answer.set_result(v1::LOGIN_RESULT_OK);
                                answer.set_ticket("ticket-2");
                                co_await line.answer_login(answer);
                                co_await line.show_text("wieder da");
                                const v1::ClientMessage key = co_await line.read(v1::ClientMessage::kKey);
                                first_number = key.key().number();
                                first_key = key.key().keys(0);
                                co_await line.say_bye(0, "");
                              }},
                             [&](Session& session, Broadcast& changed) -> asio::awaitable<void> {
                               co_await until(changed, [&] { return session.is_online(); });
                               session.send_keys(std::array{Key::START}, true);
                               co_await until(changed, [&] { return session.is_lost(); });
                               was_lost = !session.is_online();
                               EXPECT_FALSE(session.send_keys(std::array{Key::STOP}, true))
                                   << "dropped while the line is lost";
                               co_await until(changed, [&] { return session.is_online(); });
                               EXPECT_TRUE(session.screen().text(0).starts_with("wieder da"));
                               session.send_keys(std::array{Key::MENU}, true);
                               for (;;) co_await idle(changed);
                             });
  EXPECT_TRUE(was_lost);
  EXPECT_EQ(resumed_with, "ticket-1");
  EXPECT_EQ(first_number, 1U) << "each connection counts from 1";
  EXPECT_EQ(first_key, v1::KEY_MENU);
  EXPECT_EQ(played.connections, 2U);
}

TEST(Session, AVoidTicketIsAnsweredByANewLogin) {
  std::string user;
  const Played played = play({[](FakeLine& line) -> asio::awaitable<void> {
                                co_await line.admit();
                                line.cut();
                              },
                              [](FakeLine& line) -> asio::awaitable<void> {
                                co_await line.greet();
                                co_await line.read(v1::ClientMessage::kResume);
                                v1::LoginAnswer answer;
                                answer.set_result(v1::LOGIN_RESULT_TICKET_VOID);
                                co_await line.answer_login(answer);
                                co_await line.read();
                              },
                              [&](FakeLine& line) -> asio::awaitable<void> {
                                user = (co_await line.admit("ticket-9")).user();
                                co_await line.say_bye(0, "");
                              }},
                             only_listens());
  EXPECT_EQ(user, "anna");
  EXPECT_EQ(played.connections, 3U);
  ASSERT_TRUE(played.ending);
  EXPECT_EQ(played.ending->code, ExitCode::ended_by_user);
}

v1::ServerMessage put_media(std::uint64_t offset = 0) {
  v1::ServerMessage message;
  message.mutable_put_media()->set_transfer(1);
  message.mutable_put_media()->set_name("P0001.nc");
  message.mutable_put_media()->set_size(6);
  message.mutable_put_media()->set_offset(offset);
  if (offset != 0) message.mutable_put_media()->set_digest(sha256(std::string_view("abcdef").substr(0, offset)));
  return message;
}

/// Sends "abc", the first half of the file, and cuts the line.
asio::awaitable<void> send_half(FakeLine& line) {
  co_await line.send(put_media());
  co_await line.read(v1::ClientMessage::kChunkAck);
  v1::ServerMessage message;
  message.mutable_chunk()->set_transfer(1);
  message.mutable_chunk()->set_data("abc");
  co_await line.send(message);
  co_await line.read(v1::ClientMessage::kChunkAck);
  line.cut();
}

TEST(Session, HalfAFileOutlivesACutButNoNewLoginAndNoOtherUser) {  // SEAT-004, SEC-006
  const struct {
    const char* name;
    v1::LoginResult result;
    std::string user;
    std::uint64_t kept;
  } rows[] = {
      {"resumed", v1::LOGIN_RESULT_OK, "anna", 3},
      {"resumed as somebody else", v1::LOGIN_RESULT_OK, "berta", 0},
      {"logged in anew", v1::LOGIN_RESULT_TICKET_VOID, "anna", 0},
  };
  for (const auto& row : rows) {
    const TemporaryFolder folder;
    std::optional<std::uint64_t> kept;
    const auto ask_again = [&](FakeLine& line) -> asio::awaitable<void> {
      co_await line.send(put_media(3));
      kept = (co_await line.read(v1::ClientMessage::kChunkAck)).chunk_ack().next_offset();
      co_await line.say_bye(0, "");
    };
    play({[](FakeLine& line) -> asio::awaitable<void> {
            co_await line.admit();
            co_await send_half(line);
          },
          [&](FakeLine& line) -> asio::awaitable<void> {
            co_await line.greet();
            co_await line.read(v1::ClientMessage::kResume);
            v1::LoginAnswer answer;
            answer.set_result(row.result);
            answer.set_user(row.user);
            answer.set_ticket("ticket-2");
            co_await line.answer_login(answer);
            if (row.result == v1::LOGIN_RESULT_OK) co_await ask_again(line);
          },
          [&](FakeLine& line) -> asio::awaitable<void> {
            co_await line.admit("ticket-9");
            co_await ask_again(line);
          }},
         only_listens(), kQuick, {}, MediaPlace{folder.path(), false});
    EXPECT_EQ(kept, row.kept) << row.name;
  }
}

TEST(Session, ASilentServerCountsAsLost) {  // SEAT-004
  const Played played = play({[](FakeLine& line) -> asio::awaitable<void> {
                                co_await line.admit();
                                co_await line.show_text("dann Stille");
                                for (;;) co_await line.read();
                              },
                              [](FakeLine& line) -> asio::awaitable<void> {
                                co_await line.greet();
                                co_await line.read(v1::ClientMessage::kResume);
                                co_await line.say_bye(10, "Ende");
                              }},
                             [](Session& session, Broadcast& changed) -> asio::awaitable<void> {
                               co_await until(changed, [&] { return session.is_lost(); });
                             },
                             {20ms, 150ms, 5ms, 20ms, 500ms});
  EXPECT_FALSE(played.ending) << "the test saw the loss first";
}

TEST(Session, AMalformedScreenCutsTheLine) {  // SEC-006
  const Played played = play({[](FakeLine& line) -> asio::awaitable<void> {
                               co_await line.admit();
                               v1::ServerMessage message;
                               message.mutable_screen()->add_rows()->set_index(99);
                               co_await line.send(message);
                               for (;;) co_await line.read();
                             }},
                             [](Session& session, Broadcast& changed) -> asio::awaitable<void> {
                               co_await until(changed, [&] { return session.is_lost(); });
                               EXPECT_EQ(session.screen(), Screen());
                             });
  EXPECT_FALSE(played.ending);
}

TEST(Session, WhatItDoesNotKnowIsPassedOver) {
  const Played played = play({[](FakeLine& line) -> asio::awaitable<void> {
                               co_await line.admit();
                               co_await line.send_bytes(std::string("\0\0\0\4\xFA\x3F\1x", 8));  // field 127
                               v1::ServerMessage chunk;
                               chunk.mutable_chunk()->set_data("x");
                               co_await line.send(chunk);
                               co_await line.say_bye(9, "Vom Lehrer beendet.");
                             }},
                             only_listens());
  ASSERT_TRUE(played.ending);
  EXPECT_EQ(played.ending->code, ExitCode::expelled);
  EXPECT_EQ(played.connections, 1U);
}

TEST(Session, EveryByeHasItsExitCode) {
  struct Row {
    std::uint32_t sent;
    ExitCode code;
  };
  const Row rows[] = {{0, ExitCode::ended_by_user}, {6, ExitCode::replaced},     {9, ExitCode::expelled},
                      {10, ExitCode::server_ended}, {1, ExitCode::server_ended}, {4711, ExitCode::server_ended}};
  for (const Row& row : rows) {
    const Ending ending = ending_of(row.sent, "", Language::german);
    EXPECT_EQ(ending.code, row.code) << row.sent;
    EXPECT_EQ(ending.text.empty(), row.sent == 0) << row.sent;
  }
}

TEST(Session, ALoginWithoutATicketOnlyLooksOn) {  // SEAT-003, SEAT-006
  play({[](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit("");
         co_await line.show_text("fremder Schirm");
         v1::ClientMessage message;
         do {
           message = co_await line.read();
           EXPECT_FALSE(message.has_key() || message.has_potentiometer());
         } while (!message.has_logout());
         co_await line.say_bye(0, "");
       }},
       [](Session& session, Broadcast& changed) -> asio::awaitable<void> {
         co_await until(changed, [&] { return session.is_online(); });
         EXPECT_FALSE(session.may_press());
         EXPECT_FALSE(session.send_keys(std::array{Key::START}, true));
         EXPECT_FALSE(session.send_potentiometer(50));
         session.log_out();
         for (;;) co_await idle(changed);
       });
}

TEST(Session, LoggingOutWhileTheLineIsLostEndsWithoutAServer) {
  const Played played = play({[](FakeLine& line) -> asio::awaitable<void> {
                               co_await line.admit();
                               line.cut();
                             }},
                             [](Session& session, Broadcast& changed) -> asio::awaitable<void> {
                               co_await until(changed, [&] { return session.is_lost(); });
                               session.log_out();
                               for (;;) co_await idle(changed);
                             });
  ASSERT_TRUE(played.ending);
  EXPECT_EQ(played.ending->code, ExitCode::ended_by_user);
}

}  // namespace
}  // namespace cnclab::station
