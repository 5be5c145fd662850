// The comparison of traces with drawings: right ones pass, each kind of wrong one fails.
#include "deviation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>

#include "parts.hpp"

namespace cnclab::lesson {
namespace {

constexpr double kStep_mm = 0.005;

Point on_steps(Point p) {
  for (double& value : p) value = std::round(value / kStep_mm) * kStep_mm;
  return p;
}

/// What a machine would do that follows `curves` at 45 mm/s and rounds to steps.
std::vector<TraceRow> made(const std::vector<Curve>& curves) {
  constexpr double kWayPerTick_mm = 0.045;
  const Drawing drawing(curves);
  std::vector<TraceRow> trace{{0, {0, 0, 0}, 0, 1, 1}};
  double carried = 0;
  for (const Element& element : drawing.elements()) {
    double way = kWayPerTick_mm - carried;
    for (; way < element.length_mm(); way += kWayPerTick_mm) {
      trace.push_back({trace.back().time_s + 0.001, on_steps(element.at(way)), 2700, 1, 1});
    }
    carried = element.length_mm() - (way - kWayPerTick_mm);
  }
  trace.push_back({trace.back().time_s + 0.001, on_steps(drawing.end()), 0, 1, 1});
  return trace;
}

const std::vector<Curve> kSquare = {Line{{20, 0, 0}}, Line{{20, 20, 0}}, Line{{0, 20, 0}}, Line{{0, 0, 0}}};
const std::vector<Curve> kDrawnCircle = {Arc{Plane::xy, Turn::cw, {10, 0, 0}, {0, 0, 0}}};

TEST(Deviation, PartsMadeExactlyPassWithinHalfAStep) {
  for (const Part& part : parts()) {
    SCOPED_TRACE(part.student);
    const Drawing drawing(part.curves);
    const Comparison result = compare(drawing, made(part.curves), {});
    EXPECT_EQ(result.fault, "");
    EXPECT_LE(result.largest_axis_mm, kStep_mm / 2 + 1e-6);
    EXPECT_LE(result.largest_space_mm, std::sqrt(drawing.moving_axes()) * kStep_mm / 2 + 1e-6);
    EXPECT_NEAR(result.measured_mm, result.drawn_mm, 0.003 * result.drawn_mm + 0.5);
    EXPECT_NEAR(result.seconds, result.drawn_mm / 45, 0.01);
  }
}

using Spoil = std::function<void(std::vector<TraceRow>&)>;
struct WrongRow {
  const char* name;
  std::vector<Curve> drawn;
  std::vector<Curve> made;
  Spoil spoil;
};
void PrintTo(const WrongRow& row, std::ostream* out) { *out << row.name; }

void nothing(std::vector<TraceRow>&) {}

Spoil shifted(double x, double y) {
  return [=](std::vector<TraceRow>& trace) {
    for (TraceRow& row : trace) {
      row.position[0] += x;
      row.position[1] += y;
    }
  };
}

Spoil without_rows(double from_part, double to_part) {
  return [=](std::vector<TraceRow>& trace) {
    const auto at = [&](double part) {
      return trace.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(trace.size()));
    };
    trace.erase(at(from_part), at(to_part));
  };
}

Spoil one_row_moved(double part, double x) {
  return [=](std::vector<TraceRow>& trace) {
    trace[static_cast<std::size_t>(part * static_cast<double>(trace.size()))].position[0] += x;
  };
}

std::vector<WrongRow> wrong_rows() {
  const auto circle = [](Turn turn, double radius) {
    return std::vector<Curve>{Arc{Plane::xy, turn, {radius, 0, 0}, {0, 0, 0}}};
  };
  return {
      {"one step beside the drawing", kSquare, kSquare, shifted(0, kStep_mm)},
      {"one tick one step off", kSquare, kSquare, one_row_moved(0.4, kStep_mm)},
      {"corner cut by 0.05",
       kSquare,
       {Line{{19.95, 0, 0}}, Line{{20, 0.05, 0}}, Line{{20, 20, 0}}, Line{{0, 20, 0}}, Line{{0, 0, 0}}},
       nothing},
      {"corner overshot by 0.06",
       kSquare,
       {Line{{20.06, 0, 0}}, Line{{20, 0, 0}}, Line{{20, 20, 0}}, Line{{0, 20, 0}}, Line{{0, 0, 0}}},
       nothing},
      {"a side left out", kSquare, {Line{{20, 0, 0}}, Line{{20, 20, 0}}, Line{{0, 0, 0}}}, nothing},
      {"made the other way round",
       kSquare,
       {Line{{0, 20, 0}}, Line{{20, 20, 0}}, Line{{20, 0, 0}}, Line{{0, 0, 0}}},
       nothing},
      {"broken off", kSquare, kSquare, without_rows(0.8, 1)},
      {"end missed by three steps",
       kSquare,
       {Line{{20, 0, 0}}, Line{{20, 20, 0}}, Line{{0, 20, 0}}, Line{{0, 0.015, 0}}},
       nothing},
      {"a jump along the path", kSquare, kSquare, without_rows(0.3, 0.4)},
      {"made twice",
       kSquare,
       {Line{{20, 0, 0}}, Line{{20, 20, 0}}, Line{{0, 20, 0}}, Line{{0, 0, 0}}, Line{{20, 0, 0}}, Line{{0, 0, 0}}},
       nothing},
      {"circle of a radius 0.006 too large", kDrawnCircle, circle(Turn::cw, 10.006), nothing},
      {"circle counterclockwise", kDrawnCircle, circle(Turn::ccw, 10), nothing},
      {"circle left out",
       {Line{{5, 0, 0}}, Arc{Plane::xy, Turn::cw, {15, 0, 0}, {5, 0, 0}}, Line{{0, 0, 0}}},
       {Line{{5, 0, 0}}, Line{{0, 0, 0}}},
       nothing},
      {"an axis too many",
       kSquare,
       {Line{{20, 0, 0}}, Line{{20, 20, 0.01}}, Line{{0, 20, 0}}, Line{{0, 0, 0}}},
       nothing},
      {"XZ arc through the other side",
       {Arc{Plane::xz, Turn::cw, {10, 0, 0}, {20, 0, 0}}},
       {Arc{Plane::xz, Turn::ccw, {10, 0, 0}, {20, 0, 0}}},
       nothing},
      {"back way left out",
       {Line{{0, 0, -4}}, Line{{0, 0, 0}}, Line{{0, 0, -4}}, Line{{0, 0, 0}}},
       {Line{{0, 0, -4}}, Line{{0, 0, 0}}},
       nothing},
  };
}

class WrongPart : public testing::TestWithParam<WrongRow> {};

TEST_P(WrongPart, IsFound) {
  std::vector<TraceRow> trace = made(GetParam().made);
  GetParam().spoil(trace);
  EXPECT_FALSE(compare(Drawing(GetParam().drawn), trace, {}).is_as_drawn()) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(Rows, WrongPart, testing::ValuesIn(wrong_rows()),
                         [](const auto& row) { return "row" + std::to_string(row.index); });

TEST(Deviation, ABrokenOffRunIsRightAsFarAsItCame) {
  std::vector<TraceRow> trace = made(kSquare);
  without_rows(0.6, 1)(trace);
  const Comparison result = compare(Drawing(kSquare), trace, {}, Expect::part);
  EXPECT_EQ(result.fault, "");
  EXPECT_NEAR(result.reached_mm, 48, 0.5);
  shifted(0, 0.01)(trace);
  EXPECT_FALSE(compare(Drawing(kSquare), trace, {}, Expect::part).is_as_drawn());
}

TEST(Deviation, PausesAndSlowPartsAreNoFault) {
  std::vector<TraceRow> trace = made(kSquare);
  const TraceRow rest = trace[500];
  trace.insert(trace.begin() + 500, 300, rest);
  for (std::size_t i = 1; i < trace.size(); ++i) trace[i].time_s = trace[i - 1].time_s + 0.001;
  EXPECT_EQ(compare(Drawing(kSquare), trace, {}).fault, "");
  EXPECT_NEAR(rested_s(trace, rest.position, {}), 0.3, 1e-9);
}

TEST(Deviation, NothingToCompareIsAFault) { EXPECT_FALSE(compare(Drawing(kSquare), {}, {}).is_as_drawn()); }

TEST(Trace, ReadsTheColumnsOfTheInterface) {
  const auto trace =
      read_trace("t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block\n0.001,1.5,-2,3,0,300.5,0,1,12\n");
  ASSERT_TRUE(trace.has_value()) << trace.error();
  ASSERT_EQ(trace->size(), 1U);
  EXPECT_EQ((*trace)[0].position, (Point{1.5, -2, 3}));
  EXPECT_EQ((*trace)[0].block, 12);
  EXPECT_DOUBLE_EQ((*trace)[0].feed_mm_per_min, 300.5);
}

TEST(Trace, RefusesWhatIsNoTrace) {
  const std::string header = "t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block\n";
  for (const std::string& text : {std::string(), std::string("t,x\n1,2\n"), header, header + "1,2,3\n",
                                  header + "0,1,2,3,4,5,6,7,8,9\n", header + "0,1,a,3,4,5,6,7,8\n"}) {
    EXPECT_FALSE(read_trace(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace cnclab::lesson
