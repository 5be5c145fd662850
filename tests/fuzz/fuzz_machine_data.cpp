// Feeds any text to the reader of machine-data files: refused with a sentence, or values that are all allowed.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "machine/machine_data.hpp"

namespace machine = cnclab::machine;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = machine::read_machine_data({reinterpret_cast<const char*>(data), size});
  if (!read) {
    if (read.error().reason.empty()) std::abort();
    return 0;
  }
  std::string text;
  for (const auto& form : machine::datum_forms())
    text += std::to_string(form.number) + " = " + std::to_string(read->get(form.number)) + "\n";
  const auto again = machine::read_machine_data(text);
  if (!again || *again != *read) std::abort();
  return 0;
}
