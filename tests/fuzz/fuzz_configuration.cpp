// Feeds any text to the reader of lab.toml: refused with a sentence, or read; what was read is printed and read again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "configuration_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = cnclab::parse_configuration({reinterpret_cast<const char*>(data), size});
  if (!read) {
    if (read.error().empty()) std::abort();
    return 0;
  }
  const std::string printed = cnclab::print_configuration(*read);
  const auto again = cnclab::parse_configuration(printed);
  if (!again || cnclab::print_configuration(*again) != printed) std::abort();
  return 0;
}
