// A serial line as the lab sees it: somebody with a socket or a device at one end, a station's control at the other.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "lab/desk.hpp"

namespace cnclab::lab {

/// The end that carries bytes: a TCP connection or a serial device (server/net/serial_*).
class LinePeer {
 public:
  LinePeer() = default;
  LinePeer(const LinePeer&) = delete;
  LinePeer& operator=(const LinePeer&) = delete;
  virtual ~LinePeer() = default;

  /// Bytes of the control, to be passed on as they are.
  virtual void send(std::string bytes) = 0;
  /// Characters that wait to be passed on; while they are many the control keeps the others.
  [[nodiscard]] virtual std::size_t unsent() const = 0;
  /// MD 20, for those who have a speed of their own.
  virtual void set_baud(int baud) = 0;
  /// No more bytes; `reason` is logged. A device stays open for the next student.
  virtual void hang_up(const std::string& reason) = 0;
  /// "127.0.0.1:40112", "/dev/ttyUSB0".
  [[nodiscard]] virtual std::string address() const = 0;
};

/// A line that belongs to a station: over TCP to one login there, as a device to whoever sits there.
struct DncLine {
  std::shared_ptr<LinePeer> peer;
  int station = 0;
  bool is_device = false;
  std::weak_ptr<Desk> desk;  ///< whose control it is connected to; empty: nobody's
  int baud = 0;              ///< that the peer was told last
};

}  // namespace cnclab::lab
