// Characters come when their time has come (EXT-043, EXT-045).
#include <gtest/gtest.h>

#include "transfer/line_pace.hpp"

namespace cnclab::transfer {
namespace {

using std::chrono::microseconds;

struct SpeedRow {
  int baud;
  int microseconds_each;  ///< 10 bits
};
class Speeds : public testing::TestWithParam<SpeedRow> {};
INSTANTIATE_TEST_SUITE_P(MD_20, Speeds,
                         testing::Values(SpeedRow{300, 33333}, SpeedRow{600, 16666}, SpeedRow{1200, 8333},
                                         SpeedRow{2400, 4166}, SpeedRow{4800, 2083}));

TEST_P(Speeds, ACharacterLastsTenBits) {
  const auto [baud, each] = GetParam();
  LinePace pace({.baud = baud});
  pace.put("abc", Time(1000));
  EXPECT_EQ(pace.due(), Time(1000 + each));
  EXPECT_EQ(pace.take(), 'a');
  EXPECT_EQ(pace.due(), Time(1000 + 2 * each));
  pace.put("d", Time(1001));  // queues behind
  EXPECT_EQ(pace.take(), 'b');
  EXPECT_EQ(pace.take(), 'c');
  EXPECT_EQ(pace.due(), Time(1000 + 4 * each));
  EXPECT_EQ(pace.take(), 'd');
  EXPECT_EQ(pace.due(), std::nullopt);
  EXPECT_TRUE(is_line_speed(baud));
}

TEST(LinePace, AnIdleLineStartsAnew) {
  LinePace pace({.baud = 1200});
  pace.put("a", Time(0));
  static_cast<void>(pace.take());
  pace.put("b", Time(4000));  // the line was still busy with a
  EXPECT_EQ(pace.due(), Time(2 * 8333));
  static_cast<void>(pace.take());
  pace.put("c", Time(1'000'000));
  EXPECT_EQ(pace.due(), Time(1'008'333));
}

TEST(LinePace, UnpacedCharactersAreThereAtOnce) {
  LinePace pace({.baud = 300, .is_paced = false});
  pace.put(std::string(10'000, 'x'), Time(5));
  for (int i = 0; i < 10'000; ++i) {
    ASSERT_EQ(pace.due(), Time(5));
    ASSERT_EQ(pace.take(), 'x');
  }
  EXPECT_EQ(pace.waiting(), 0u);
  EXPECT_FALSE(is_line_speed(9600));
}

}  // namespace
}  // namespace cnclab::transfer
