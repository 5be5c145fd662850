// Content in chunks: complete or not there at all.
#include "instructor/bulk_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace cnclab::instructor {
namespace {

namespace fs = std::filesystem;

v1::Chunk chunk(std::uint64_t offset, const std::string& data, bool is_last = false) {
  v1::Chunk result;
  result.set_transfer(3);
  result.set_offset(offset);
  result.set_data(data);
  result.set_is_last(is_last);
  return result;
}

std::string content(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class BulkFileTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove(target_);
    fs::remove(part_);
  }
  fs::path target_ = fs::path(testing::TempDir()) / ("cnclab-bulk-" + std::to_string(::getpid()));
  fs::path part_ = target_.string() + ".part";
};

TEST_F(BulkFileTest, appears_with_the_last_chunk_for_its_owner_alone) {
  BulkFile file(target_);
  const auto first = file.take(chunk(0, "t_s,"));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->transfer(), 3U);
  EXPECT_EQ(first->next_offset(), 4U);
  EXPECT_FALSE(fs::exists(target_));
  ASSERT_TRUE(file.take(chunk(4, "x_mm\n", true)));
  EXPECT_TRUE(file.is_complete());
  EXPECT_EQ(content(target_), "t_s,x_mm\n");
  EXPECT_EQ(fs::status(target_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(BulkFileTest, a_broken_transfer_leaves_the_older_file) {
  std::ofstream(target_) << "older";
  {
    BulkFile file(target_);
    ASSERT_TRUE(file.take(chunk(0, "half")));
  }
  EXPECT_EQ(content(target_), "older");
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(BulkFileTest, SEC_006_refuses_gaps_repeats_and_chunks_above_4_KiB) {
  BulkFile file(target_);
  EXPECT_FALSE(file.take(chunk(1, "gap")));
  ASSERT_TRUE(file.take(chunk(0, "abc")));
  EXPECT_FALSE(file.take(chunk(0, "abc")));
  EXPECT_FALSE(file.take(chunk(3, std::string(4097, 'x'))));
  EXPECT_FALSE(file.is_complete());
}

TEST_F(BulkFileTest, a_folder_that_does_not_exist_is_told) {
  BulkFile file("/nowhere/trace.csv");
  const auto result = file.take(chunk(0, "x", true));
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().text.find("/nowhere/trace.csv"), std::string::npos);
  EXPECT_EQ(result.error().exit_code, 1);
}

}  // namespace
}  // namespace cnclab::instructor
