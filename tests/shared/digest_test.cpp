// SHA-256 against its published examples (FIPS 180-4), and what it proves about the beginning of a content.
#include "shared/digest.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace cnclab {
namespace {

std::string hex(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes)
    for (const int shift : {4, 0}) text += "0123456789abcdef"[(static_cast<unsigned char>(byte) >> shift) & 0xF];
  return text;
}

TEST(Digest, PublishedExamples) {
  EXPECT_EQ(hex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex(sha256(std::string(1'000'000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, ABeginningIsProvenByItsBytesOnly) {
  const struct {
    const char* name;
    std::uint64_t offset;
    std::string digest;
    bool is_proven;
  } rows[] = {
      {"the beginning", 3, sha256("abc"), true},
      {"all of it", 6, sha256("abcdef"), true},
      {"other bytes", 3, sha256("abd"), false},
      {"fewer than the digest's", 2, sha256("abc"), false},
      {"more than there are", 7, sha256("abcdefg"), false},
      {"far more", UINT64_MAX, sha256("abc"), false},
      {"nothing proves nothing", 0, sha256(""), false},
      {"no digest", 3, "", false},
      {"a piece of the digest", 3, sha256("abc").substr(0, 31), false},
  };
  for (const auto& row : rows) EXPECT_EQ(begins_with("abcdef", row.offset, row.digest), row.is_proven) << row.name;
}

}  // namespace
}  // namespace cnclab
