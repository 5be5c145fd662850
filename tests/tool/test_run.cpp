// `cnclab-tool path`, `run`, `plot`, `convert` as processes.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tool_process.hpp"

namespace cnclab::tool {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class RunTest : public ToolTest {
 protected:
  [[nodiscard]] static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
  [[nodiscard]] static std::vector<double> numbers_of(const std::string& row) {
    std::vector<double> numbers;
    std::istringstream stream(row);
    for (std::string cell; std::getline(stream, cell, ',');) numbers.push_back(std::stod(cell));
    return numbers;
  }
};

const std::string kMirrored =
    "P0002N001G75X-1000Y+1000N002G22P0001N001W00N003G75X+1000Y-1000N004G22P0001N001W00"
    "N005G75X-1000Y-1000N006G22P0001N001W00N007G74N008G22P0001N001W00\n"
    "P0001N001G11F1000N002G01X+20000Y+20000N003G02X+5Y-5I+10000J+10000N004G01X-5Y+5N005G01X-20000Y-20000%";

TEST_F(RunTest, PathPrintsOneLinePerElementAndStopsAtTheLimit) {
  const Said said = tool("path - --max-blocks 5", kPicture7);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.err, HasSubstr("5"));
  std::vector<std::string> ops;
  for (const std::string& line : lines_of(said.out)) ops.push_back(json::parse(line)["op"]);
  EXPECT_THAT(ops, ElementsAre("rapid", "dwell", "spindle", "line", "arc"));
}

TEST_F(RunTest, PathPrintsWhatCameBeforeAnError) {
  const Said said = tool("path -", "P0001N001G00X+1000\nN002G01X+1000%");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(lines_of(said.out).size(), 1u);
  EXPECT_THAT(said.err, StartsWith("-:2: P0001 N002: "));
}

TEST_F(RunTest, PathIntoAFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const Said said = tool("path - --max-blocks 5 > /dev/full", kPicture7);
  EXPECT_EQ(said.exit_code, 0) << "the shell's later redirection wins";
  const Said full = tool("plot - --out /dev/full", kMirrored);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, HasSubstr("cannot be written"));
}

TEST_F(RunTest, RunReachesTheEndOfTheMirroredCircles_EX107) {
  const Said said = tool("run -", kMirrored);
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const json summary = json::parse(said.out);
  EXPECT_EQ(summary["ended"], "program_end");
  EXPECT_EQ(summary["blocks"], 28);
  EXPECT_NEAR(summary["path_mm"], 581.704827, 1e-6);
  for (const char* axis : {"x", "y", "z", "u"}) EXPECT_EQ(summary["position"][axis], 0) << axis;
  EXPECT_GE(summary["machine_time_s"], 581.704827 / 1000 * 60);
  EXPECT_EQ(summary["events"].back()["op"], "end");
}

TEST_F(RunTest, Picture7EndsInItsThirdPassOnTheXSwitch_DEC56) {
  const Said said = tool("run -", kPicture7);
  EXPECT_EQ(said.exit_code, 0);
  const json summary = json::parse(said.out);
  EXPECT_EQ(summary["ended"], "limit_switch");
  EXPECT_EQ(summary["limit_axis"], "x");
  EXPECT_EQ(summary["position"]["x"], 0) << "its Istwert is zeroed (ERR-020)";
  const double two_passes = 2 * 129.531819, three_passes = 3 * 129.531819;
  EXPECT_GT(summary["path_mm"], two_passes);
  EXPECT_LT(summary["path_mm"], three_passes);
}

TEST_F(RunTest, EndsAreNamed) {
  struct Row {
    const char* text;
    const char* options;
    const char* ended;
    int exit_code;
  };
  const Row rows[] = {
      {"P0001N001G01X+1000F1000M00N002G01X+1000%", "", "halt", 0},
      {"P0001N001G01X+1000F1000M01N002G01X+1000%", "", "halt", 0},
      {"P0001N001G01X+1000F1000M16N002G01X+1000%", "", "wait", 0},
      {"P0001N001G01X+1000F1000M61N002G01X+1000%", "", "wait", 0},
      {"P0001N001G01X+1000F1000N002G01X+1000M02N003G01X+9000%", "", "program_end", 0},
      {"P0001N001G00X+1000N002G01X+1000%", "", "error", 1},
      {"P0001N001G01X+1000F1000N002G01X-1000N003G20P0001N001%", "--max-blocks 30", "block_limit", 0},
      {"P0001N001G01X+1000F1000N002G01X-1000N003G20P0001N001%", "--max-seconds 2", "time_limit", 0},
      {"P0001N001G20P0001N001%", "--max-blocks 20000", "block_limit", 0},
      {"P0001N001G20P0001N001%", "--max-seconds 1", "time_limit", 0},
  };
  for (const Row& row : rows) {
    const Said said = tool(std::string("run - ") + row.options, row.text);
    EXPECT_EQ(said.exit_code, row.exit_code) << row.text << said.err;
    ASSERT_TRUE(json::accept(said.out)) << row.text << said.out;
    EXPECT_EQ(json::parse(said.out)["ended"], row.ended) << row.text;
  }
}

