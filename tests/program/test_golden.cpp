// Golden traces: whole programs against paths worked out by hand (golden/README.md).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "program/path_source.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

std::string content_of(const std::string& name) {
  const std::ifstream file(std::string(CNCLAB_TEST_DATA) + "/golden/" + name);
  EXPECT_TRUE(file.good()) << name;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct GoldenRow {
  const char* name;
  std::uint16_t program;
  std::size_t most_blocks;
};

class Golden : public testing::TestWithParam<GoldenRow> {};

TEST_P(Golden, PathIsTheOneWorkedOut) {
  const GoldenRow& row = GetParam();
  const std::string name = row.name;
  const RunResult run = run_text(content_of(name + ".cnc"), row.most_blocks, {.program = row.program}, Settings{});
  EXPECT_FALSE(run.error);
  EXPECT_EQ(run.json(), content_of(name + ".jsonl"));
}

INSTANTIATE_TEST_SUITE_P(, Golden,
                         testing::Values(GoldenRow{"picture7", 1, 10}, GoldenRow{"ex040", 1, 100},
                                         GoldenRow{"ex100", 2, 100}, GoldenRow{"planes", 7, 100},
                                         GoldenRow{"ex030", 1, 10}, GoldenRow{"ex060", 1, 10},
                                         GoldenRow{"ex070", 1, 100}, GoldenRow{"ex094", 1, 100},
                                         GoldenRow{"radius", 3, 100}, GoldenRow{"events", 4, 100},
                                         GoldenRow{"g81", 81, 1000}, GoldenRow{"g82", 82, 1000},
                                         GoldenRow{"g83", 83, 1000}, GoldenRow{"g84", 84, 1000},
                                         GoldenRow{"g85", 85, 1000}, GoldenRow{"g86", 86, 1000}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(GoldenPath, OfTheToolsCentre_EX080_to_EX092) {
  auto source = PathSource::begin(programs_of(content_of("ex080.cnc")), Settings{}, {});
  ASSERT_TRUE(source);
  RunResult run;
  while (!source->ended()) ASSERT_TRUE(source->step(run.items));
  EXPECT_EQ(run.json(), content_of("ex080.jsonl"));
}

}  // namespace
}  // namespace cnclab::program
