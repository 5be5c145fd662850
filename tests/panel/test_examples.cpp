// The demo programs of docs/examples run on the default machine and end where their drawings say.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

struct Example {
  std::string_view file;
  double x_mm, y_mm, z_mm;  ///< Istwert at the end
  machine::StopCause cause;
  double least_x_mm, most_x_mm;  ///< reached on the way
};

std::ostream& operator<<(std::ostream& stream, const Example& example) { return stream << example.file; }

// Ends and extents are read off the programs' drawings.
constexpr Example kExamples[] = {
    {"square.cnc", 0, 0, 0, machine::StopCause::program_end, 0, 40},
    {"square_absolute.cnc", 0, 0, 0, machine::StopCause::program_end, 0, 40},
    {"three_planes.cnc", 0, 0, 0, machine::StopCause::program_end, 0, 30},
    {"full_circle.cnc", 0, 0, 0, machine::StopCause::program_end, 0, 40},
    {"drill_row.cnc", 0, 0, 0, machine::StopCause::program_end, 0, 60},
    {"deep_drilling.cnc", 0, 0, 0, machine::StopCause::program_end, 0, 20},
    {"slot.cnc", 0, 0, 0, machine::StopCause::program_end, -15, 35},
    {"pocket.cnc", 0, 0, 0, machine::StopCause::program_end, -15, 15},
    {"hole_circle.cnc", 0, 0, 0, machine::StopCause::program_end, -21.651, 21.651},
    {"parameters.cnc", 0, 0, 0, machine::StopCause::program_end, -20, 20},
    // DEC-56: X would reach 85 mm per pass; the switch at 250 mm stops pass 3, its axis is freed and zeroed.
    {"bild7.cnc", 0, 180, 162, machine::StopCause::limit_switch, 0, 250},
};

std::filesystem::path examples_folder() { return std::filesystem::path(CNCLAB_TEST_DATA) / "../../docs/examples"; }

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class Examples : public testing::TestWithParam<Example> {};

TEST_P(Examples, RunToTheirEnd) {
  const std::string tape = content_of(examples_folder() / GetParam().file);
  ASSERT_FALSE(tape.empty());
  Bench bench({.tape = tape});
  bench.keys("AUTOMAT CLEAR");
  const auto& programs = bench.control.memory().programs();
  const auto is_program = [](const language::Program& program) { return program.number != language::kToolTable; };
  bench.type(std::to_string(std::ranges::find_if(programs, is_program)->number));
  bench.keys("ENTER ENTER START");
  double least = 0, most = 0;
  ASSERT_TRUE(bench.run_until([&] {
    least = std::min(least, bench.istwert(0));
    most = std::max(most, bench.istwert(0));
    return !bench.control.is_running() && bench.snapshot().state == machine::MotionState::standstill;
  })) << bench.picture();
  EXPECT_EQ(bench.snapshot().cause, GetParam().cause) << bench.picture();
  EXPECT_NEAR(least, GetParam().least_x_mm, 0.05);
  EXPECT_NEAR(most, GetParam().most_x_mm, 1.0);
  EXPECT_NEAR(bench.istwert(0), GetParam().x_mm, kStep_mm);
  if (GetParam().cause == machine::StopCause::limit_switch) return;
  EXPECT_NEAR(bench.istwert(1), GetParam().y_mm, kStep_mm);
  EXPECT_NEAR(bench.istwert(2), GetParam().z_mm, kStep_mm);
}

INSTANTIATE_TEST_SUITE_P(Docs, Examples, testing::ValuesIn(kExamples),
                         [](const auto& example) { return std::filesystem::path(example.param.file).stem().string(); });

TEST(ExampleFiles, EveryFileIsInTheTable) {
  for (const auto& entry : std::filesystem::directory_iterator(examples_folder())) {
    if (entry.path().extension() != ".cnc") continue;
    const auto is_there = [&](const Example& example) { return entry.path().filename() == example.file; };
    EXPECT_NE(std::ranges::find_if(kExamples, is_there), std::end(kExamples)) << entry.path();
  }
}

}  // namespace
}  // namespace cnclab::panel