TEST_F(RunTest, AHaltIsAnEventOfAFinishedBlock_M000) {
  const json summary = json::parse(tool("run -", "P0001N001G17N002G01X+1000F1000M01N003G17%").out);
  EXPECT_EQ(summary["blocks"], 2);
  EXPECT_EQ(summary["path_mm"], 1);
  ASSERT_EQ(summary["events"].size(), 1u);
  EXPECT_EQ(summary["events"][0]["op"], "halt");
  EXPECT_EQ(summary["events"][0]["signal"], true);
}

TEST_F(RunTest, TheFourthAxisIsAnEventAndNoWayOfTheTool_SYS_016) {
  const Said said = tool("run -", "P0001N001G11F1000N002G12U+5000N003G01X+3000%");
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const json summary = json::parse(said.out);
  EXPECT_EQ(summary["path_mm"], 3);
  EXPECT_EQ(summary["position"]["u"], 5);
  ASSERT_EQ(summary["events"].size(), 2u);
  EXPECT_EQ(summary["events"][0]["op"], "axis4");
  EXPECT_EQ(summary["events"][0]["to"], 5);
  EXPECT_EQ(summary["events"][0]["feed"], 1000);
}

/// Numbers that are not exact have six decimals at least (interfaces.md section 5).
TEST_F(RunTest, TraceFeedsAreNotRoundedToThousandths) {
  const std::string trace = at("trace.csv");
  ASSERT_EQ(tool("run - --trace " + trace, "P0001N001G01X+10000F1000%").exit_code, 0);
  bool is_fine = false;
  for (const std::string& row : lines_of(read(trace))) {
    const std::string feed = row.substr(0, row.rfind(',', row.rfind(',', row.rfind(',') - 1) - 1));
    is_fine = is_fine || feed.size() - feed.rfind('.') > 6;
  }
  EXPECT_TRUE(is_fine);
}

TEST_F(RunTest, AnErrorStopsBehindTheLastGoodBlock) {
  const Said said = tool("run -", "P0001\nN001G00X+5000\nN002G01X+1000\n%");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith("-:3: P0001 N002: "));
  const json summary = json::parse(said.out);
  EXPECT_EQ(summary["blocks"], 1);
  EXPECT_EQ(summary["position"]["x"], 5);
}

TEST_F(RunTest, TraceHasARowPerTickOnThePath_EX014) {
  const std::string trace = at("trace.csv");
  const Said said = tool("run - --trace " + trace, "P0001N001G02X+10000Y+0I+5000J+0F1000%");
  EXPECT_EQ(said.exit_code, 1) << "arcs have no F word";
  const Said good = tool("run - --trace " + trace, "P0001N001G11F1000M03S0500N002G02X+10000Y+0I+5000J+0%");
  ASSERT_EQ(good.exit_code, 0) << good.err;
  const auto rows = lines_of(read(trace));
  ASSERT_GT(rows.size(), 900u);
  EXPECT_EQ(rows[0], "t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block");
  const double half_step = 0.0025;
  double last_time = 0, fastest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto row = numbers_of(rows[i]);
    ASSERT_EQ(row.size(), 9u) << rows[i];
    EXPECT_NEAR(row[0] - last_time, 0.001, 1e-9);
    last_time = row[0];
    EXPECT_NEAR(std::hypot(row[1] - 5, row[2]), 5, std::numbers::sqrt2 * half_step + 1e-9) << rows[i];
    EXPECT_GE(row[2], -half_step) << "clockwise: the upper half (D-128)";
    fastest = std::max(fastest, row[5]);
  }
  EXPECT_NEAR(fastest, 1000, 1);
  const auto last = numbers_of(rows.back());
  EXPECT_EQ(last[1], 10);
  EXPECT_EQ(last[2], 0);
  EXPECT_EQ(last[6], 500);
  EXPECT_NEAR(json::parse(good.out)["path_mm"], 5 * std::numbers::pi, 1e-6);
}

