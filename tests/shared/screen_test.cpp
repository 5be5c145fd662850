// The screen's grid: writing, cutting at its edges, rows shared between copies, UTF-8.
#include "shared/screen.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace cnclab {
namespace {

TEST(Screen, IsBlankAtFirst) {
  const Screen screen;
  EXPECT_EQ(screen.text(0), std::string(80, ' '));
  EXPECT_EQ(screen.at(23, 79), Cell{});
}

TEST(Screen, WritesUmlautsIntoOneCellEach) {
  Screen screen;
  screen.write(3, 2, "Maß ä→□", Attribute::inverse);
  EXPECT_EQ(screen.at(3, 4).code, U'ß');
  EXPECT_EQ(screen.at(3, 7).code, U'→');
  EXPECT_EQ(screen.at(3, 8), (Cell{U'□', Attribute::inverse}));
  EXPECT_EQ(screen.at(3, 9), Cell{});
  EXPECT_EQ(from_utf8(screen.text(3)).size(), 80U);
}

TEST(Screen, CutsAtTheEdgesAndAtTheWidth) {
  Screen screen;
  screen.write(0, 78, "abc");
  screen.write(1, -1, "xyz");
  screen.write(2, 0, "12345", Attribute::normal, 3);
  screen.write(24, 0, "outside");
  screen.write(-1, 0, "outside");
  screen.put(24, 0, {U'!', {}});
  screen.put(0, 80, {U'!', {}});
  EXPECT_EQ(screen.text(0), std::string(78, ' ') + "ab");
  EXPECT_EQ(screen.text(1), "yz" + std::string(78, ' '));
  EXPECT_EQ(screen.text(2), "123" + std::string(77, ' '));
  EXPECT_EQ(screen.at(99, 0), Cell{});
}

TEST(Screen, CopiesShareRowsUntilOneChanges) {
  Screen first;
  first.write(5, 0, "same");
  Screen second = first;
  EXPECT_EQ(&first.row(5), &second.row(5));
  EXPECT_EQ(first, second);
  second.put(7, 1, {U'x', Attribute::dim});
  EXPECT_EQ(first.changed_rows(second), std::vector<int>{7});
  EXPECT_EQ(first.at(7, 1), Cell{}) << "the older copy keeps its cells";
  EXPECT_FALSE(first == second);
  second.put(7, 1, {});
  EXPECT_EQ(first, second) << "equality is by content";
}

TEST(Utf8, MalformedBytesBecomeReplacementCharacters) {
  struct Row {
    const char* name;
    std::string bytes;
    std::u32string codes;
  };
  const Row rows[] = {
      {"lone continuation", "a\x80z", U"a\uFFFDz"},
      {"overlong slash", "\xC0\xAF", U"\uFFFD\uFFFD"},
      {"overlong three bytes", "\xE0\x80\x80", U"\uFFFD\uFFFD\uFFFD"},
      {"surrogate", "\xED\xA0\x80", U"\uFFFD\uFFFD\uFFFD"},
      {"above U+10FFFF", "\xF4\x90\x80\x80", U"\uFFFD\uFFFD\uFFFD\uFFFD"},
      {"cut in the middle", "\xE2\x86", U"\uFFFD"},
      {"cut, then text", "\xE2\x86z", U"\uFFFDz"},
      {"byte FF", "\xFF", U"\uFFFD"},
      {"largest", "\xF4\x8F\xBF\xBF", U"\U0010FFFF"},
      {"NUL inside", std::string("a\0b", 3), std::u32string(U"a\0b", 3)},
  };
  for (const Row& row : rows) EXPECT_EQ(from_utf8(row.bytes), row.codes) << row.name;
}

RC_GTEST_PROP(Utf8, EveryCodePointComesBack, ()) {
  const auto number = *rc::gen::inRange<std::uint32_t>(0, 0x120000);
  const bool is_scalar = number <= 0x10FFFF && (number < 0xD800 || number > 0xDFFF);
  const char32_t expected = is_scalar ? static_cast<char32_t>(number) : U'\uFFFD';
  RC_ASSERT(from_utf8(to_utf8(static_cast<char32_t>(number))) == std::u32string(1, expected));
}

RC_GTEST_PROP(Utf8, AnyBytesDecodeToAtMostOneCodePointEach, (const std::string& bytes)) {
  RC_ASSERT(from_utf8(bytes).size() <= bytes.size());
}

TEST(Shortened, NamesThatDifferAtTheirEndsStillDo) {
  EXPECT_EQ(shortened("schueler-2026-01", 12), "schuel…26-01");
  EXPECT_EQ(shortened("schueler-2026-02", 12), "schuel…26-02");
  EXPECT_EQ(shortened("müller-überlang-ß", 12), "müller…ang-ß");
  EXPECT_EQ(shortened("zwölf Zeichn", 12), "zwölf Zeichn");
  EXPECT_EQ(shortened("abcd", 3), "a…d");
}

}  // namespace
}  // namespace cnclab
