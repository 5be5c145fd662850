// The lab's certificate and TLS 1.3 between two ends in one process (SEC-001).
#include "shared/tls.hpp"

#include <gtest/gtest.h>
#include <openssl/ssl.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/connect_pair.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/ssl/stream.hpp>

namespace cnclab {
namespace {

namespace asio = boost::asio;
using Local = asio::local::stream_protocol;

struct Shaken {
  boost::system::error_code client, server;
  std::string version, fingerprint;
};

Shaken shake_hands(asio::ssl::context& server_side, asio::ssl::context& client_side) {
  asio::io_context io;
  Local::socket a(io), b(io);
  asio::local::connect_pair(a, b);
  asio::ssl::stream<Local::socket> server(std::move(a), server_side), client(std::move(b), client_side);
  Shaken shaken;
  server.async_handshake(asio::ssl::stream_base::server, [&](const boost::system::error_code& e) {
    shaken.server = e;
    if (e) server.next_layer().close();
  });
  client.async_handshake(asio::ssl::stream_base::client, [&](const boost::system::error_code& e) {
    shaken.client = e;
    if (e) client.next_layer().close();
  });
  io.run();
  shaken.version = SSL_get_version(client.native_handle());
  shaken.fingerprint = peer_fingerprint(client.native_handle());
  return shaken;
}

TEST(Tls, TheClientSeesTheFingerprintOfTheServersCertificate) {
  const auto certificate = make_certificate();
  ASSERT_TRUE(certificate) << certificate.error();
  auto server = server_context(*certificate);
  auto client = client_context();
  const Shaken shaken = shake_hands(server, client);
  EXPECT_FALSE(shaken.client) << shaken.client.message();
  EXPECT_FALSE(shaken.server) << shaken.server.message();
  EXPECT_EQ(shaken.version, "TLSv1.3");
  EXPECT_EQ(shaken.fingerprint, fingerprint_of(certificate->certificate_pem));
}

TEST(Tls, FingerprintsLookAsSshPrintsThem) {
  const auto certificate = make_certificate();
  const auto other = make_certificate();
  const std::string text = fingerprint_of(certificate->certificate_pem).value();
  EXPECT_EQ(text.size(), std::string("SHA256:").size() + 43) << "32 bytes are 43 base64 digits without padding";
  EXPECT_TRUE(text.starts_with("SHA256:"));
  EXPECT_NE(text, fingerprint_of(other->certificate_pem).value());
}

TEST(Tls, OlderVersionsAreRefused) {
  const auto certificate = make_certificate();
  auto server = server_context(*certificate);
  asio::ssl::context old_client(asio::ssl::context::tlsv12_client);
  const Shaken shaken = shake_hands(server, old_client);
  EXPECT_TRUE(shaken.server);
  EXPECT_TRUE(shaken.client);
}

TEST(Tls, NoCertificateIsAnErrorWithAReason) {
  const auto fingerprint = fingerprint_of("not a certificate");
  ASSERT_FALSE(fingerprint);
  EXPECT_FALSE(fingerprint.error().empty());
}

}  // namespace
}  // namespace cnclab
