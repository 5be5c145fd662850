// A server of another protocol version: TLS with a certificate of its own, and a Welcome that accepts nobody.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace cnclab::harness {

/// Listens on a loopback port; answers every Hello with the supported version 999 and closes. A thread of its own.
class FakeServer {
 public:
  explicit FakeServer(std::uint16_t port = 0);  ///< 0: any free one
  ~FakeServer();
  FakeServer(const FakeServer&) = delete;
  FakeServer& operator=(const FakeServer&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] std::string address() const;  ///< "127.0.0.1:PORT"
  [[nodiscard]] const std::string& fingerprint() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::harness
