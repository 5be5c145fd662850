// SHA-256 by OpenSSL.
#include "shared/digest.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace cnclab {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 failed");
  return {digest.begin(), digest.begin() + length};
}

bool begins_with(std::string_view content, std::uint64_t offset, std::string_view digest) {
  return offset > 0 && offset <= content.size() && sha256(content.substr(0, offset)) == digest;
}

}  // namespace cnclab
