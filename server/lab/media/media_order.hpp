// What a desk has ordered to be written, read or printed at its station.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lab/media/media_transfer.hpp"

namespace cnclab::lab {

/// It is answered once the files have travelled and the printer has taken the pages.
struct MediaOrder {
  enum class From : std::uint8_t { control, hardcopy };
  From from = From::control;
  std::optional<MediaTransfer> transfer{};  ///< nothing: the files have travelled, or do not travel
  bool is_printing = false;                 ///< the printer has not answered
  std::string read{};                       ///< what came from the station
  std::string problem{};                    ///< the first sentence that there is about it

  [[nodiscard]] bool is_over() const { return !transfer && !is_printing; }
};

}  // namespace cnclab::lab
