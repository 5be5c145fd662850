// The lab's self-made certificate (P-256), its fingerprint, and TLS 1.3 contexts for both ends (SEC-001).
#include "shared/tls.hpp"

#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <memory>
#include <stdexcept>

namespace cnclab {
namespace {

namespace ssl = boost::asio::ssl;

template <auto free_it>
struct Freed {
  template <class T>
  void operator()(T* pointer) const {
    free_it(pointer);
  }
};
using KeyPtr = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using X509Ptr = std::unique_ptr<X509, Freed<X509_free>>;
using BioPtr = std::unique_ptr<BIO, Freed<BIO_free_all>>;

constexpr long kDay_s = 24L * 60 * 60;
constexpr long kValid_s = (20L * 365 + 5) * kDay_s;

std::string openssl_reason() {
  std::array<char, 256> text{};
  ERR_error_string_n(ERR_get_error(), text.data(), text.size());
  return text.data();
}

std::string content_of(BIO* memory) {
  const char* data = nullptr;
  const long length = BIO_get_mem_data(memory, &data);
  return {data, static_cast<std::size_t>(length)};
}

X509Ptr sign_certificate(EVP_PKEY* key) {
  X509Ptr certificate(X509_new());
  std::array<unsigned char, 16> serial{};
  if (!certificate || RAND_bytes(serial.data(), static_cast<int>(serial.size())) != 1) return nullptr;
  serial[0] &= 0x7FU;  // a serial number is positive
  const std::unique_ptr<BIGNUM, Freed<BN_free>> number(
      BN_bin2bn(serial.data(), static_cast<int>(serial.size()), nullptr));
  X509_set_version(certificate.get(), X509_VERSION_3);
  BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate.get()));
  // A day back: stations' clocks may be slow.
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -kDay_s);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), kValid_s);
  X509_NAME* name = X509_get_subject_name(certificate.get());
  const std::array<unsigned char, 7> cnclab = {'c', 'n', 'c', 'l', 'a', 'b', 0};
  X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, cnclab.data(), -1, -1, 0);
  X509_set_issuer_name(certificate.get(), name);
  X509_set_pubkey(certificate.get(), key);
  return X509_sign(certificate.get(), key, EVP_sha256()) > 0 ? std::move(certificate) : nullptr;
}

std::expected<std::string, std::string> fingerprint(const X509* certificate) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (X509_digest(certificate, EVP_sha256(), digest.data(), &length) != 1) return std::unexpected(openssl_reason());
  std::array<unsigned char, 2UL * EVP_MAX_MD_SIZE> base64{};
  const int characters = EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(length));
  std::string text(base64.begin(), base64.begin() + characters);
  text.erase(text.find_last_not_of('=') + 1);
  return "SHA256:" + text;
}

ssl::context tls13(ssl::context::method method) {
  ssl::context context(method);
  context.set_options(ssl::context::default_workarounds | ssl::context::no_compression);
  SSL_CTX* const handle = context.native_handle();
  if (SSL_CTX_set_min_proto_version(handle, TLS1_3_VERSION) != 1)
    throw std::runtime_error("TLS 1.3: " + openssl_reason());
  // Idle stations hold no record buffers; sessions are resumed by the lab's own tickets, not by TLS.
  SSL_CTX_set_mode(handle, SSL_MODE_RELEASE_BUFFERS);
  SSL_CTX_set_session_cache_mode(handle, SSL_SESS_CACHE_OFF);
  SSL_CTX_set_num_tickets(handle, 0);
  return context;
}

}  // namespace

std::expected<Certificate, std::string> make_certificate() {
  const KeyPtr key(EVP_EC_gen("P-256"));
  if (!key) return std::unexpected(openssl_reason());
  const X509Ptr certificate = sign_certificate(key.get());
  if (!certificate) return std::unexpected(openssl_reason());
  const BioPtr certificate_pem(BIO_new(BIO_s_mem()));
  const BioPtr key_pem(BIO_new(BIO_s_mem()));
  if (!certificate_pem || !key_pem || PEM_write_bio_X509(certificate_pem.get(), certificate.get()) != 1 ||
      PEM_write_bio_PKCS8PrivateKey(key_pem.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1) {
    return std::unexpected(openssl_reason());
  }
  return Certificate{content_of(certificate_pem.get()), content_of(key_pem.get())};
}

std::expected<std::string, std::string> fingerprint_of(const std::string& certificate_pem) {
  const BioPtr memory(BIO_new_mem_buf(certificate_pem.data(), static_cast<int>(certificate_pem.size())));
  const X509Ptr certificate(memory ? PEM_read_bio_X509(memory.get(), nullptr, nullptr, nullptr) : nullptr);
  if (!certificate) return std::unexpected(openssl_reason());
  return fingerprint(certificate.get());
}

ssl::context server_context(const Certificate& certificate) {
  ssl::context context = tls13(ssl::context::tlsv13_server);
  context.use_certificate_chain(boost::asio::buffer(certificate.certificate_pem));
  context.use_private_key(boost::asio::buffer(certificate.key_pem), ssl::context::pem);
  return context;
}

ssl::context client_context() {
  ssl::context context = tls13(ssl::context::tlsv13_client);
  // The certificate is its own authority; `peer_fingerprint` is what decides.
  context.set_verify_mode(ssl::verify_none);
  return context;
}

std::string peer_fingerprint(SSL* connection) {
  const X509Ptr certificate(SSL_get1_peer_certificate(connection));
  if (!certificate) return {};
  return fingerprint(certificate.get()).value_or("");
}

}  // namespace cnclab
