// Contours of which only the whole shows that the tool would cut into them: `path`, `run`, `plot` stop where `check`
// says (DEC-09).
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tool_process.hpp"

namespace cnclab::tool {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A pocket whose last wall ends 3 mm before its first; the tool has a radius of 5.
const std::string kPocket =
    "P0000\nT001R+5000L+0\nP0001\nN001G11F1000T01\nN002G17\nN003G42\nN004G01X+10000\nN005G01Y+50000\nN006G01X+60000\n"
    "N007G01Y-30000\nN008G01X-57000\nN009G40\nN010G01Y+10000\n%\n";

class ContoursTest : public ToolTest {};

TEST_F(ContoursTest, ARunStopsBehindTheLastElementThatIsRight_DEC_09) {
  const Said said = tool("run -", kPocket);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith("-:8: P0001 N005: "));
  EXPECT_THAT(said.err, HasSubstr("P0001 N008"));
  const json summary = json::parse(said.out);
  EXPECT_EQ(summary["ended"], "error");
  EXPECT_EQ(summary["blocks"], 4);
  EXPECT_EQ(summary["path_mm"], 15);
  EXPECT_EQ(summary["position"]["x"], 15);
  EXPECT_EQ(summary["position"]["y"], 0);
}

TEST_F(ContoursTest, APathEndsThereToo_DEC_09) {
  const Said said = tool("path -", kPocket);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_EQ(said.out,
            "{\"op\":\"tool\",\"program\":1,\"block\":1,\"number\":1,\"radius\":5,\"length\":0}\n"
            "{\"op\":\"line\",\"program\":1,\"block\":4,\"from\":{\"x\":0,\"y\":0,\"z\":0},"
            "\"to\":{\"x\":15,\"y\":0,\"z\":0},\"feed\":1000}\n");
  EXPECT_THAT(said.err, StartsWith("-:8: P0001 N005: "));
}

TEST_F(ContoursTest, APlotIsNotMadeOfThem_DEC_09) {
  const Said said = tool("plot - --out " + at("part.svg"), kPocket);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith("-:8: P0001 N005: "));
  EXPECT_FALSE(std::filesystem::exists(at("part.svg")));
}

TEST_F(ContoursTest, ALoopInAnOpenContourEndsAtABlockLimit) {
  const std::string loop = kPocket.substr(0, kPocket.find("N006")) + "N006G20P0001N006%";
  const Said said = tool("run -", loop);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(json::parse(said.out)["ended"], "block_limit");
  EXPECT_EQ(tool("path -", loop).exit_code, 0);
}

TEST_F(ContoursTest, ASmallerToolRunsThrough) {
  const std::string tools = write("tools.cnc", "P0000T001R+1000L+0%");
  const Said said = tool("run - --tools " + tools, kPocket);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(json::parse(said.out)["ended"], "program_end");
}

}  // namespace
}  // namespace cnclab::tool
