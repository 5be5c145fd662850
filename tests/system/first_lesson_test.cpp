// docs/first-lesson.md is true: its keys are pressed at a real station, its screens are what stands there.
//
//   ```form        the login form in a terminal, before anything is typed
//   ```keys        commands of the headless protocol (interfaces.md 3), each answered by "ok"
//   ```screen      the 24 rows now, blanks at the ends of rows left out; the clock is not compared
//   ```instructor  one-shot commands of the instructor
//
// CNCLAB_REDRAW=1 writes the page anew with the screens that were seen, for review.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

/// A stretch of the page: prose (no kind), or a fenced block.
struct Part {
  std::string kind{};
  std::vector<std::string> lines{};
};

std::filesystem::path page() { return std::filesystem::path(CNCLAB_TEST_DATA) / "../../docs/first-lesson.md"; }

std::vector<Part> parts_of(std::istream& stream) {
  std::vector<Part> parts(1);
  for (std::string line; std::getline(stream, line);) {
    const bool is_fence = line.starts_with("```");
    if (is_fence && parts.back().kind.empty()) {
      parts.push_back({line.substr(3), {}});
    } else if (is_fence) {
      parts.emplace_back();
    } else {
      parts.back().lines.push_back(line);
    }
  }
  return parts;
}

std::vector<std::string> trimmed(ScreenRows rows) {
  for (std::string& row : rows) row.erase(row.find_last_not_of(' ') + 1);
  return rows;
}

/// Both as the page has them and without what is different each time.
std::vector<std::string> comparable(const ScreenRows& rows) { return trimmed(without_clock(rows)); }

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

class FirstLesson : public testing::Test {
 protected:
  FirstLesson() { room_.add_student("schueler01"); }

  ScreenRows form_rows() {
    StationOptions options = room_.station_options(0, "schueler01");
    options.user.clear();
    options.password_file.clear();
    Terminal terminal({.program = programs_folder() / "cnclab-station",
                       .arguments = station_arguments(options),
                       .environment = {{"XDG_STATE_HOME", (room_.folder().path() / "state").string()}},
                       .rows = 24,
                       .columns = 80});
    terminal.wait_for("Tab");
    ScreenRows rows;
    for (int row = 0; row < 24; ++row) rows.push_back(terminal.row(row));
    return rows;
  }

  /// Compares as soon as the rows are right, at the latest after 5 s; gives what stands there.
  ScreenRows compare(StationProcess& seat, const std::vector<std::string>& expected) {
    ScreenRows seen = seat.screen();
    if (is_redrawn_) return seen;
    static_cast<void>(eventually(5s, [&] { return comparable(seen = seat.screen()) == comparable(expected); }));
    EXPECT_EQ(comparable(seen), comparable(expected));
    return seen;
  }

  void play(Part& part, std::optional<StationProcess>& at_seat) {
    if (part.kind == "form") {
      const ScreenRows seen = form_rows();
      if (is_redrawn_) part.lines = trimmed(seen);
      EXPECT_EQ(trimmed(seen), part.lines);
      return;
    }
    if (!at_seat) at_seat.emplace(room_.seat(1, "schueler01"));
    StationProcess& seat = *at_seat;
    if (part.kind == "keys") {
      for (const std::string& line : part.lines) seat.expect_ok(line, 40s);
    } else if (part.kind == "instructor") {
      for (const std::string& line : part.lines) room_.instructor().must(words_of(line));
    } else if (part.kind == "screen") {
      const ScreenRows seen = compare(seat, part.lines);
      if (is_redrawn_) part.lines = trimmed(seen);
    } else {
      FAIL() << "a block that nobody plays: " << part.kind;
    }
  }

  Classroom room_;
  bool is_redrawn_ = std::getenv("CNCLAB_REDRAW") != nullptr;
};

TEST_F(FirstLesson, every_step_of_the_page_is_as_it_says) {
  std::ifstream stream(page());
  std::vector<Part> parts = parts_of(stream);
  std::optional<StationProcess> seat;
  int screens = 0;
  for (Part& part : parts) {
    if (part.kind.empty()) continue;
    SCOPED_TRACE(part.kind + ": " + (part.lines.empty() ? "" : part.lines.front()));
    ASSERT_NO_FATAL_FAILURE(play(part, seat));
    screens += part.kind == "screen" ? 1 : 0;
  }
  EXPECT_GE(screens, 10) << "the page has lost its pictures";
  if (!is_redrawn_) return;
  std::ofstream out(page());
  for (const Part& part : parts) {
    if (!part.kind.empty()) out << "```" << part.kind << "\n";
    for (const std::string& line : part.lines) out << line << "\n";
    if (!part.kind.empty()) out << "```\n";
  }
}

}  // namespace
}  // namespace cnclab::harness
