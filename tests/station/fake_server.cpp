// Accepting, reading and writing for the scripts.
#include "fake_server.hpp"

#include <array>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/system/system_error.hpp>
#include <fstream>

#include "shared/frame.hpp"
#include "shared/screen_wire.hpp"

namespace cnclab::station {

using asio::ip::tcp;

asio::awaitable<void> FakeLine::shake_hands() {
  co_await stream_.async_handshake(asio::ssl::stream_base::server, asio::use_awaitable);
}

asio::awaitable<v1::ClientMessage> FakeLine::read() {
  std::array<std::uint8_t, kFrameHeader> header{};
  co_await asio::async_read(stream_, asio::buffer(header), asio::use_awaitable);
  std::string body(body_length(header).value(), '\0');
  co_await asio::async_read(stream_, asio::buffer(body), asio::use_awaitable);
  v1::ClientMessage message;
  if (!message.ParseFromString(body)) throw std::runtime_error("the station sent a malformed message");
  co_return message;
}

asio::awaitable<v1::ClientMessage> FakeLine::read(v1::ClientMessage::WhatCase kind) {
  for (;;) {
    v1::ClientMessage message = co_await read();
    if (message.what_case() == kind) co_return message;
  }
}

asio::awaitable<void> FakeLine::send(v1::ServerMessage message) { co_await send_bytes(frame(message)); }

asio::awaitable<void> FakeLine::send_bytes(std::string bytes) {
  co_await asio::async_write(stream_, asio::buffer(bytes), asio::use_awaitable);
}

void FakeLine::cut() {
  boost::system::error_code ignored;
  stream_.lowest_layer().close(ignored);
}

asio::awaitable<v1::Hello> FakeLine::greet() {
  const v1::ClientMessage hello = co_await read(v1::ClientMessage::kHello);
  v1::ServerMessage answer;
  answer.mutable_welcome()->set_accepted(true);
  answer.mutable_welcome()->add_versions(kProtocolVersion);
  answer.mutable_welcome()->set_language("de");
  for (std::uint32_t station = 1; station <= 15; ++station) {
    v1::Seat* const seat = answer.mutable_welcome()->add_seats();
    seat->set_station(station);
    seat->set_is_free(station != 3);
  }
  co_await send(answer);
  co_return hello.hello();
}

asio::awaitable<void> FakeLine::answer_login(v1::LoginAnswer answer) {
  v1::ServerMessage message;
  *message.mutable_login() = std::move(answer);
  co_await send(message);
}

asio::awaitable<v1::Login> FakeLine::admit(std::string ticket) {
  co_await greet();
  const v1::ClientMessage login = co_await read(v1::ClientMessage::kLogin);
  v1::LoginAnswer answer;
  answer.set_result(v1::LOGIN_RESULT_OK);
  answer.set_ticket(ticket);
  answer.set_role("student");
  answer.set_language("de");
  answer.set_user(login.login().user());
  co_await answer_login(answer);
  co_return login.login();
}

asio::awaitable<void> FakeLine::show(Screen screen, std::uint64_t handled_key, std::uint64_t state) {
  v1::ServerMessage message;
  v1::ScreenUpdate& update = *message.mutable_screen();
  write_rows(shown_, screen, update);
  update.set_number(++screens_);
  update.set_handled_key(handled_key);
  update.set_state(state);
  shown_ = screen;
  co_await send(message);
}

asio::awaitable<void> FakeLine::show_text(std::string row_0, std::uint64_t handled_key, std::uint64_t state) {
  Screen screen;
  screen.write(0, 0, row_0);
  co_await show(screen, handled_key, state);
}

asio::awaitable<void> FakeLine::say_bye(std::uint32_t exit_code, std::string text) {
  v1::ServerMessage message;
  message.mutable_bye()->set_exit_code(exit_code);
  message.mutable_bye()->set_text(text);
  co_await send(message);
}

asio::awaitable<void> FakeLine::serve_keys(std::vector<v1::ClientMessage>* seen) {
  co_await show_text("handled 0");
  for (;;) {
    const v1::ClientMessage message = co_await read();
    if (message.has_logout()) break;
    const std::uint64_t number = message.has_key()             ? message.key().number()
                                 : message.has_potentiometer() ? message.potentiometer().number()
                                                               : 0;
    if (number == 0) continue;
    if (seen != nullptr) seen->push_back(message);
    co_await show_text("handled " + std::to_string(number), number, number + 1);
  }
  co_await say_bye(0, "Abgemeldet.");
}

FakeServer::FakeServer(asio::io_context& context, std::vector<Script> scripts)
    : context_(context),
      certificate_(make_certificate().value()),
      tls_(server_context(certificate_)),
      acceptor_(context, tcp::endpoint(asio::ip::address_v4::loopback(), 0)),
      scripts_(std::move(scripts)) {
  asio::co_spawn(context_, accept_all(), asio::detached);
}

Address FakeServer::address() const { return {"127.0.0.1", std::to_string(acceptor_.local_endpoint().port())}; }

asio::awaitable<void> FakeServer::accept_all() {
  for (;;) {
    tcp::socket socket = co_await acceptor_.async_accept(asio::use_awaitable);
    const std::size_t index = accepted_++;
    asio::co_spawn(context_, play(std::move(socket), index), asio::detached);
  }
}

asio::awaitable<void> FakeServer::play(tcp::socket socket, std::size_t index) {
  if (index >= scripts_.size()) co_return;
  FakeLine line(std::move(socket), tls_);
  try {
    co_await line.shake_hands();
    co_await scripts_[index](line);
  } catch (const boost::system::system_error&) {
    // the station has closed: the test says whether it should have
  } catch (const std::exception& error) {
    failures_.emplace_back(error.what());
  }
}

bool run_to_end(asio::io_context& context, asio::awaitable<void> test) {
  std::exception_ptr failure;
  bool has_ended = false;
  asio::co_spawn(context, std::move(test), [&](const std::exception_ptr& error) {
    failure = error;
    has_ended = true;
    context.stop();
  });
  context.run_for(std::chrono::seconds(20));
  if (failure) std::rethrow_exception(failure);
  return has_ended;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "cnclab-station-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

}  // namespace cnclab::station
