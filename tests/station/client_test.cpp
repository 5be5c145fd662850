// Connecting: addresses, pinned certificates, versions, dead and malicious servers (SEC-001, SEC-006).
#include "station/client.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <boost/system/system_error.hpp>
#include <fstream>

#include "fake_server.hpp"
#include "station/known_hosts.hpp"

namespace cnclab::station {
namespace {

using namespace std::chrono_literals;
using Connected = std::expected<Client, ConnectError>;

FakeServer::Script greets() {
  return [](FakeLine& line) -> asio::awaitable<void> {
    co_await line.greet();
    co_await line.read();  // until the client closes
  };
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Address, HostAndPort) {
  struct Row {
    const char* text;
    const char* host;
    const char* port;
  };
  const Row good[] = {
      {"localhost:3300", "localhost", "3300"},
      {"127.0.0.1:1", "127.0.0.1", "1"},
      {"[::1]:65535", "::1", "65535"},
  };
  for (const Row& row : good) {
    const auto address = parse_address(row.text);
    ASSERT_TRUE(address) << row.text;
    EXPECT_EQ(address->host, row.host);
    EXPECT_EQ(address->port, row.port);
  }
  for (const char* const bad : {"", ":", "host", ":3300", "host:", "host:0", "host:65536", "host:33x", "::1:3300",
                                "[]:3300", "host:-1", "host: 3300"}) {
    EXPECT_FALSE(parse_address(bad)) << bad;
  }
}

TEST(Client, TheFirstUsePinsTheCertificateForTheUserAlone) {
  asio::io_context context;
  FakeServer server(context, {greets(), greets()});
  const TemporaryFolder folder;
  const auto file = folder.path() / "state" / "known_hosts";
  const Trust trust{{}, file};
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Connected first = co_await Client::connect(server.address(), trust, v1::CLIENT_KIND_STATION);
    EXPECT_TRUE(first) << first.error().text;
    EXPECT_TRUE(first->is_first_use());
    EXPECT_EQ(first->welcome().seats_size(), 15);
    const Connected second = co_await Client::connect(server.address(), trust, v1::CLIENT_KIND_STATION);
    EXPECT_TRUE(second) << second.error().text;
    EXPECT_FALSE(second->is_first_use());
  }()));
  struct stat status{};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  EXPECT_EQ(content_of(file), "127.0.0.1:" + server.address().port + " " + server.fingerprint() + "\n");
}

TEST(Client, AnotherCertificateEndsWithFileAndLine) {
  asio::io_context context;
  FakeServer server(context, {greets()});
  const TemporaryFolder folder;
  const auto other = fingerprint_of(make_certificate()->certificate_pem).value();
  const std::string known = "# servers\n127.0.0.1:" + server.address().port + " " + other + "\n";
  const auto file = folder.write("known_hosts", known);
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Trust trust{{}, file};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected client = co_await Client::connect(server.address(), trust, v1::CLIENT_KIND_STATION);
    EXPECT_FALSE(client);
    EXPECT_EQ(client.error().code, ExitCode::certificate_differs);
    for (const std::string& part : {file.string(), std::string("2"), other, server.fingerprint()}) {
      EXPECT_NE(client.error().text.find(part), std::string::npos) << part << " in " << client.error().text;
    }
  }()));
  EXPECT_EQ(content_of(file), known) << "nothing is changed";
}

TEST(Client, AGivenFingerprintDecidesAndNothingIsRemembered) {
  asio::io_context context;
  FakeServer server(context, {greets(), greets()});
  const TemporaryFolder folder;
  const auto file = folder.path() / "known_hosts";
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Trust right_trust{server.fingerprint(), file};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected right = co_await Client::connect(server.address(), right_trust, 1);
    EXPECT_TRUE(right);
    const Trust wrong_trust{"SHA256:wrong", file};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected wrong = co_await Client::connect(server.address(), wrong_trust, 1);
    EXPECT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, ExitCode::certificate_differs);
  }()));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Client, AnUnwritableKnownHostsFileIsNamed) {
  const TemporaryFolder folder;
  folder.write("not_a_folder", "");
  const auto file = folder.path() / "not_a_folder" / "known_hosts";
  const auto judged = judge({{}, file}, {"host", "1"}, "SHA256:x");
  ASSERT_FALSE(judged);
  EXPECT_NE(judged.error().text.find(file.string()), std::string::npos) << judged.error().text;
}

TEST(Client, KnownHostsStandWhereXdgSays) {
  ::setenv("XDG_STATE_HOME", "/somewhere/state", 1);
  EXPECT_EQ(default_known_hosts(), "/somewhere/state/cnclab/known_hosts");
  ::setenv("XDG_STATE_HOME", "relative", 1);
  ::setenv("HOME", "/home/anna", 1);
  EXPECT_EQ(default_known_hosts(), "/home/anna/.local/state/cnclab/known_hosts");
  ::unsetenv("XDG_STATE_HOME");
  EXPECT_EQ(default_known_hosts(), "/home/anna/.local/state/cnclab/known_hosts");
}

