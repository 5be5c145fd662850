// What the console knows and what a key or a message does to it; no terminal, no network.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cnclab/v1/instructor.pb.h"
#include "station/language.hpp"

namespace cnclab::instructor {

inline constexpr int kSeats = 15;
inline constexpr int kFirstSeatRow = 2;  ///< screen row of seat 1

/// The line to the server.
enum class Link : std::uint8_t { connected, lost };

/// What lies over the table of seats, or what is being asked.
enum class Overlay : std::uint8_t { none, help, ask_quit };

struct Message {
  std::string text;
  bool is_error = false;
};

/// Everything that the console's screen shows.
struct ConsoleModel {
  station::Language language = station::Language::german;
  std::string server;  ///< HOST:PORT
  std::string user;
  Link link = Link::connected;
  int lost_for_s = 0;                ///< only where the line is lost
  std::optional<v1::Status> status;  ///< newest answer; kept while the line is lost, drawn as old
  int chosen = 1;                    ///< seat 1..15
  Overlay overlay = Overlay::none;
  Message message;
};

// What a user can do.
struct Typed {
  char32_t character = 0;
};
enum class Special : std::uint8_t { up, down, enter, halt, escape };
struct Clicked {
  int row = 0;
};
using Input = std::variant<Typed, Special, Clicked>;

/// What a user's input leads to.
struct Reaction {
  ConsoleModel model;
  std::optional<v1::InstructorRequest> request;
  bool is_urgent = false;  ///< goes before everything that waits to be sent (a stop is never queued, AUTH-006)
  bool quits = false;
};
[[nodiscard]] Reaction react(ConsoleModel model, const Input& input);

/// The answer to a command of the user's: its error or its detail goes to the message line.
[[nodiscard]] ConsoleModel with_answer(ConsoleModel model, const v1::InstructorRequest& request,
                                       const v1::InstructorAnswer& answer);

/// The entry of `status` for a seat; nullptr where nobody is logged in.
[[nodiscard]] const v1::StationStatus* seat_of(const v1::Status& status, int seat);

}  // namespace cnclab::instructor
