// TLS 1.3 for both ends: the server's own certificate, and its fingerprint that stations pin (SEC-001).
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <expected>
#include <string>

namespace cnclab {

/// A self-made certificate and its key, PEM.
struct Certificate {
  std::string certificate_pem, key_pem;
};

/// Makes an Ed25519 or P-256 certificate for "cnclab", valid for 20 years. errors: OpenSSL's reason.
[[nodiscard]] std::expected<Certificate, std::string> make_certificate();

/// "SHA256:" and the unpadded base64 of the certificate's DER digest, as ssh prints keys.
[[nodiscard]] std::expected<std::string, std::string> fingerprint_of(const std::string& certificate_pem);

/// Server side: TLS 1.3 only.
[[nodiscard]] boost::asio::ssl::context server_context(const Certificate& certificate);
/// Client side: TLS 1.3 only; the certificate is judged by its fingerprint, see `peer_fingerprint`.
[[nodiscard]] boost::asio::ssl::context client_context();
/// Fingerprint of the certificate that the other end of a finished handshake showed; empty where it showed none.
[[nodiscard]] std::string peer_fingerprint(SSL* connection);

}  // namespace cnclab
