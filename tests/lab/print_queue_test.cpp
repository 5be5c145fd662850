// Pages to the lab's printer: what lp is given, what it says, and a limit for one that hangs ([printer] queue).
#include "lab/media/print_queue.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace cnclab::lab {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A program `lp` of our own, first in PATH.
class PrintQueue : public testing::Test {
 protected:
  PrintQueue() : path_(std::getenv("PATH")) {
    std::string name = (fs::temp_directory_path() / "cnclab-lp-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    ::setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
  }
  ~PrintQueue() override {
    ::setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }
  void lp(const std::string& script) const {
    std::ofstream(folder_ / "lp") << "#!/bin/sh\ncd '" << folder_.string() << "'\n" << script;
    ::chmod((folder_ / "lp").c_str(), 0755);
  }
  [[nodiscard]] std::string content(const std::string& name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string path_;
  fs::path folder_;
};

TEST_F(PrintQueue, EXT_003_LpGetsQueueTitleAndPages) {
  lp("echo \"$@\" > words\ncat > pages\n");
  const std::string pdf = "%PDF-1.3 " + std::string(200'000, '\xff');
  ASSERT_TRUE(print_pages("Saal 3", "P0001; rm -rf /", pdf));
  EXPECT_EQ(content("words"), "-d Saal 3 -t P0001; rm -rf /\n") << "no shell has read them";
  EXPECT_EQ(content("pages"), pdf);
}

TEST_F(PrintQueue, EXT_003_WhatLpRefusesIsTold) {
  lp("echo 'lp: The printer or class does not exist.' >&2\necho more >&2\nexit 1\n");
  const auto printed = print_pages("none", "P0001", "pages");
  ASSERT_FALSE(printed);
  EXPECT_EQ(printed.error(), "lp: The printer or class does not exist.");
}

TEST_F(PrintQueue, EXT_003_AnLpThatHangsIsEnded) {
  lp("echo $$ > number\nexec sleep 60\n");
  const auto printed = print_pages("none", "P0001", "pages", 300ms);
  ASSERT_FALSE(printed);
  EXPECT_FALSE(fs::exists("/proc/" + content("number").substr(0, content("number").find('\n'))));
}

TEST_F(PrintQueue, EXT_003_WithoutCupsThatIsTold) {
  ::setenv("PATH", folder_.c_str(), 1);
  EXPECT_THAT(print_pages("none", "P0001", "pages").error(), testing::HasSubstr("No such file"));
}

}  // namespace
}  // namespace cnclab::lab
