// The teachers' example programs in docs/examples: complete, and right from the first block to the last.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "program/check_programs.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using testing::IsEmpty;

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(DocsExamples, HaveNoFault) {
  constexpr std::uint64_t kBlocks = 100'000;
  const std::filesystem::path folder = std::filesystem::path(CNCLAB_TEST_DATA) / "../../docs/examples";
  int checked = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cnc") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const ProgramSet programs = programs_of(text_of(entry.path()));
    EXPECT_THAT(check_blocks(programs, Settings{}), IsEmpty());
    for (const std::uint16_t number : start_programs(programs)) {
      const Start start{.program = number, .block = programs.find(number)->blocks.front().number};
      EXPECT_THAT(dry_run(programs, Settings{}, start, kBlocks), IsEmpty());
    }
    ++checked;
  }
  EXPECT_GE(checked, 11);
}

}  // namespace
}  // namespace cnclab::program
