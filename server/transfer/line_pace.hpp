// The speed of a serial line: characters of 10 bits (EXT-043) that are there when their time has come (EXT-045).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "transfer/time.hpp"

namespace cnclab::transfer {

/// MD 20: 300, 600, 1200, 2400 or 4800. Unpaced lines (a real device has its own pace) pass everything on at once.
struct LineSpeed {
  int baud = 1200;
  bool is_paced = true;
  /// How long one character lasts; 0 where the line is not paced.
  [[nodiscard]] Time per_character() const;
};

[[nodiscard]] bool is_line_speed(long baud);

/// Characters on their way in one direction.
class LinePace {
 public:
  explicit LinePace(LineSpeed speed) : speed_(speed) {}

  /// From the next character on.
  void set_speed(LineSpeed speed) { speed_ = speed; }

  /// Puts characters on the line at `now`, behind those that are on their way.
  void put(std::string_view bytes, Time now);
  /// When the next character has arrived; nothing where none is on its way.
  [[nodiscard]] std::optional<Time> due() const;
  /// The next character. Call it only when one is on its way.
  char take();
  [[nodiscard]] std::size_t waiting() const { return bytes_.size() - taken_; }
  void clear();

 private:
  LineSpeed speed_;
  std::string bytes_;
  std::size_t taken_ = 0;  ///< of bytes_
  Time due_{};             ///< of the next one, where there is one; else the end of the last
};

}  // namespace cnclab::transfer