TEST(Client, AForeignProtocolVersionIsExitCode8AndNamesTheVersions) {
  asio::io_context context;
  FakeServer server(context, {[](FakeLine& line) -> asio::awaitable<void> {
                      const v1::ClientMessage hello = co_await line.read();
                      EXPECT_EQ(hello.hello().version(), 1U);
                      v1::ServerMessage answer;
                      answer.mutable_welcome()->add_versions(7);
                      answer.mutable_welcome()->add_versions(8);
                      answer.mutable_welcome()->set_text("Bitte aktualisieren.");
                      co_await line.send(answer);
                    }});
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Trust trust{server.fingerprint()};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected client = co_await Client::connect(server.address(), trust, 1);
    EXPECT_FALSE(client);
    EXPECT_EQ(client.error().code, ExitCode::protocol_version);
    EXPECT_NE(client.error().text.find("7, 8"), std::string::npos) << client.error().text;
    EXPECT_NE(client.error().text.find("Bitte aktualisieren."), std::string::npos);
  }()));
}

/// Where somebody listened a moment ago.
Address closed_address(asio::io_context& context) {
  const asio::ip::tcp::acceptor gone(context, asio::ip::tcp::endpoint(asio::ip::address_v4::loopback(), 0));
  return {"127.0.0.1", std::to_string(gone.local_endpoint().port())};
}

TEST(Client, NobodyThereIsExitCode3) {
  asio::io_context context;
  const Address closed = closed_address(context);
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Trust trust{"SHA256:any"};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected client = co_await Client::connect(closed, trust, 1);
    EXPECT_FALSE(client);
    EXPECT_EQ(client.error().code, ExitCode::cannot_connect);
    EXPECT_NE(client.error().text.find(closed.port), std::string::npos);
  }()));
}

TEST(Client, AServerThatNeverAnswersIsGivenUpAtTheDeadline) {
  asio::io_context context;
  FakeServer server(context, {[](FakeLine& line) -> asio::awaitable<void> {
                      for (;;) co_await line.read();
                    }});
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Trust trust{server.fingerprint()};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected client = co_await Client::connect(server.address(), trust, 1, 100ms);
    EXPECT_FALSE(client);
    EXPECT_EQ(client.error().code, ExitCode::cannot_connect);
    EXPECT_NE(client.error().text.find("0.1 s"), std::string::npos) << client.error().text;
  }()));
}

TEST(Client, ABusyServersByeIsItsReason) {
  asio::io_context context;
  FakeServer server(context, {[](FakeLine& line) -> asio::awaitable<void> {
                      co_await line.read();
                      co_await line.say_bye(10, "Der Server wird beendet.");
                    }});
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    const Trust trust{server.fingerprint()};  // named: GCC 12 destroys temporaries of a co_await twice
    const Connected client = co_await Client::connect(server.address(), trust, 1);
    EXPECT_FALSE(client);
    EXPECT_EQ(client.error().code, ExitCode::server_ended);
    EXPECT_EQ(client.error().text, "Der Server wird beendet.");
  }()));
}

TEST(Client, MalformedFramesEndTheConnection) {
  struct Row {
    const char* name;
    std::string bytes;
  };
  const Row rows[] = {
      {"SEC-006 length 0", std::string("\0\0\0\0", 4)},
      {"SEC-005 length 65537", std::string("\0\1\0\1", 4)},
      {"SEC-006 length 2^32-1", "\xFF\xFF\xFF\xFF"},
      {"SEC-006 no message", std::string("\0\0\0\3\xFF\xFF\xFF", 7)},
      {"SEC-006 cut in its middle", std::string("\0\0\0\7ab", 6)},
  };
  for (const Row& row : rows) {
    asio::io_context context;
    FakeServer server(context, {[&](FakeLine& line) -> asio::awaitable<void> {
                        co_await line.greet();
                        co_await line.send_bytes(row.bytes);
                        line.cut();
                      }});
    bool has_thrown = false;
    ASSERT_TRUE(run_to_end(context,
                           [&]() -> asio::awaitable<void> {
                             const Trust trust{
                                 server.fingerprint()};  // named: GCC 12 destroys temporaries of a co_await twice
                             Connected client = co_await Client::connect(server.address(), trust, 1);
                             EXPECT_TRUE(client) << row.name;
                             try {
                               co_await client->read();
                             } catch (const boost::system::system_error&) {
                               has_thrown = true;
                             }
                           }()))
        << row.name;
    EXPECT_TRUE(has_thrown) << row.name;
  }
}

}  // namespace
}  // namespace cnclab::station
