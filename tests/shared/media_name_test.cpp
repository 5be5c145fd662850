// Which names the media folder knows (issue: no path from the other end is trusted).
#include "shared/media_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cnclab {
namespace {

TEST(MediaName, KnowsItsOwnNames) {
  for (const MediaKind kind : {MediaKind::punched_tape, MediaKind::tape_text, MediaKind::diskette,
                               MediaKind::printed_pages, MediaKind::picture}) {
    EXPECT_EQ(media_kind(media_name(kind, 1)), kind);
    EXPECT_EQ(media_kind(media_name(kind, std::nullopt)), kind);
  }
  EXPECT_EQ(media_name(MediaKind::punched_tape, 42), "P0042.tap");
  EXPECT_EQ(media_name(MediaKind::diskette, std::nullopt), "SPEICHER.nc");
}

TEST(MediaName, AcceptsWhatPeopleCallTheirFiles) {
  for (const char* name : {"teil-3.nc", "Platte_2.tap", "a.txt", "P0001.v2.nc", "CONTOUR.nc"})
    EXPECT_TRUE(is_media_name(name)) << name;
}

TEST(MediaName, RefusesWhatLeadsElsewhere) {
  constexpr std::array<std::string_view, 26> kHostile{
      "",       ".",     "..",        "../P0001.nc", "a/b.nc",      "/etc/passwd", "a\\b.nc",   "C:x.nc", ".profile.nc",
      "-rf.nc", "a..nc", "x/../y.nc", "CON.nc",      "nul.txt",     "lpt1.tap",    "Com9.x.nc", "a.sh",   "a",
      ".nc",    "a.nc ", "a b.nc",    "a\n.nc",      "\xC3\xA4.nc", "a.NC",        "~.nc",      "a%2e.nc"};
  for (const std::string_view name : kHostile) EXPECT_FALSE(is_media_name(name)) << name;
  EXPECT_FALSE(is_media_name(std::string_view("a\0.nc", 5)));
  EXPECT_TRUE(is_media_name(std::string(61, 'a') + ".nc"));
  EXPECT_FALSE(is_media_name(std::string(62, 'a') + ".nc"));
}

}  // namespace
}  // namespace cnclab
