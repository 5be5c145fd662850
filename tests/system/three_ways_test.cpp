// One picture, three ways: every key script of tests/panel/screens says what a control draws in process (test_panel
// holds it to that); here the same keys go through a real station, TLS, lab and database, and the same picture must
// come back to the station and, through ncurses, to a real terminal that looks on.
//
// One server and one terminal for all scripts, one new student for each; some twenty seconds for some twenty scripts.
// Time is real here: what a script says after `run` is waited for, and where it stops a movement at an arbitrary place
// figures are not compared (kTimed).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

constexpr int kSeat = 7;  // as on the scripts' pictures

struct Line {
  int number = 0;
  std::string command{}, rest{};
  std::vector<std::string> picture{};  ///< of `screen`
};

struct Script {
  std::string name{};
  std::vector<Line> lines{};
  std::string tape{};
  bool is_english = false;
};

/// What no station can be asked for: faults that a test injects, settings of another lab, the machine that is shared.
constexpr std::array kOnTheBench{"store", "damage", "memory", "lab", "data", "input", "media", "cassette", "hold"};
/// They stop a movement by hand: where it stops, nobody knows.
constexpr std::array kTimed{"15_stop_and_go_on", "16_hand", "17_istwert", "18_hand_input", "19_teach_in"};

bool is_in(const auto& names, const std::string& name) { return std::ranges::find(names, name) != names.end(); }

Script read(const std::filesystem::path& file) {
  Script script;
  script.name = file.stem().string();
  std::ifstream stream(file);
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    ++number;
    if (text.empty() || text.front() == '#') continue;
    const std::size_t blank = text.find(' ');
    Line line{number, text.substr(0, blank), blank == std::string::npos ? "" : text.substr(blank + 1)};
    if (line.command == "screen") {
      for (int row = 0; row < 24 && std::getline(stream, text); ++row, ++number) line.picture.push_back(text);
    }
    if (line.command == "load") script.tape += line.rest;
    if (line.command == "english") script.is_english = true;
    script.lines.push_back(std::move(line));
  }
  return script;
}

std::vector<Script> scripts(bool is_3250) {
  std::vector<Script> found;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(CNCLAB_TEST_DATA) / "../panel/screens")) {
    Script script = read(entry.path());
    const auto has = [&](const auto& asked) { return std::ranges::any_of(script.lines, asked); };
    if (has([](const Line& line) { return is_in(kOnTheBench, line.command); })) continue;
    if (has([](const Line& line) { return line.command == "model"; }) == is_3250) found.push_back(std::move(script));
  }
  std::ranges::sort(found, {}, &Script::name);
  return found;
}

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// Plays one script at a seat; the terminal looks on.
class Playing {
 public:
  Playing(Classroom& room, Terminal& terminal, const Script& script)
      : terminal_(terminal), seat_(room.seat(kSeat, script.name)), hides_figures_(is_in(kTimed, script.name)) {}

  void play(const Line& line) {
    if (line.command == "keys") return seat_.key(line.rest);
    if (line.command == "type") return seat_.type(line.rest);
    if (line.command == "pot") return seat_.expect_ok("pot " + line.rest);
    if (line.command == "rest") return seat_.wait_gone("START    ●", 60s);
    if (line.command == "until") return seat_.wait_for(line.rest, 20s);
    if (line.command == "marks") return compare_marks(line.rest);
    if (line.command == "monitor" || line.command == "row") return compare_row(line);
    if (line.command == "screen") return compare_picture(line);
    if (line.command == "run") return wait_for_motion();
    const bool is_elsewhere = line.command == "clock" || line.command == "beeps" || line.command == "load" ||
                              line.command == "english" || line.command == "model";
    EXPECT_TRUE(is_elsewhere) << "unknown line " << line.command;
  }

  /// The terminal has the station's picture, but for what tells that it only looks on: in the frame and in place of the
  /// keys of row 23.
  void compare_terminal() {
    constexpr int kKeysRow = 23;
    ScreenRows there, here;
    const auto both = [&] { return std::pair(comparable(there), comparable(here)); };
    static_cast<void>(eventually(5s, [&] {
      terminal_.update();
      there.clear();
      for (int row = 0; row < kKeysRow; ++row) there.push_back(terminal_.row(row));
      here = seat_.screen();
      here.pop_back();
      const std::string& side = there.front();
      there.front() =
          here.front().substr(0, here.front().find("┐")) + side.substr(std::min(side.find("┐"), side.size()));
      return both().first == both().second;
    }));
    EXPECT_EQ(both().first, both().second) << "in the terminal, at the station";
    EXPECT_TRUE(terminal_.row(0).starts_with("┌─ Nur zusehen: Platz 7 ─")) << terminal_.row(0);
    EXPECT_TRUE(terminal_.row(kKeysRow).starts_with(" Nur zusehen: ")) << terminal_.row(kKeysRow);
  }

