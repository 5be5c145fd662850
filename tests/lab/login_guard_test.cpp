// Growing delays after wrong passwords; beats and their age.
#include "lab/login_guard.hpp"

#include <gtest/gtest.h>

#include "lab/beats.hpp"
#include "lab/clock.hpp"
#include "lab/passwords.hpp"

namespace cnclab::lab {
namespace {

TEST(LoginGuard, SEC_003_FiveTriesAreFreeThenTheDelayDoublesUpToThirtySeconds) {
  LoginGuard guard;
  std::int64_t now = 0;
  const int expected[] = {0, 0, 0, 0, 1, 2, 4, 8, 16, 30, 30};
  for (const int wait : expected) {
    guard.failed("eva", "127.0.0.1:1", now);
    EXPECT_EQ(guard.wait_seconds("eva", "10.0.0.9:1", now), wait);
    now += 60 * kSecond_ns;
  }
}

TEST(LoginGuard, SEC_003_ADelayEndsByTimeOrByTheRightPassword) {
  LoginGuard guard;
  for (int i = 0; i < 6; ++i) guard.failed("eva", "127.0.0.1:1", 0);
  EXPECT_EQ(guard.wait_seconds("eva", "127.0.0.1:1", 0), 2);
  EXPECT_EQ(guard.wait_seconds("eva", "127.0.0.1:1", 2 * kSecond_ns), 0);
  guard.succeeded("eva");
  guard.failed("eva", "127.0.0.1:1", 3 * kSecond_ns);
  EXPECT_EQ(guard.wait_seconds("eva", "127.0.0.1:1", 3 * kSecond_ns), 0);
}

TEST(LoginGuard, SEC_003_NamesDoNotDelayEachOtherAndMemoryIsBounded) {
  LoginGuard guard;
  for (int i = 0; i < 10; ++i) guard.failed("eva", "127.0.0.1:1", 0);
  EXPECT_EQ(guard.wait_seconds("udo", "127.0.0.1:1", 0), 0);
  for (std::size_t i = 0; i < 3 * LoginGuard::kMostEntries; ++i)
    guard.failed("name" + std::to_string(i), "127.0.0.1:1", static_cast<std::int64_t>(i));
  EXPECT_GT(guard.wait_seconds("x", "127.0.0.1:7", 0), 0) << "an address that tries thousands of names is slowed down";
}

TEST(LoginGuard, SEC_003_ARightPasswordOfOneNameForgivesTheAddressNothing) {
  LoginGuard guard;
  const auto try_names = [&](int from, int to) {
    for (int i = from; i < to; ++i) guard.failed("name" + std::to_string(i), "10.0.0.1:1", 0);
  };
  try_names(0, LoginGuard::kFreeTriesOfAddress - 1);
  EXPECT_EQ(guard.wait_seconds("eva", "10.0.0.1:2", 0), 0);
  guard.succeeded("eva");
  try_names(100, 101);
  EXPECT_EQ(guard.wait_seconds("eva", "10.0.0.1:2", 0), 1);
}

TEST(LoginGuard, SEC_003_AnAddressIsForgivenOneWrongPasswordAMinute) {
  LoginGuard guard;
  for (int i = 0; i < LoginGuard::kFreeTriesOfAddress; ++i) guard.failed("n" + std::to_string(i), "10.0.0.1:1", 0);
  EXPECT_EQ(guard.wait_seconds("x", "10.0.0.1:1", 0), 1);
  const std::int64_t later_ns = 2 * LoginGuard::kForgivenEach_s * kSecond_ns;
  guard.failed("y", "10.0.0.1:1", later_ns);
  EXPECT_EQ(guard.wait_seconds("x", "10.0.0.1:1", later_ns), 0) << "two forgiven, one more";
  guard.failed("z", "10.0.0.1:1", later_ns);
  EXPECT_EQ(guard.wait_seconds("x", "10.0.0.1:1", later_ns), 1);
}

TEST(Beats, AUTH_007_AgeIsKnownForSixSecondsAndNeverForWhatWasNotSent) {
  Beats beats;
  EXPECT_TRUE(beats.advance(100));
  EXPECT_FALSE(beats.advance(100 + Beats::kPeriod_ns - 1));
  EXPECT_TRUE(beats.advance(100 + Beats::kPeriod_ns));
  EXPECT_EQ(beats.sent_ns(1), 100);
  EXPECT_EQ(beats.sent_ns(2), 100 + Beats::kPeriod_ns);
  EXPECT_FALSE(beats.sent_ns(0));
  EXPECT_FALSE(beats.sent_ns(3));
  for (int i = 0; i < 200; ++i) beats.advance(i * kSecond_ns + kSecond_ns);
  EXPECT_FALSE(beats.sent_ns(1)) << "forgotten beats give no age, so they renew nothing";
}

TEST(Passwords, SEC_002_HashesAreArgon2idAndOneTimePasswordsDiffer) {
  const std::string hash = hash_password("geheim-geheim");
  EXPECT_EQ(hash.rfind("$argon2id$v=19$m=19456,t=2,p=1$", 0), 0U) << hash;
  EXPECT_NE(hash_password("geheim-geheim"), hash) << "salted";
  EXPECT_NE(one_time_password(), one_time_password());
  EXPECT_EQ(one_time_password().size(), 19U);
}

}  // namespace
}  // namespace cnclab::lab