TEST_F(RunTest, StepsAddUpToThePosition) {
  const std::string steps = at("steps.bin");
  const Said said = tool("run - --steps " + steps, "P0001N001G00X+10000Y-4000Z+2500%");
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const std::string bytes = read(steps);
  ASSERT_EQ(bytes.size() % 16, 0u);
  std::array<std::int64_t, 4> sum{};
  for (std::size_t at = 0; at < bytes.size(); at += 4) {
    std::uint32_t value = 0;
    for (std::size_t byte = 4; byte-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + byte]);
    sum[at / 4 % 4] += static_cast<std::int32_t>(value);
  }
  EXPECT_THAT(sum, ElementsAre(2000, -800, 500, 0));
}

TEST_F(RunTest, TickLengthChangesTheRowsNotThePath) {
  const Said fine = tool("run - --tick-ms 1", "P0001N001G01X+50000F1000%");
  const Said coarse = tool("run - --tick-ms 5", "P0001N001G01X+50000F1000%");
  const json a = json::parse(fine.out), b = json::parse(coarse.out);
  EXPECT_EQ(a["path_mm"], b["path_mm"]);
  EXPECT_NEAR(a["machine_time_s"], b["machine_time_s"], 0.02);
}

TEST_F(RunTest, ProgramBlockToolsAndMachineDataAreHeeded) {
  const std::string tools = write("tools.cnc", "P0000T005R+2500L-1000%");
  const std::string data = write("machine.md", "06 = 2000\n");
  const std::string text = "P0001N001G00X+1000\nP0002N001G11T05N002G00X+2000N003G00X+3000%";
  const Said said = tool("path - --program P0002 --tools " + tools + " --machine-data " + data, text);
  const auto lines = lines_of(said.out);
  ASSERT_EQ(lines.size(), 4u) << said.err;
  EXPECT_EQ(json::parse(lines[0])["radius"], 2.5);
  EXPECT_EQ(json::parse(lines[0])["length"], -1);
  EXPECT_EQ(json::parse(lines[1])["feed"], 2000);
  EXPECT_EQ(lines_of(tool("path - --program 2 --block N003", text).out).size(), 2u);
  EXPECT_THAT(lines_of(tool("path -", text).out)[0], HasSubstr("\"program\":1")) << "DEC-32";
  const Said missing = tool("path - --program P0009", text);
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err, StartsWith("-: P0009: "));
  EXPECT_EQ(tool("path - --block N009", text).exit_code, 1);
  EXPECT_EQ(tool("path - --tools " + data, text).exit_code, 1);
}

TEST_F(RunTest, AStartInTheMiddleFindsTheStateOfTheBlocksBefore_DEC_26) {
  const std::string text = "P0001N001G11F0500N002G90N003G00X+1000N004G01X+1000Y+1000%";
  const Said said = tool("path - --block N004", text);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  const json line = json::parse(lines_of(said.out).at(0));
  EXPECT_EQ(line["feed"], 500);
  EXPECT_EQ(line["to"]["x"], 1);
  EXPECT_EQ(tool("check - --block N004", text).exit_code, 0);
  EXPECT_EQ(json::parse(tool("run - --block N004", text).out)["blocks"], 1);
}

TEST_F(RunTest, PlotDrawsEveryView) {
  for (const char* view : {"xy", "xz", "yz", "iso"}) {
    const std::string out = at(std::string(view) + ".svg");
    const Said said = tool("plot - --out " + out + " --view " + view, kMirrored);
    EXPECT_EQ(said.exit_code, 0) << said.err;
    EXPECT_THAT(read(out), StartsWith("<svg "));
    EXPECT_THAT(read(out), HasSubstr("class=\"feed\""));
  }
  const Said refused = tool("plot - --out " + at("no/such/folder.svg"), kMirrored);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("cannot be written"));
  EXPECT_EQ(tool("plot - --out " + at("loop.svg"), kPicture7).exit_code, 0);
  EXPECT_LT(read(at("loop.svg")).size(), 20'000u) << "a loop that walks away is drawn up to the switch";
}

TEST_F(RunTest, ConvertGivesTapeAndListing) {
  const Said tape = tool("convert - --to cnc3300", kPicture7);
  EXPECT_EQ(tape.exit_code, 0);
  EXPECT_EQ(tool("convert - --to cnc3300", tape.out).out, tape.out);
  EXPECT_THAT(tape.out, HasSubstr("N003G01X+25000Y+10000Z+4000F1000M03\n"));
  const Said listing = tool("--language de convert - --to listing", kPicture7);
  EXPECT_THAT(listing.out, HasSubstr("N001 G00 X+..50.000 Y+..50.000 Z+..50.000 (EILGANG)\n"));
  const Said din = tool("convert - --to din66025", kPicture7);
  EXPECT_EQ(din.exit_code, 1);
  EXPECT_THAT(din.err, HasSubstr("DIN 66025"));
}

}  // namespace
}  // namespace cnclab::tool
