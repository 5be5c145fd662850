// Feeds any bytes to the serial line, as a sender that keeps to nothing: the first byte chooses mode, speed and
// answers, every 00H..1FH among the others lets that many milliseconds pass too; 1CH to 1FH hold, release and cut the
// line. Texts go on to the tape reader.
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "language/tape.hpp"
#include "transfer/binding_line.hpp"
#include "transfer/punched_tape.hpp"
#include "transfer/serial_line.hpp"

namespace transfer = cnclab::transfer;
namespace language = cnclab::language;

namespace {

void require(bool is_right) {
  if (!is_right) std::abort();
}

struct Talk {
  transfer::SerialLine line;
  bool accepts;
  transfer::Time now{0};

  void pass(transfer::Time time) {
    now += time;
    while (const auto event = line.advance(now, {})) {
      if (const auto* text = std::get_if<transfer::TextReceived>(&*event)) {
        require(text->text.size() <= transfer::kLineBuffer + 5);
        static_cast<void>(language::read_tape(text->text, language::Reading::strict));
      }
      accepts ? line.accept() : line.refuse();
    }
    for (const char byte : line.take_output(now)) require(std::popcount(static_cast<unsigned char>(byte)) % 2 == 0);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  static_cast<void>(transfer::parse_binding(bytes));
  static_cast<void>(language::read_tape(transfer::read_punched(bytes), language::Reading::strict));
  static_cast<void>(transfer::twin_text(bytes));
  if (size == 0) return 0;
  Talk talk{.line = transfer::SerialLine({.baud = 4800, .is_paced = (data[0] & 1U) != 0}),
            .accepts = (data[0] & 2U) != 0};
  (data[0] & 4U) != 0 ? talk.line.begin_remote(1, talk.now) : talk.line.begin_reading(talk.now);
  for (const char byte : bytes.substr(1)) {
    static_cast<void>(talk.line.receive({&byte, 1}, talk.now));
    const auto code = static_cast<unsigned char>(byte);
    if (code < 0x20) talk.pass(std::chrono::milliseconds(code));
    if (code == 0x1C) talk.line.hold(talk.now);
    if (code == 0x1D) talk.line.go_on(talk.now);
    if (code == 0x1E) talk.line.run_ended(talk.now);
    if (code == 0x1F && (data[0] & 8U) != 0) talk.line.cut(talk.now);
  }
  talk.pass(std::chrono::hours(1));
  talk.line.stop(talk.now);
  return 0;
}
