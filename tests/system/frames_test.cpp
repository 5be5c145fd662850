// Bytes that no client of ours sends: they end their own connection and nothing else (SEC-005, SEC-006).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <functional>
#include <random>

#include "harness/classroom.hpp"
#include "harness/failure.hpp"
#include "harness/raw_client.hpp"
#include "shared/frame.hpp"

namespace cnclab::harness {
namespace {

std::string header(std::uint32_t length) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((length >> shift) & 0xFFU);
  return bytes;
}

std::string random_bytes(std::size_t count) {
  std::mt19937 source(3300);
  std::string bytes(count, '\0');
  for (auto& byte : bytes) byte = static_cast<char>(source());
  return bytes;
}

v1::ClientMessage login_message() {
  v1::ClientMessage message;
  message.mutable_login()->set_user("anna");
  return message;
}

v1::ClientMessage key_message(std::uint64_t number, int key) {
  v1::ClientMessage message;
  message.mutable_key()->set_number(number);
  message.mutable_key()->add_keys(static_cast<v1::Key>(key));
  message.mutable_key()->set_pressed(true);
  return message;
}

struct BadRow {
  std::string name;
  bool greets;  ///< Hello first
  std::function<std::string()> bytes;
};

void PrintTo(const BadRow& row, std::ostream* out) { *out << row.name; }

class BadBytes : public testing::TestWithParam<BadRow> {};

TEST_P(BadBytes, end_that_connection_alone) {
  Classroom room;
  room.add_student("anna");
  StationProcess anna = room.seat(1, "anna");
  RawClient client(room.server().port());
  if (GetParam().greets) {
    ASSERT_TRUE(client.greet(v1::CLIENT_KIND_STATION));
  }
  client.send_bytes(GetParam().bytes());
  EXPECT_TRUE(client.is_closed_within(kLimit));
  anna.key("EINGABE");
  anna.wait_for("EINGABEMODUS");
  EXPECT_TRUE(room.server().is_running());
}

INSTANTIATE_TEST_SUITE_P(
    SEC_006, BadBytes,
    testing::Values(BadRow{"length 0", false, [] { return header(0); }},
                    BadRow{"length 65537", false, [] { return header(65'537) + std::string(65'537, 'x'); }},
                    BadRow{"length 4294967295", false, [] { return header(0xFFFFFFFFU); }},
                    BadRow{"no protobuf", false, [] { return header(100) + std::string(100, '\xFF'); }},
                    BadRow{"random bytes", false, [] { return random_bytes(100'000); }},
                    BadRow{"random bytes after Hello", true, [] { return random_bytes(100'000); }},
                    BadRow{"Login before Hello", false, [] { return frame(login_message()); }},
                    BadRow{"a key before Login", true, [] { return frame(key_message(1, 22)); }},
                    BadRow{"an empty message", true, [] { return header(2) + std::string("\x5A\x00", 2); }},
                    BadRow{"a second Hello", true,
                           [] {
                             v1::ClientMessage message;
                             message.mutable_hello()->set_version(1);
                             return frame(message);
                           }},
                    BadRow{"a name of 33 bytes", true, [] {
                             v1::ClientMessage message;
                             message.mutable_login()->set_user(std::string(33, 'a'));
                             return frame(message);
                           }}));

struct SeatedRow {
  std::string name;
  std::function<v1::ClientMessage()> message;
};

void PrintTo(const SeatedRow& row, std::ostream* out) { *out << row.name; }

class BadMessageFromASeat : public testing::TestWithParam<SeatedRow> {};

TEST_P(BadMessageFromASeat, ends_that_connection_alone) {
  Classroom room;
  room.add_student("anna");
  room.add_student("otto");
  StationProcess anna = room.seat(1, "anna");
  RawClient otto(room.server().port());
  ASSERT_TRUE(otto.greet(v1::CLIENT_KIND_STATION));
  const auto login = otto.log_in("otto", room.passwords().password_of("otto"), 2);
  ASSERT_TRUE(login);
  ASSERT_EQ(login->result(), v1::LOGIN_RESULT_OK);
  otto.send(GetParam().message());
  EXPECT_TRUE(otto.is_closed_within(kLimit));
  anna.key("EINGABE");
  EXPECT_TRUE(room.server().is_running());
}

INSTANTIATE_TEST_SUITE_P(SEC_006, BadMessageFromASeat,
                         testing::Values(SeatedRow{"key number 7 first", [] { return key_message(7, 22); }},
                                         SeatedRow{"key 0", [] { return key_message(1, 0); }},
                                         SeatedRow{"key 44", [] { return key_message(1, 44); }},
                                         SeatedRow{"a key event of no keys",
                                                   [] {
                                                     auto message = key_message(1, 22);
                                                     message.mutable_key()->clear_keys();
                                                     return message;
                                                   }},
                                         SeatedRow{"potentiometer 101",
                                                   [] {
                                                     v1::ClientMessage message;
                                                     message.mutable_potentiometer()->set_number(1);
                                                     message.mutable_potentiometer()->set_percent(101);
                                                     return message;
                                                   }},
                                         SeatedRow{"a screen that was never sent acknowledged",
                                                   [] {
                                                     v1::ClientMessage message;
                                                     message.mutable_screen_ack()->set_number(4711);
                                                     return message;
                                                   }},
                                         SeatedRow{"a second login", login_message}));

TEST(Frames, SEC_006_a_frame_that_stops_in_its_middle_is_ended_with_its_connection) {
  Classroom room;
  {
    RawClient client(room.server().port());
    ASSERT_TRUE(client.greet(v1::CLIENT_KIND_STATION));
    client.send_bytes(header(1000) + "half");
  }
  EXPECT_EQ(room.instructor().status()["selected"], 0);
}

TEST(Frames, SEC_006_plain_bytes_without_TLS_are_ended) {
  namespace asio = boost::asio;
  Classroom room;
  asio::io_context context;
  asio::ip::tcp::socket socket(context);
  socket.connect({asio::ip::address_v4::loopback(), room.server().port()});
  asio::write(socket, asio::buffer(std::string("GET / HTTP/1.1\r\n\r\n")));
  bool is_closed = false;
  std::string received(4096, '\0');
  std::function<void()> read = [&] {
    socket.async_read_some(asio::buffer(received), [&](const boost::system::error_code& error, std::size_t) {
      is_closed = static_cast<bool>(error);
      if (!error) read();
    });
  };
  read();
  context.run_for(kLimit);
  EXPECT_TRUE(is_closed);
  EXPECT_EQ(room.instructor().status()["selected"], 0);
}

TEST(Frames, SEC_005_who_does_not_log_in_within_10_s_is_ended) {
  Classroom room;
  RawClient client(room.server().port());
  ASSERT_TRUE(client.greet(v1::CLIENT_KIND_STATION));
  EXPECT_TRUE(client.is_closed_within(12s));
}

TEST(Frames, SEC_005_the_unauthenticated_are_at_most_64_and_do_not_keep_others_out) {
  Classroom room;
  room.add_student("anna");
  std::vector<std::unique_ptr<RawClient>> crowd;
  constexpr int kMost = 64;
  for (int i = 0; i < kMost + 6; ++i) {
    try {
      crowd.push_back(std::make_unique<RawClient>(room.server().port()));
    } catch (const Failure&) {
      break;  // refused: that is one of the answers
    }
  }
  EXPECT_LE(crowd.size(), kMost + 6U);
  int open = 0;
  for (auto& client : crowd) open += client->greet(v1::CLIENT_KIND_STATION) ? 1 : 0;
  EXPECT_LE(open, kMost);
  crowd.clear();
  StationProcess anna = room.seat(1, "anna");
  anna.key("MENU");
}

TEST(Frames, LOAD_002_a_station_that_stops_reading_costs_nobody_time) {
  Classroom room;
  room.add_student("anna");
  room.add_student("otto");
  TcpProxy line(room.server().port());
  StationProcess otto = room.seat_behind(line, 2, "otto");
  line.stall_answers();
  StationProcess anna = room.seat(1, "anna");
  anna.key("EINGABE");
  anna.wait_for("EINGABEMODUS");
  EXPECT_TRUE(room.server().is_running());
}

}  // namespace
}  // namespace cnclab::harness
