// `cnclab-tool convert` as a process: tape and listing into each other, and what neither can hold.
#include <gmock/gmock.h>

#include <regex>

#include "tool_process.hpp"

namespace cnclab::tool {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ConvertTest : public ToolTest {};

const std::string kWholeMemory =
    "P0000\nT001R+5000L+1000\nP0001\nN001G11F1000T01\nN002\\01#01#02#03\nN003\\00#04+1500\nN004G01X#04\nN005\\51N004\n%"
    "\n";

/// The listing without its date lines.
std::string dateless(const std::string& listing) {
  return std::regex_replace(listing, std::regex(R"(\(\d\d:\d\d:\d\d \d\d/\d\d/\d\d\)\n\n)"), "");
}

TEST_F(ConvertTest, TapeBecomesAListing_EXT_005) {
  const Said said = tool("--language de convert - --to listing", kWholeMemory);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(dateless(said.out),
            "P0000\n\nT001 R+...5.000 L+...1.000\n%\n"
            "P0001\n\n"
            "N001 G11 (ZUSATZFUNKTION) F1000 S.... T01 M..\n"
            "N002 ↓01          #01 = #02 + #03\n"
            "N003 ↓00          #04 = +...1.500\n"
            "N004 G01 X......#04 Y.....,... Z.....,... F.... S.... T.. M..\n"
            "N005 ↓51 (JUMP POS TO) N004\n%\n");
}

TEST_F(ConvertTest, ThereAndBackIsTheSame_EXT_005) {
  EXPECT_EQ(tool("convert - --to cnc3300", kWholeMemory).out, kWholeMemory);
  for (const char* language : {"de", "en"}) {
    const Said listing = tool("--language " + std::string(language) + " convert - --to listing", kWholeMemory);
    EXPECT_EQ(tool("convert - --to cnc3300", listing.out).out, kWholeMemory);
    EXPECT_EQ(dateless(tool("--language " + std::string(language) + " convert - --to listing", listing.out).out),
              dateless(listing.out));
  }
}

TEST_F(ConvertTest, ListingOfTheManualBecomesATape_EX_080) {
  const std::string listing =
      "P0001\n\n(09:00:00 16/06/83)\n\nN002 G11 (ZUSATZFUNKTION) F1000 S.... T01 M..\n"
      "N003 G01 X+...20,000 Y..... Z..... F.... S.... T.. M..\n%\n";
  const Said said = tool("convert - --to cnc3300", listing);
  EXPECT_EQ(said.out, "P0001\nN002G11F1000T01\nN003G01X+20000\n%\n") << said.err;
  EXPECT_EQ(tool("check -", listing).exit_code, 0) << "every command reads listings";
  EXPECT_EQ(tool("check - --strict", listing).exit_code, 1) << "the control reads none";
}

TEST_F(ConvertTest, MachineDataStayInTapesAndAreRefusedForListings_DEC_62) {
  const std::string recording = "P0001\nN001G17\nMD\nN03=500000\nN04=400000\n%\n";
  EXPECT_EQ(tool("convert - --to cnc3300", recording).out, recording);
  const Said said = tool("convert - --to listing", recording);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, StartsWith("-:4: a listing holds no machine data"));
}

TEST_F(ConvertTest, DamagedBlocksHaveNoTapeForm_SCR_052) {
  const std::string listing = "P0007\n\nN001 G17\nN002!G18\nN003!G19\n%\nP0000\nT001!R+...1.000\n%\n";
  const Said said = tool("convert - --to cnc3300", listing);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, HasSubstr("-:4: P0007 N002: "));
  EXPECT_THAT(said.err, HasSubstr("-:5: P0007 N003: "));
  EXPECT_THAT(said.err, HasSubstr("-:8: P0000 T001: "));
  EXPECT_THAT(tool("convert - --to listing", listing).out, HasSubstr("N002!G18"));
}

TEST_F(ConvertTest, FaultsOfAListingNameTheirLine) {
  const Said said = tool("convert - --to cnc3300", "P0001\n\nN001 G01 X+...1.000 E....\nN002 G99\nN003 G12 U+500\n%\n");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, HasSubstr("-:3: P0001 N001: "));
  EXPECT_THAT(said.err, HasSubstr("-:4: P0001 N002: "));
  EXPECT_THAT(said.err, HasSubstr("-:5: P0001 N003: "));
}

TEST_F(ConvertTest, OtherStandardIsAnErrorThatNamesWhatIsPossible) {
  const Said said = tool("convert - --to din66025", kPicture7);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, HasSubstr("--to cnc3300 or listing"));
}

TEST_F(ConvertTest, ListingsAreGermanLikeTheOriginalUnlessAskedOtherwise_EXT005) {
  const std::string tape = "P0001N001G90%";
  EXPECT_THAT(tool("convert - --to listing", tape).out, testing::HasSubstr("N001 G90 (ABSOLUTMASS)"));
  EXPECT_THAT(tool("--language en convert - --to listing", tape).out, testing::HasSubstr("N001 G90 (ABSOLUTE"));
}

}  // namespace
}  // namespace cnclab::tool
