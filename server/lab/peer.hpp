// The far end of a connection as the lab sees it: something that takes messages and can be hung up.
#pragma once

#include <string>

namespace cnclab::v1 {
class ServerMessage;
}

namespace cnclab::lab {

class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  /// Queues a message; what waits is bounded, a peer that lets it overflow is hung up (SEC-005).
  virtual void send(const v1::ServerMessage& message) = 0;
  /// Ends the connection once what was sent before is out; `reason` is logged.
  virtual void hang_up(const std::string& reason) = 0;
  /// "127.0.0.1:40112", for delays and the log.
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace cnclab::lab
