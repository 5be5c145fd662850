// The queue: order, window, memory that follows what waits, two threads.
#include <gtest/gtest.h>

#include <thread>

#include "path_rig.hpp"

namespace cnclab::motion {
namespace {

Segment numbered(std::uint64_t number) {
  Segment segment;
  segment.item.sequence = number;
  segment.run = 1;
  return segment;
}

TEST(SegmentQueue, WindowOf65536IsFullThenAndNotBefore) {
  SegmentQueue queue;
  for (std::size_t i = 0; i < SegmentQueue::kWindow; ++i) {
    ASSERT_FALSE(queue.is_full()) << i;
    queue.push(numbered(i));
  }
  EXPECT_TRUE(queue.is_full());
  EXPECT_EQ(queue.waiting(), 65'536U);
  for (std::size_t i = 0; i < SegmentQueue::kWindow; ++i) {
    ASSERT_EQ(queue.front()->item.sequence, i);
    queue.pop();
  }
  EXPECT_EQ(queue.front(), nullptr);
}

TEST(SegmentQueue, MemoryFollowsWhatWaits) {
  SegmentQueue queue;
  EXPECT_EQ(queue.chunks_held(), 0U);
  std::size_t most = 0;
  for (std::uint64_t i = 0; i < 100'000; ++i) {  // a long program that is never far ahead
    queue.push(numbered(i));
    if (queue.waiting() > 100) queue.pop();
    most = std::max(most, queue.chunks_held());
  }
  EXPECT_LE(most, 4U);
  while (queue.waiting() > 0) queue.pop();
  queue.trim();
  EXPECT_LE(queue.chunks_held(), 2U);
}

TEST(SegmentQueue, AfterAFullWindowMemoryIsGivenBack) {
  SegmentQueue queue;
  for (std::uint64_t i = 0; i < SegmentQueue::kWindow; ++i) queue.push(numbered(i));
  EXPECT_EQ(queue.chunks_held(), SegmentQueue::kWindow / 128);
  queue.clear();
  queue.trim();
  EXPECT_LE(queue.chunks_held(), 2U);
  for (std::uint64_t i = 0; i < 2 * SegmentQueue::kWindow; ++i) {  // the ring turns over its end
    queue.push(numbered(i));
    ASSERT_EQ(queue.front()->item.sequence, i);
    queue.pop();
  }
}

TEST(SegmentQueue, ExitSpeedOnlyEverRises) {
  SegmentQueue queue;
  queue.push(numbered(0));
  EXPECT_EQ(queue.exit_speed(0), 0);
  queue.raise_exit_speed(0, 7);
  queue.raise_exit_speed(0, 3);
  EXPECT_EQ(queue.exit_speed(0), 7);
}

TEST(SegmentQueue, TwoThreadsSeeEverySegmentOnceInOrder) {
  constexpr std::uint64_t kMany = 100'000;
  SegmentQueue queue;
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kMany;) {
      if (queue.waiting() > 1000) {
        std::this_thread::yield();
        continue;
      }
      queue.push(numbered(i));
      queue.raise_exit_speed(i, static_cast<double>(i + 1));
      ++i;
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < kMany;) {
    const Segment* front = queue.front();
    if (front == nullptr) {
      std::this_thread::yield();
      continue;
    }
    const double exit = queue.exit_speed(i);
    if (front->item.sequence != i || (exit != 0 && exit != static_cast<double>(i + 1))) ++wrong;
    queue.pop();
    ++i;
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace cnclab::motion
