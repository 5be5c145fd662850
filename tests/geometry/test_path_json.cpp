// The printed form of numbers and items (interfaces.md section 5).
#include <gtest/gtest.h>

#include <limits>

#include "geometry/path_json.hpp"

namespace {

using namespace cnclab::geometry;

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

TEST(PathJson, NumbersAreShortExactAndNeverMinusZero) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(-1e-12), "0");
  EXPECT_EQ(number(85), "85");
  EXPECT_EQ(number(-0.005), "-0.005");
  EXPECT_EQ(number(20.005), "20.005");
  EXPECT_EQ(number(1.0 / 3), "0.333333333");
  EXPECT_EQ(number(9999.999), "9999.999");
  EXPECT_EQ(number(0.1 + 0.2), "0.3");
  EXPECT_EQ(number(1e12), "1e+12");
}

std::string json(const PathItem& item) {
  std::string text;
  return append_json(text, item) ? text : "nothing" + text;
}

template <typename What>
PathItem item_of(const What& what) {
  PathItem item;
  item.source = {.program = 12, .block = 34};
  item.what = what;
  return item;
}

TEST(PathJson, EventsHaveTheFieldsOfTheTable) {
  const std::string head = R"(","program":12,"block":34)";
  EXPECT_EQ(json(item_of(Dwell{1.5})), R"({"op":"dwell)" + head + R"(,"seconds":1.5})");
  EXPECT_EQ(json(item_of(Spindle{SpindleTurn::counterclockwise, 800})),
            R"({"op":"spindle)" + head + R"(,"turn":"ccw","rpm":800})");
  EXPECT_EQ(json(item_of(Coolant{true})), R"({"op":"coolant)" + head + R"(,"on":true})");
  EXPECT_EQ(json(item_of(ToolChange{5, 2.5, -1})),
            R"({"op":"tool)" + head + R"(,"number":5,"radius":2.5,"length":-1})");
  EXPECT_EQ(json(item_of(Output{2, 0, false})), R"({"op":"output)" + head + R"(,"card":2,"line":0,"on":false})");
  EXPECT_EQ(json(item_of(Wait{0, 0})), R"({"op":"wait)" + head + R"(,"card":0,"line":0})");
  EXPECT_EQ(json(item_of(SetActual{{true, false, true}, {1, 2, -3}})),
            R"({"op":"set_actual)" + head + R"(,"x":1,"z":-3})");
  EXPECT_EQ(json(item_of(Reference{{false, true, false}, {0, -1, 0}})), R"({"op":"reference)" + head + R"(,"y":-1})");
  EXPECT_EQ(json(item_of(Halt{true})), R"({"op":"halt)" + head + R"(,"signal":true})");
  EXPECT_EQ(json(item_of(Signal{})), R"({"op":"signal)" + head + "}");
  EXPECT_EQ(json(item_of(End{})), R"({"op":"end)" + head + "}");
  EXPECT_EQ(json(item_of(Mark{})), "nothing");
  EXPECT_EQ(json(item_of(SpindleDigits{100})), "nothing");
  PathItem axis = item_of(Line{{}, {0, 0, 0, 3}, 600, false});
  axis.is_fourth_axis = true;
  EXPECT_EQ(json(axis), R"({"op":"axis4)" + head + R"(,"to":3,"feed":600})");
}

TEST(PathJson, ElementsHaveTheFieldsOfTheInterface) {
  EXPECT_EQ(json(item_of(Line{{1, 2, 3}, {4, 5, 6}, 1000, false})),
            R"({"op":"line","program":12,"block":34,"from":{"x":1,"y":2,"z":3},"to":{"x":4,"y":5,"z":6},"feed":1000})");
  EXPECT_EQ(json(item_of(Arc{{}, {0, 0, 2}, {0, 0, 1}, Turn::counterclockwise, Plane::yz, 50})),
            R"({"op":"arc","program":12,"block":34,"from":{"x":0,"y":0,"z":0},"to":{"x":0,"y":0,"z":2},"feed":50,)"
            R"("center":{"x":0,"y":0,"z":1},"turn":"ccw","plane":"yz"})");
}

}  // namespace
