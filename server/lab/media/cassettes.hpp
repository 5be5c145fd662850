// The cassettes of one person on their way between database and recorder (DEC-33): which lies in the recorder, and
// what of it is to be saved.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "db/types.hpp"
#include "language/units.hpp"
#include "panel/control.hpp"

namespace cnclab::lab {

/// As it is read at login and after each change of the list.
struct StoredCassettes {
  std::vector<db::StoredCassette> list{};  ///< by name
  std::optional<std::string> tape{};       ///< of the one in the recorder
};

// What the student wants of them (key LABOR).
struct NewCassette {};
struct InsertCassette {
  db::CassetteId id{};
};
struct EjectCassette {};
struct RenameCassette {
  db::CassetteId id{};
  int number = 0;  ///< 0..99
};
struct RemoveCassette {
  db::CassetteId id{};
};
struct PressRecorder {
  panel::Control::RecorderKey key{};
};
using CassetteWish =
    std::variant<NewCassette, InsertCassette, EjectCassette, RenameCassette, RemoveCassette, PressRecorder>;

/// "K07": the keyboard has no letters.
[[nodiscard]] std::string cassette_name(int number);
/// The first name of K01, K02, … that none has.
[[nodiscard]] std::string free_cassette_name(const std::vector<db::StoredCassette>& list);
/// "K07   12 KB  im Rekorder, Zähler 005"; `deck` is the cassette in the recorder.
[[nodiscard]] std::string cassette_line(const db::StoredCassette& cassette,
                                        const std::optional<transfer::Cassette>& deck, language::Tongue tongue);

/// What a desk knows of them.
struct CassetteShelf {
  std::vector<db::StoredCassette> list{};
  std::optional<db::CassetteId> inserted{};
  bool is_changed = false;  ///< the tape, since it was saved
  bool has_run = false;     ///< the motor, when it was looked at last
};

}  // namespace cnclab::lab
