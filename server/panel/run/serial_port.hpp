// The control's socket for the serial line, and what goes on at it (EXT-040 to EXT-066, REMOTE).
//
// Who is at the other end, and whether a remote start may begin, is the lab's to know; which mode polls, what becomes
// of received text and when a run that "*" began is over is decided here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/path_item.hpp"
#include "machine/channel.hpp"
#include "panel/mode.hpp"
#include "transfer/serial_line.hpp"

namespace cnclab::panel {

/// How the configuration fits a control with a line ([dnc]).
struct LineFitting {
  bool is_fitted = false;  ///< keys 3, 5, 7 and 9 use it (DEC-36, DEC-62)
  bool is_paced = true;    ///< a real device has its own pace
  std::string binding{};   ///< what binds a TCP connection to this seat: "STATION 7 K3RT9-2QDXY"; empty: a device only
};

/// "PxxxxNxxx*" came and waits for the lab's word (EXT-060, AUTH-013).
struct RemoteStart {
  std::uint16_t program = 0, block = 0;
  std::int64_t came_ns = 0;  ///< when its last character had arrived, on the monotonic clock
};

/// Program and block that START on the screen EXTERNE DATEN has released for one remote start (AUTH-013).
struct Armed {
  static constexpr std::int64_t kValid_ns = 60'000'000'000;
  std::uint16_t program = 0, block = 0;
  machine::Epoch lease{};
  std::int64_t at_ns = 0;
};

struct SerialPort {
  LineFitting fitting;
  bool is_connected = false;  ///< somebody is at the other end
  transfer::SerialLine line{transfer::LineSpeed{}};

  /// What a key of EXTERNE DATEN wants of the line once somebody is at its other end.
  enum class Order : std::uint8_t { none, send, read } order = Order::none;
  std::string text_to_send;
  int programs_read = 0;  ///< since the order to read

  bool is_storing = false;            ///< the pending store is what the line has brought
  std::optional<RemoteStart> asked;   ///< waits for the lab's word
  bool has_handed_out_start = false;  ///< … and was handed to it
  bool runs = false;                  ///< "*" began the run that is present
  Mode return_to = Mode::menu;        ///< where that run goes back to
  geometry::SourceBlock current;      ///< what "!" names; program 0: the program last worked on
  std::vector<std::string> news;      ///< for the journal
};

}  // namespace cnclab::panel
