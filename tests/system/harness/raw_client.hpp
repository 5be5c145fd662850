// A client that need not keep to the rules: TLS bytes and protocol messages, sent as the test wants them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cnclab/v1/envelope.pb.h"
#include "harness/deadline.hpp"

namespace cnclab::harness {

/// One TLS connection to `127.0.0.1:port`. Throws Failure when it cannot be made. One thread.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  /// Bytes inside TLS, no frame around them; false when the line is closed.
  bool send_bytes(std::string_view bytes);
  /// A message in its frame.
  bool send(const v1::ClientMessage& message);
  /// The next message, beats included; nothing when the line is closed or the limit has passed.
  [[nodiscard]] std::optional<v1::ServerMessage> read(Milliseconds limit = 5s);
  /// Reads until a message of this kind comes; nothing as for `read`. Answers beats on the way.
  [[nodiscard]] std::optional<v1::ServerMessage> read_until(v1::ServerMessage::WhatCase kind, Milliseconds limit = 5s);
  /// Whether the server closes the line within the limit; what it sends meanwhile is read and dropped.
  [[nodiscard]] bool is_closed_within(Milliseconds limit);

  /// Hello with the given version, and the Welcome.
  [[nodiscard]] std::optional<v1::Welcome> greet(v1::ClientKind kind, std::uint32_t version = 1);
  /// Login, and its answer.
  [[nodiscard]] std::optional<v1::LoginAnswer> log_in(const std::string& user, const std::string& password,
                                                      std::uint32_t station);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::harness
