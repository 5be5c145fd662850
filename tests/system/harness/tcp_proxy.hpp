// A network line with faults: a loopback proxy that can be cut, stalled and slowed down.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace cnclab::harness {

/// Forwards every connection to `127.0.0.1:target_port`. Runs a thread of its own; all functions may be called from
/// any thread and act at once.
class TcpProxy {
 public:
  explicit TcpProxy(std::uint16_t target_port);
  ~TcpProxy();
  TcpProxy(const TcpProxy&) = delete;
  TcpProxy& operator=(const TcpProxy&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] std::string address() const;  ///< "127.0.0.1:PORT"

  enum class Direction : std::uint8_t { to_server, to_client };

  /// Ends all connections and refuses new ones, until `mend`.
  void cut();
  /// As `cut`, by itself in the midst of what travels: once `bytes` more have been forwarded in that direction.
  void cut_after(Direction direction, std::uint64_t bytes);
  [[nodiscard]] bool is_cut() const;
  /// Keeps the connections but forwards nothing: silence, as behind a pulled cable; until `mend`.
  void stall();
  /// As `stall`, but only from the server to the client: the client's messages still arrive.
  void stall_answers();
  /// At most so many bytes per second and direction; 0 = as fast as it goes.
  void limit(std::uint32_t bytes_per_s);
  /// Back to normal; what was held back by `stall` is delivered now.
  void mend();

  /// Connections that were accepted since the start.
  [[nodiscard]] int accepted() const;
  /// Bytes that were forwarded in that direction since the start, TLS and all.
  [[nodiscard]] std::uint64_t forwarded(Direction direction) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::harness
