// The serial lines of a lab and the stations that they belong to (interfaces.md section 8). What a computer at a line
// may start is not judged here (dnc_start.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lab/clock.hpp"
#include "lab/configuration.hpp"
#include "lab/journal_book.hpp"
#include "lab/login_guard.hpp"
#include "lab/media/dnc_line.hpp"
#include "lab/seats.hpp"
#include "transfer/binding_line.hpp"

namespace cnclab::lab {

/// Lab thread.
class SerialLines {
 public:
  using DeskPtr = std::shared_ptr<Desk>;
  using LinePtr = std::shared_ptr<DncLine>;

  /// All of them outlive the lines.
  SerialLines(const Configuration& configuration, const Clock& clock, JournalBook& journal, const Seats& seats);

  // For those who carry the bytes (server/net/serial_*)
  /// The first line of a TCP connection: it becomes the line of that station's login.
  /// errors   why not, for the log; journalled
  [[nodiscard]] std::expected<LinePtr, std::string> bind(const std::shared_ptr<LinePeer>& peer,
                                                         const transfer::Binding& binding);
  /// A connection ended before it was bound; journalled.
  void refuse(const std::string& address, const std::string& why);
  /// The serial device was opened: it belongs to whoever sits at its station.
  [[nodiscard]] LinePtr attach_device(const std::shared_ptr<LinePeer>& peer);
  /// Returns how many characters were taken; the others are to be brought again when there is room.
  [[nodiscard]] std::size_t received(const LinePtr& line, std::string_view bytes);
  /// Has everything that was received had its effect, and everything that is to be sent left the control?
  [[nodiscard]] bool is_idle(const LinePtr& line) const;
  /// The connection is closed, the device is gone.
  void lost(const LinePtr& line);

  // For the lab
  /// When somebody sits down: the control is told of its line and of the REMOTE switch.
  void fit(Desk& desk, bool is_new_login);
  /// The REMOTE switch of a station.
  void set_remote(int station, bool is_on, const std::string& who);
  /// The login has ended.
  void cut_of(const Desk& desk);
  /// Bytes on their way; to be called again and again.
  void follow(std::int64_t now_ns);
  /// The line that the desk's control is connected to; nullptr: none.
  [[nodiscard]] LinePtr of(const Desk& desk) const;

 private:
  [[nodiscard]] panel::LineFitting fitting(const Desk& desk) const;
  void connect(DncLine& line, const DeskPtr& desk);  ///< nullptr: to nobody
  [[nodiscard]] panel::Now time_of(const Desk& desk) const;

  const Configuration& configuration_;
  const Clock& clock_;
  JournalBook& journal_;
  const Seats& seats_;
  LoginGuard guard_;  ///< of its own: wrong tokens delay no login
  std::vector<LinePtr> lines_;
  std::array<bool, 16> remote_{};  ///< the REMOTE switch of each station, from 1
};

}  // namespace cnclab::lab
