// Screens as drawings: every script in screens/ is a test of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "screen_script.hpp"

namespace cnclab::panel {
namespace {

std::vector<std::filesystem::path> scripts() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(CNCLAB_TEST_DATA "/screens"))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class Screens : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Screens, AreDrawnAsInTheScript) {
  const bool redraw = std::getenv("CNCLAB_REDRAW") != nullptr;
  const std::string rewritten = run_screen_script(GetParam(), redraw);
  if (redraw) std::ofstream(GetParam()) << rewritten;
}

INSTANTIATE_TEST_SUITE_P(Panel, Screens, testing::ValuesIn(scripts()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace cnclab::panel
