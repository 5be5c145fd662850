// Screens collapse to the newest, with at most one update on its way.
#include "lab/screen_feed.hpp"

#include <gtest/gtest.h>

#include "shared/screen_wire.hpp"

namespace cnclab::lab {
namespace {

View view_of(const std::string& text, std::uint64_t handled = 0) {
  View view;
  view.screen.write(3, 0, text);
  view.handled_key = handled;
  return view;
}

TEST(ScreenFeed, OneUnacknowledgedUpdateThenTheNewest) {
  ScreenFeed feed;
  EXPECT_FALSE(feed.next()) << "nothing has changed";
  feed.offer(view_of("A"), 0);
  const auto first = feed.next();
  ASSERT_TRUE(first);
  feed.offer(view_of("B"), 0);
  feed.offer(view_of("C"), 0);
  EXPECT_FALSE(feed.next()) << "one is on its way";
  EXPECT_TRUE(feed.acknowledge(first->number()));
  const auto second = feed.next();
  ASSERT_TRUE(second);
  Screen shown;
  shown = apply_rows(shown, *first).value();
  shown = apply_rows(shown, *second).value();
  EXPECT_EQ(shown, view_of("C").screen);
}

TEST(ScreenFeed, AHandledKeyTravelsEvenWhenNoRowChanged) {
  ScreenFeed feed;
  feed.offer(view_of("A", 1), 0);
  const auto first = feed.next();
  ASSERT_TRUE(first && feed.acknowledge(first->number()));
  feed.offer(view_of("A", 2), 0);
  const auto second = feed.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->rows_size(), 0);
  EXPECT_EQ(second->handled_key(), 2U);
}

TEST(ScreenFeed, BeepsAddUpAndAreToldOnce) {
  ScreenFeed feed;
  feed.offer(view_of("A"), 1);
  feed.offer(view_of("A"), 2);
  const auto update = feed.next();
  ASSERT_TRUE(update);
  EXPECT_EQ(update->beeps(), 3U);
  ASSERT_TRUE(feed.acknowledge(update->number()));
  EXPECT_FALSE(feed.next());
}

TEST(ScreenFeed, AcknowledgingWhatWasNeverSentIsNoticed) {
  ScreenFeed feed;
  EXPECT_FALSE(feed.acknowledge(1));
  feed.offer(view_of("A"), 0);
  ASSERT_TRUE(feed.next());
  EXPECT_FALSE(feed.acknowledge(7));
  EXPECT_TRUE(feed.acknowledge(1));
  EXPECT_FALSE(feed.acknowledge(1));
}

}  // namespace
}  // namespace cnclab::lab
