// Random passwords in files of their own, as the programs take them.
#include "harness/passwords.hpp"

#include <random>
#include <string_view>

namespace cnclab::harness {
namespace {

std::string random_password() {
  constexpr std::string_view kLetters = "abcdefghijkmnopqrstuvwxyzABCDEFGHJKLMNPQRSTUVWXYZ23456789";
  constexpr int kLength = 20;
  std::random_device source;
  std::uniform_int_distribution<std::size_t> choose(0, kLetters.size() - 1);
  std::string password;
  for (int i = 0; i < kLength; ++i) password += kLetters[choose(source)];
  return password;
}

}  // namespace

std::string Passwords::password_of(const std::string& name) {
  if (!passwords_.contains(name)) set(name, random_password());
  return passwords_.at(name);
}

std::filesystem::path Passwords::file_of(const std::string& name) {
  static_cast<void>(password_of(name));
  return folder_.path() / name;
}

std::filesystem::path Passwords::set(const std::string& name, const std::string& password) {
  passwords_[name] = password;
  return folder_.write(name, password + "\n");
}

}  // namespace cnclab::harness
