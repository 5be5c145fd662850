// Pages of the printer.
#include <gmock/gmock.h>

#include "transfer/printout.hpp"

namespace cnclab::transfer {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const PrintHeader kHeader{.what = "CNC 3300  P0001", .student = "Jörg", .date = "16/06/83 09:00:00"};

std::size_t columns_of(std::string_view line) {
  return static_cast<std::size_t>(
      std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

std::string lines(int count) {
  std::string text;
  for (int line = 1; line <= count; ++line) text += "line " + std::to_string(line) + "\n";
  return text;
}

TEST(Printout, EachPageHasItsHeader) {
  const auto pages = set_pages(lines(65), kHeader);
  ASSERT_EQ(pages.size(), 2u);
  EXPECT_EQ(pages[0].size(), kPageLines);
  EXPECT_THAT(pages[0][0], StartsWith("CNC 3300  P0001"));
  EXPECT_THAT(pages[0][0], HasSubstr(" Jörg "));
  EXPECT_THAT(pages[0][0], EndsWith("16/06/83 09:00:00  Seite 1/2"));
  EXPECT_EQ(columns_of(pages[0][0]), kPageColumns);
  EXPECT_EQ(columns_of(pages[0][1]), kPageColumns);
  EXPECT_EQ(pages[0].back(), "line 64");
  EXPECT_THAT(pages[1], testing::ElementsAre(EndsWith("Seite 2/2"), testing::_, "line 65"));
}

TEST(Printout, LongLinesAreBrokenNotCut) {
  std::string line;
  for (int i = 0; i < 90; ++i) line += "ä";
  const auto pages = set_pages(line, kHeader);
  ASSERT_EQ(pages[0].size(), 4u);
  EXPECT_EQ(columns_of(pages[0][2]), 80u);
  EXPECT_EQ(columns_of(pages[0][3]), 10u);
}

TEST(Printout, NothingThatIsNoTextReachesThePrinter) {
  const auto pages = set_pages("a\x1B[2Jb\tc\xFFz\xE2\x86", kHeader);
  EXPECT_EQ(pages[0][2], "a [2Jb c?z??");
}

TEST(Printout, FormFeedsBeginAPage) {
  const auto pages = set_pages("one\n\ftwo\n", kHeader);
  ASSERT_EQ(pages.size(), 2u);
  EXPECT_EQ(pages[0][2], "one");
  EXPECT_EQ(pages[1][2], "two");
}

TEST(Printout, AnEmptyListIsAPage) {
  EXPECT_EQ(set_pages("", kHeader).size(), 1u);
  PrintHeader wide = kHeader;
  wide.what = std::string(200, 'x');
  wide.student = std::string(200, 'y');
  EXPECT_EQ(columns_of(set_pages("", wide)[0][0]), kPageColumns);
}

TEST(Printout, AsATextFile) {
  PrintHeader english = kHeader;
  english.tongue = language::Tongue::english;
  const std::string text = print_text(set_pages("P0001\n\fP0002   \n", english));
  EXPECT_THAT(text, HasSubstr("page 1/2\n"));
  EXPECT_THAT(text, HasSubstr("\nP0001\n\fCNC 3300"));
  EXPECT_THAT(text, EndsWith("\nP0002\n"));
}

}  // namespace
}  // namespace cnclab::transfer
