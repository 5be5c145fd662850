// Collected programs, one file for each student (INS-003).
#include "instructor/collection.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace cnclab::instructor {
namespace {

class Collection : public testing::Test {
 protected:
  Collection() { std::filesystem::create_directories(folder_); }
  ~Collection() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& content) const {
    const auto file = folder_ / ".collected";
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("cnclab-collection-" + std::to_string(::getpid()));
};

TEST_F(Collection, INS_003_EachStudentsProgramsGoToAFileOfTheirOwn) {
  const auto file = write("(anna)\nP0001\nN001G00X+1000\n%\n(otto)\nP0001\nN001G00X+2000\n%\nP0002\nN001G90\n%\n");
  const auto files = split_collection(file, folder_);
  ASSERT_TRUE(files);
  EXPECT_EQ(files->size(), 2U);
  EXPECT_EQ(read("anna.tape"), "P0001\nN001G00X+1000\n%\n");
  EXPECT_EQ(read("otto.tape"), "P0001\nN001G00X+2000\n%\nP0002\nN001G90\n%\n");
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(Collection, SEC_004_ANameThatIsNoFileNameWritesNothing) {
  for (const char* name : {"../anna", "/anna", ".anna", ".."}) {
    const auto files = split_collection(write(std::string("(otto)\nP0001\n(") + name + ")\nP0001\n"), folder_);
    EXPECT_FALSE(files) << name;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "otto.tape"));
  }
}

}  // namespace
}  // namespace cnclab::instructor
