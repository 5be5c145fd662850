// `cnclab-tool check`, bad files and wrong command lines (interfaces.md section 5).
#include <gmock/gmock.h>

#include <sstream>

#include "tool_process.hpp"

namespace cnclab::tool {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

class CheckTest : public ToolTest {};

TEST_F(CheckTest, SaysNothingOfAGoodProgram) {
  const Said said = tool("check " + write("good.cnc", kPicture7));
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_EQ(said.out, "");
  EXPECT_EQ(said.err, "");
}

TEST_F(CheckTest, NamesEveryErrorWithFileLineAndBlock) {
  const std::string file = write("bad.cnc",
                                 "P0001\n"
                                 "N001G00X+1000\n"
                                 "N002G01X+600000\n"
                                 "N003G20P0009N001\n"
                                 "N004G11F4000\n"
                                 "N005G22P0002N007W00\n"
                                 "P0002\n"
                                 "N001G10\n"
                                 "%\n");
  const Said said = tool("check " + file);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(said.out, "");
  for (const char* place :
       {":3: P0001 N002: ", ":4: P0001 N003: ", ":5: P0001 N004: ", ":6: P0001 N005: ", ":8: P0002 N001: "})
    EXPECT_THAT(said.err, HasSubstr(file + place));
}

TEST_F(CheckTest, FindsWhatOnlyExecutionShows) {
  const std::string file = write("no-feed.cnc", "P0001N001G00X+1000\nN002G01X+1000%");
  const Said said = tool("check " + file);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith(file + ":2: P0001 N002: "));
}

TEST_F(CheckTest, UnknownFunctionNamesItsBlock_ERR001) {
  const std::string file = write("g99.cnc", "P0001\nN001G17\nN002G99X+1\n%");
  const Said said = tool("check " + file);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith(file + ":3: P0001 N002: "));
  EXPECT_THAT(said.err, HasSubstr("G99"));
}

TEST_F(CheckTest, AProgramWithAnErrorIsNotCalledMissing) {
  const Said said = tool("check -", "P0001N001G22P0002N001W00\nP0002N001G99%");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, MatchesRegex("-:2: P0002 N001: [^\n]*\n"));
}

/// Places of what was said, in its order.
std::vector<std::string> places_in(const std::string& err) {
  std::vector<std::string> places;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find(": P"); at != std::string::npos) places.push_back(line.substr(at + 2, 10));
  return places;
}

TEST_F(CheckTest, AWordThatCannotBeReadHidesNoOtherError) {
  const Said said = tool("check -",
                         "P0001N001G11F9999N002G01X+600000N003G99N004G20P0009N001N005\\53N003N006\\53N007\n"
                         "P0002N001G01X+1000N002G22P0001N003W00N003G01X+600000%");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(places_in(said.err),
              testing::ElementsAre("P0001 N001", "P0001 N002", "P0001 N003", "P0001 N004", "P0002 N003"))
      << said.err << "N003 and N007 may be there, and whether F is missing in P0002 shows when P0001 is right";
}

TEST_F(CheckTest, WhatDoesNotComeToAFaultyProgramIsExecutedOnPaper) {
  const Said said = tool("check -", "P0001N001G99%P0002N001G11F1000N002G02X+9000Y+0I+5000J+0%");
  EXPECT_THAT(places_in(said.err), testing::ElementsAre("P0001 N001", "P0002 N002")) << said.err;
}

TEST_F(CheckTest, ErrorsStandInTheOrderOfTheBlocks) {
  const Said said = tool("check -", "P0001N001G17N002G01X+1000N003G02X+9000Y+0I+5000J+0N004G01X+600000F1000%");
  EXPECT_THAT(places_in(said.err), testing::ElementsAre("P0001 N002", "P0001 N003", "P0001 N004")) << said.err;
}

TEST_F(CheckTest, ARoundingBetweenALineAndItsWayBackIsCalledThat_D66) {
  const Said said = tool("check -", "P0001N001G11F1000N002G01X+10000N003G10R+1000N004G01X-5000%");
  EXPECT_THAT(said.err, HasSubstr("P0001 N003: The block: the second line leads back, there is no corner."));
}

TEST_F(CheckTest, AnArcUnderG43SaysWhatG43CannotDo_D72) {
  const Said said =
      tool("check -", "P0000T001R+5000L+0\nP0001N001G11F1000T01N002G43N003G01X+10000N004G02X+10000Y+0I+5000J+0%");
  EXPECT_THAT(said.err, HasSubstr("P0001 N004: The block: no arc while G43/G44 shift the axes."));
}

TEST_F(CheckTest, TheWordToBlameIsTheOneOfNoPlane) {
  const Said said = tool("check -", "P0001N001G02X+1Y-1I+2Z+3J+4%");
  EXPECT_THAT(said.err, HasSubstr("P0001 N001: Z does not fit into this block, right: X Y I J"));
}

TEST_F(CheckTest, ANegativeRadiusIsRefusedWhereItActs_D50) {
  const std::string text = "P0000T001R-5000L+0%P0001N001G11F1000T01N002G41N003G01Y+10000N004G01X+10000%";
  for (const char* command : {"check -", "path -", "run -"}) {
    const Said said = tool(command, text);
    EXPECT_EQ(said.exit_code, 1) << command;
    EXPECT_THAT(said.err, HasSubstr("P0001 N002: T01 R -5.000 is not allowed, right: R >= 0.")) << command;
  }
}

