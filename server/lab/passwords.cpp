// Argon2id hashes, made and compared one at a time.
#include "lab/passwords.hpp"

#include <sodium.h>

#include <array>
#include <new>
#include <stdexcept>
#include <string_view>

#include "lab/worker_thread.hpp"

namespace cnclab::lab {

namespace {

constexpr unsigned long long kPasses = 2;
constexpr std::size_t kMemory_bytes = 19ULL * 1024 * 1024;

void start_sodium() {
  if (sodium_init() < 0) throw std::runtime_error("libsodium cannot be started: no source of random numbers");
}

/// In groups of four, none of them alike to another.
std::string random_letters(int count) {
  start_sodium();
  constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789";
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0 && i % 4 == 0) text += '-';
    text += kLetters[randombytes_uniform(static_cast<std::uint32_t>(kLetters.size()))];
  }
  return text;
}

bool fits(const std::string& password, const std::string& hash) {
  return crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

}  // namespace

std::string one_time_password() { return random_letters(16); }

std::string line_token() { return random_letters(12); }

std::string random_ticket() {
  start_sodium();
  std::string ticket(32, '\0');
  randombytes_buf(ticket.data(), ticket.size());
  return ticket;
}

std::string hash_password(const std::string& password) {
  start_sodium();
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  if (crypto_pwhash_str_alg(hash.data(), password.data(), password.size(), kPasses, kMemory_bytes,
                            crypto_pwhash_ALG_ARGON2ID13) != 0)
    throw std::bad_alloc();
  return hash.data();
}

struct PasswordWorker::Impl {
  explicit Impl(db::Post to_lab) : post(std::move(to_lab)), nobody(hash_password("nobody")) {}

  db::Post post;
  std::string nobody;  ///< compared with when there is no such name
  WorkerThread thread;
};

PasswordWorker::PasswordWorker(db::Post post) : impl_(std::make_unique<Impl>(std::move(post))) {}
PasswordWorker::~PasswordWorker() = default;

void PasswordWorker::verify(std::string password, std::string hash, std::function<void(bool)> done) {
  impl_->thread.enqueue([this, password = std::move(password), hash = std::move(hash), done = std::move(done)] {
    const bool known = !hash.empty();
    const bool same = fits(password, known ? hash : impl_->nobody) && known;
    impl_->post([done, same] { done(same); });
  });
}

void PasswordWorker::hash(std::string password, std::function<void(std::string)> done) {
  impl_->thread.enqueue([this, password = std::move(password), done = std::move(done)] {
    impl_->post([done, hash = hash_password(password)] { done(hash); });
  });
}

}  // namespace cnclab::lab
