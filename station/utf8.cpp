// A line is UTF-8 if reading and writing it again changes no byte.
#include "station/utf8.hpp"

#include <algorithm>
#include <string>

#include "shared/screen.hpp"

namespace cnclab::station {

std::optional<int> line_not_utf8(std::string_view text) {
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size()));
    std::string again;
    for (const char32_t code : from_utf8(line)) again += to_utf8(code);
    if (again != line) return number;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return std::nullopt;
}

}  // namespace cnclab::station
