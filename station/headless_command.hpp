// One line of the headless protocol, read into a value (interfaces.md section 3).
#pragma once

#include <chrono>
#include <expected>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shared/key.hpp"
#include "station/language.hpp"

namespace cnclab::station {

/// Keys that go down and up together; one key is a chord of one.
using Chord = std::vector<Key>;
inline constexpr std::size_t kLargestChord = 3;

struct PressCommand {
  std::vector<Chord> chords;  ///< one after the other
};
struct HoldCommand {
  std::chrono::milliseconds duration;  ///< 0..600 000
  Chord chord;
};
struct PotCommand {
  std::uint32_t percent;  ///< 0..100
};
struct ScreenCommand {};
struct MarksCommand {};
struct WaitCommand {
  std::chrono::milliseconds limit;
  std::string text;
  bool until_present;  ///< `wait`; false for `gone`
};
struct QuitCommand {};

using HeadlessCommand =
    std::variant<PressCommand, HoldCommand, PotCommand, ScreenCommand, MarksCommand, WaitCommand, QuitCommand>;

/// errors: the message behind `error `, naming what is wrong.
[[nodiscard]] std::expected<HeadlessCommand, std::string> parse_headless(std::string_view line, Language language);

/// A chord of one to three known keys, e.g. "ENTER+RESET"; empty otherwise.
[[nodiscard]] Chord chord_of(std::string_view name);

}  // namespace cnclab::station