TEST_F(CheckTest, ReadsStandardInput) { EXPECT_EQ(tool("check -", kPicture7).exit_code, 0); }

TEST_F(CheckTest, SmallLettersAreRefusedUnlessStrict_DEC30) {
  const std::string text = "P0001N001G00X+1000(comment)\nn002 small%";
  const Said refused = tool("check -", text);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, StartsWith("-:2:"));
  EXPECT_EQ(tool("check --strict -", "P0001N001G00X+1000n%").exit_code, 0);
}

TEST_F(CheckTest, MachineDataDecideWhatIsTooFast) {
  const std::string data = write("machine.md", "# slow machine\n06 = 800\n10 = 200\n");
  EXPECT_EQ(tool("check -", "P0001N001G01X+1000F0900%").exit_code, 0);
  const Said said = tool("check - --machine-data " + data, "P0001N001G01X+1000F0900%");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, HasSubstr("800"));
  const std::string broken = write("broken.md", "06 = fast\n");
  const Said refused = tool("check - --machine-data " + broken, kPicture7);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, StartsWith(broken + ":1: "));
  const Said all = tool("check - --machine-data " + write("all.md", "06 = fast\n07 = 100\n99 = 5\nx\n"), kPicture7);
  EXPECT_EQ(all.exit_code, 1);
  for (const char* place : {":1: ", ":3: MD 99", ":4: "}) EXPECT_THAT(all.err, HasSubstr(at("all.md") + place));
  EXPECT_THAT(all.err, Not(HasSubstr(at("all.md") + ":2: ")));
  const Said late = tool("check - --machine-data " + write("late.md", "06 = 3000\n\n99 = 5\n"), kPicture7);
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_THAT(late.err, StartsWith(at("late.md") + ":3: MD 99"));
}

TEST_F(CheckTest, FaultsOfAToolTableNameItsOwnFile) {
  const std::string tools = write("tools.cnc", "P0000\nT001R+5000\nT002R-5\n");
  const std::string program = write("program.cnc", "P0000\nT002R-5\nP0001\nN001G17\n%\n");
  const Said said = tool("check " + program + " --tools " + tools);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith(tools + ":3: P0000 T002: "));
  EXPECT_THAT(said.err, testing::Not(HasSubstr(program)));
  EXPECT_THAT(tool("check " + program).err, StartsWith(program + ":2: P0000 T002: "));
}

TEST_F(CheckTest, FilesThatAreNoneGetAClearWord) {
  struct Row {
    std::string name, file, part;
  };
  const std::string folder = at("folder");
  std::filesystem::create_directory(folder);
  const Row rows[] = {
      {"missing", at("missing.cnc"), "cannot be read"},
      {"directory", folder, "is a directory"},
      {"empty", write("empty.cnc", ""), "is empty"},
      {"blank", write("blank.cnc", " \n\n"), "is empty"},
      {"binary",
       write("binary.cnc", std::string("\x7f"
                                       "ELF\x02\x01\x01\0\0",
                                       9)),
       "is no text file"},
      {"comment only", write("comment.cnc", "(nothing)"), ""},
  };
  for (const Row& row : rows) {
    for (const char* command : {"check ", "path ", "run "}) {
      const Said said = tool(command + row.file);
      EXPECT_EQ(said.exit_code, 1) << command << row.name;
      EXPECT_EQ(said.out, "") << command << row.name;
      EXPECT_THAT(said.err, StartsWith(row.file + ":")) << command << row.name;
      EXPECT_THAT(said.err, HasSubstr(row.part)) << command << row.name;
    }
  }
}

TEST_F(CheckTest, WrongCommandLinesAreUsageErrors) {
  for (const char* arguments :
       {"", "check", "nonsense x", "check - --nonsense", "run - --program X1", "run - --program P0000",
        "run - --block N1000", "plot - --out x.svg --view zz", "plot -", "convert -", "run - --tick-ms 0",
        "run - --max-blocks 0", "path - --max-blocks -1", "run - --max-seconds 0", "run - --max-seconds soon", "verify",
        "check - --dialect fanuc"})
    EXPECT_EQ(tool(arguments, kPicture7).exit_code, 2) << arguments;
  EXPECT_EQ(tool("--help").exit_code, 0);
}

TEST_F(CheckTest, OtherDialectsAreNamed) {
  const Said said = tool("check - --dialect codesys", kPicture7);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, HasSubstr("codesys"));
}

TEST_F(CheckTest, SpeaksGermanWhenAsked) {
  const Said said = tool("--language de check -", "P0001N001G99%");
  EXPECT_THAT(said.err, HasSubstr("gibt es an dieser Steuerung nicht"));
}

TEST_F(CheckTest, AWordThatIsNoCommandIsNamedWithThoseThereAre) {
  const Said said = tool("bogus");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, HasSubstr("there is no command 'bogus'; commands: check, path, run, plot, convert, verify"));
  EXPECT_EQ(tool("").exit_code, 2);
}

}  // namespace
}  // namespace cnclab::tool
