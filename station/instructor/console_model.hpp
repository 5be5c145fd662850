// What the console knows and what a key or a message does to it; no terminal, no network.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cnclab/v1/instructor.pb.h"
#include "shared/key.hpp"
#include "shared/screen.hpp"
#include "station/keymap.hpp"
#include "station/language.hpp"

namespace cnclab::instructor {

inline constexpr int kSeats = 15;
inline constexpr int kFirstSeatRow = 2;  ///< screen row of seat 1

/// The line to the server.
enum class Link : std::uint8_t { connected, lost };

/// What lies over the table of seats, or what is being asked.
enum class Overlay : std::uint8_t {
  none,
  help,
  ask_quit,
  ask_erase,  ///< whether somebody is to be deleted for good: the command waits in `asked_about`
  entry,      ///< a command is being typed, as on the command line
  page,       ///< an answer of several lines
  watching,   ///< a station's screen; with `is_typing` its keyboard too
};

/// A station's screen as it was sent last.
struct Watched {
  int station = 0;
  Screen screen;
  bool is_typing = false;  ///< its keyboard is taken over: keys go there
};

struct Message {
  std::string text;
  bool is_error = false;
  bool is_of_halt = false;  ///< true no longer than the halt lasts
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
  std::string entry;              ///< Overlay::entry: what has been typed, UTF-8
  std::vector<std::string> page;  ///< Overlay::page: lines
  int page_top = 0;               ///< first line shown
  Watched watched;
  bool is_too_small = false;                              ///< the window shows nothing of all this: only a stop acts
  std::optional<v1::InstructorRequest> asked_about = {};  ///< Overlay::ask_erase: sent with a yes
};

// What a user can do.
struct Typed {
  char32_t character = 0;
};
enum class Special : std::uint8_t { up, down, enter, halt, escape, backspace, give_back };
struct Clicked {
  int row = 0;
};
/// A character of pasted text, or a stop key in the midst of an escape sequence: text where a command is typed, else
/// only a stop key among them acts.
struct Pasted {
  char32_t character = 0;
};
/// A key that only a station's keyboard knows.
struct StationKey {
  station::Special key{};
};
using Input = std::variant<Typed, Special, Clicked, StationKey, Pasted>;

/// What a user's input leads to.
struct Reaction {
  ConsoleModel model;
  std::optional<v1::InstructorRequest> request;
  std::filesystem::path content_file = {};  ///< where the answer's content goes
  bool is_collection = false;               ///< as Command::is_collection
  std::filesystem::path sent_file = {};     ///< as Command::sent_file
  std::vector<Key> keys = {};               ///< pressed at the keyboard that is taken over
  bool is_urgent = false;  ///< goes before everything that waits to be sent (a stop is never queued, AUTH-006)
  bool quits = false;
};
[[nodiscard]] Reaction react(ConsoleModel model, const Input& input);

/// The input stops the machine, whatever lies over the table of seats (AUTH-006): MASCHINE HALT; STOP too, where a
/// keyboard is taken over.
[[nodiscard]] bool stops(const ConsoleModel& model, const Input& input);

/// A newer status: what it says is over is no longer told, and nobody types at a keyboard that was given back.
[[nodiscard]] ConsoleModel with_status(ConsoleModel model, const v1::Status& status);

/// The answer to a command of the user's: its error, or a sentence that says what was done, goes to the message line; a
/// list becomes a page.
[[nodiscard]] ConsoleModel with_answer(ConsoleModel model, const v1::InstructorRequest& request,
                                       const v1::InstructorAnswer& answer);

/// A new screen of the station that is watched.
[[nodiscard]] ConsoleModel with_screen(ConsoleModel model, const Screen& screen);
/// The line was lost and is there again: nothing is watched or typed any more.
[[nodiscard]] ConsoleModel with_line(ConsoleModel model, Link link);

/// Lines of a page that are shown at once.
inline constexpr int kPageLines = 15;

/// Input while an overlay lies over the table; nothing where it is to be handled as if there were none.
[[nodiscard]] std::optional<Reaction> react_overlaid(ConsoleModel& model, const Input& input);

/// The entry of `status` for a seat; nullptr where nobody is logged in.
[[nodiscard]] const v1::StationStatus* seat_of(const v1::Status& status, int seat);

}  // namespace cnclab::instructor