  void leave() { seat_.quit(); }

 private:
  /// Where axes move the picture becomes another one.
  void wait_for_motion() {
    if (!seat_.shows("START    ●")) return;
    const ScreenRows before = without_clock(seat_.screen());
    static_cast<void>(eventually(5s, [&] { return without_clock(seat_.screen()) != before; }));
  }

  /// As it can be compared: the clock also stands among the machine data.
  [[nodiscard]] std::string shown(std::string text) const {
    const auto holds = [&](const char* part) { return text.find(part) != std::string::npos; };
    if (hides_figures_ || holds("CNC 3") || holds("HH MM SS") || holds("JJ MM TT"))
      std::ranges::replace_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; }, '0');
    return text;
  }

  /// Clock, student and holder of the shared machine are others here.
  [[nodiscard]] std::vector<std::string> comparable(ScreenRows rows) const {
    constexpr int kName = 1, kHolder = 6;
    rows = without_clock(std::move(rows));
    for (const int row : {kName, kHolder}) {
      std::string& text = rows.at(static_cast<std::size_t>(row));
      text.erase(text.rfind("│") + std::string_view("│").size());
    }
    for (std::string& row : rows) row = shown(trimmed(row));
    return rows;
  }

  void compare_row(const Line& line) {
    const int index = std::stoi(line.rest);
    const std::size_t blank = line.rest.find(' ');
    const std::string expected = shown(blank == std::string::npos ? "" : line.rest.substr(blank + 1));
    std::string seen;
    static_cast<void>(eventually(5s, [&] {
      const ScreenRows rows = seat_.screen();
      seen = line.command == "row" ? trimmed(rows.at(static_cast<std::size_t>(index))) : monitor_row(rows, index + 1);
      return (seen = shown(seen)) == expected;
    }));
    EXPECT_EQ(seen, expected);
  }

  void compare_marks(const std::string& expected) {
    std::string joined;
    static_cast<void>(eventually(5s, [&] {
      joined.clear();
      for (const std::string& mark : seat_.marks()) joined += (joined.empty() ? "" : ", ") + mark;
      return joined == expected;
    }));
    EXPECT_EQ(joined, expected);
  }

  void compare_picture(const Line& line) {
    ScreenRows seen;
    static_cast<void>(eventually(5s, [&] { return comparable(seen = seat_.screen()) == comparable(line.picture); }));
    EXPECT_EQ(comparable(seen), comparable(line.picture));
    compare_terminal();
  }

  Terminal& terminal_;
  StationProcess seat_;
  bool hides_figures_;
};

/// A student with the script's language and programs.
void enrol(Classroom& room, const Script& script) {
  const auto roster = room.folder().write("roster.csv", "name,password,language\n" + script.name + "," +
                                                            room.passwords().password_of(script.name) + "," +
                                                            (script.is_english ? "en" : "de") + "\n");
  room.instructor().must({"import", roster.string()});
  if (script.tape.empty()) return;
  room.instructor().must({"program", "send", room.folder().write("tape", script.tape).string(), script.name});
}

/// All scripts for one model, in one classroom.
void play_all(Classroom& room, const std::vector<Script>& all) {
  StationOptions options = room.station_options(0, "lehrer");
  options.more = {"--observe", std::to_string(kSeat)};
  Terminal terminal({.program = programs_folder() / "cnclab-station",
                     .arguments = station_arguments(options),
                     .environment = {{"XDG_STATE_HOME", (room.folder().path() / "state").string()}},
                     .rows = 24,
                     .columns = 80});
  for (const Script& script : all) {
    SCOPED_TRACE(script.name);
    enrol(room, script);
    Playing playing(room, terminal, script);
    for (const Line& line : script.lines) {
      SCOPED_TRACE(script.name + ":" + std::to_string(line.number) + ": " + line.command + " " + line.rest);
      playing.play(line);
    }
    playing.compare_terminal();
    playing.leave();
  }
}

TEST(ThreeWays, the_picture_in_process_is_the_stations_and_the_terminals) {
  Classroom room;
  const auto all = scripts(false);
  EXPECT_GE(all.size(), 16U) << "the scripts are not found";
  play_all(room, all);
}

TEST(ThreeWays, MODEL_the_3250_as_well) {
  Classroom room("[control]\nmodel = \"3250\"\n");
  const auto all = scripts(true);
  EXPECT_GE(all.size(), 2U);
  play_all(room, all);
}

}  // namespace
}  // namespace cnclab::harness
