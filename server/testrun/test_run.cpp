// Plays a program and looks at every way it takes.
#include "testrun/test_run.hpp"

#include <algorithm>

#include "geometry/path_math.hpp"

namespace cnclab::testrun {

namespace {

using Kind = Finding::Kind;

/// The cutter that is drawn and cuts where no tool with a radius was called: a scriber would leave nothing to see.
constexpr double kNoToolRadius_mm = 1;
/// Spots are single precision; less than this beyond a switch is none.
constexpr double kTravelTolerance_mm = 1e-4;

constexpr std::array<float drawing::Spot::*, 3> kAxes{&drawing::Spot::x, &drawing::Spot::y, &drawing::Spot::z};
constexpr std::string_view kAxisNames = "XYZ";

bool is_way(const geometry::PathItem& item) {
  return std::holds_alternative<geometry::Line>(item.what) || std::holds_alternative<geometry::Arc>(item.what);
}

}  // namespace

std::array<TravelRange, 3> travel_about(const geometry::Point& start, const machine::MachineData& data) {
  constexpr std::array<double geometry::Point::*, 3> kCoordinates{&geometry::Point::x, &geometry::Point::y,
                                                                  &geometry::Point::z};
  std::array<TravelRange, 3> travel;
  for (std::size_t axis = 0; axis < travel.size(); ++axis) {
    const double half = static_cast<double>(data.get(static_cast<int>(axis) + 3)) / 2000;
    travel[axis] = {start.*kCoordinates[axis] - half, start.*kCoordinates[axis] + half};
  }
  return travel;
}

std::expected<TestRun, language::Error> TestRun::begin(TestOrder order) {
  auto source = program::PathSource::begin(order.programs, order.settings, order.start);
  if (!source) return std::unexpected(source.error());
  return TestRun(std::move(*source), std::move(order));
}

TestRun::TestRun(program::PathSource source, TestOrder order)
    : order_(std::move(order)),
      source_(std::move(source)),
      time_(order_.start.position, machine::motion_limits(order_.data)),
      stock_(order_.workpiece, order_.cell_mm),
      position_(order_.start.position),
      spindle_turns_(order_.start.modal.spindle != geometry::SpindleTurn::off) {
  const int number = order_.start.modal.tool;
  const program::ToolData tool = order_.programs.tool(number).value_or(program::ToolData{});
  tool_ = {.number = number, .radius_mm = language::to_mm(tool.radius), .length_mm = language::to_mm(tool.length)};
  if (const language::Program* main = order_.programs.find(order_.start.program))
    main_blocks_ = std::max<std::size_t>(main->blocks.size(), 1);
}

void TestRun::advance(std::uint64_t blocks) {
  for (; blocks > 0 && !has_ended_; --blocks) execute_block();
}

void TestRun::execute_block() {
  if (blocks_ == order_.most_blocks) {
    report({.kind = Kind::endless_loop, .block = block_});
    return end();
  }
  items_.clear();
  const auto executed = source_.step(items_, &check_);
  ++blocks_;
  if (executed) block_ = executed->source;
  if (!executed && blocks_ == 1) block_ = {executed.error().program, executed.error().block};
  if (executed && executed->depth == 0)
    if (const language::Program* main = order_.programs.find(block_.program)) {
      main_blocks_ = std::max<std::size_t>(main->blocks.size(), 1);
      main_index_ = main->find(block_.block).value_or(0) + 1;
    }
  follow_contour();
  for (const geometry::PathItem& item : items_) {
    if (has_ended_) return;
    take(item);
  }
  if (!executed)
    report(
        {.kind = Kind::error, .block = {executed.error().program, executed.error().block}, .error = executed.error()});
  if (!executed || executed->ended) return end();
  if (time_.seconds() < order_.most_machine_s) return;
  report({.kind = Kind::too_long, .block = block_, .most = order_.most_machine_s / 3600});
  end();
}

/// Keeps what was programmed under compensation for the picture, and tells where its path cuts into it (DEC-09).
void TestRun::follow_contour() {
  const bool is_compensated = modal().radius != program::RadiusCompensation::off;
  contour_blocks_ = is_compensated ? contour_blocks_ + 1 : 0;
  if (is_compensated)
    for (const geometry::PathItem& item : source_.programmed()) keep(item, contour_, contour_spots_);
  if (is_compensated && contour_blocks_ % order_.longest_contour == 0) {
    check_.split();
    if (contour_blocks_ == order_.longest_contour)
      report({.kind = Kind::contour_in_parts, .block = block_, .most = static_cast<double>(order_.longest_contour)});
  }
  for (; gouges_ < check_.findings().size(); ++gouges_) {
    const language::Error error = program::error_of(check_.findings()[gouges_]);
    report({.kind = Kind::error, .block = {error.program, error.block}, .error = error});
  }
}

/// Appends while there is room; counts all.
void TestRun::keep(const geometry::PathItem& item, std::vector<drawing::Stroke>& strokes, std::size_t& spots) const {
  if (spots <= order_.most_spots) spots += drawing::append_strokes(item, strokes);
}

void TestRun::take(const geometry::PathItem& item) {
  time_.take(item);
  if (const auto* spindle = std::get_if<geometry::Spindle>(&item.what))
    spindle_turns_ = spindle->turn != geometry::SpindleTurn::off;
  if (const auto* tool = std::get_if<geometry::ToolChange>(&item.what)) take_tool(item, *tool);
  if (is_way(item)) take_way(item);
}

void TestRun::take_tool(const geometry::PathItem& item, const geometry::ToolChange& tool) {
  tool_ = tool;
  if (tool.number != 0 && !order_.programs.tool(tool.number))
    report({.kind = Kind::tool_not_in_table, .block = item.source, .found = static_cast<double>(tool.number)});
}

void TestRun::take_way(const geometry::PathItem& item) {
  if (item.is_fourth_axis) return;
  path_mm_ += geometry::length_of(item);
  std::vector<drawing::Stroke> way;
  drawing::append_strokes(item, way);
  check_travel(item, way.front());
  if (has_ended_) return;
  cut(item, way.front());
  ways_ += way.front().spots.size() - 1;
  keep(item, path_, spots_);
  const auto* line = std::get_if<geometry::Line>(&item.what);
  position_ = line != nullptr ? line->to : std::get<geometry::Arc>(item.what).to;
}

/// Tells of the place that lies farthest out.
void TestRun::check_travel(const geometry::PathItem& item, const drawing::Stroke& stroke) {
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const TravelRange& range = order_.travel[axis];
    double found = 0, excess = 0;
    for (const drawing::Spot& spot : std::span(stroke.spots).subspan(1)) {  // the first ended the way before
      const auto place = static_cast<double>(spot.*kAxes[axis]);
      const double beyond = std::max(range.least_mm - place, place - range.most_mm);
      if (beyond > excess) {
        excess = beyond;
        found = place;
      }
    }
    if (excess <= kTravelTolerance_mm) continue;
    report({.kind = Kind::travel_exceeded,
            .block = item.source,
            .axis = kAxisNames[axis],
            .found = found,
            .least = range.least_mm,
            .most = range.most_mm});
    if (order_.ends_at_travel) return end();
  }
}

/// The tip hangs below the path by the tool's length, whether it is compensated or not: that is the machine's concern
/// (COMP-016).
void TestRun::cut(const geometry::PathItem& item, const drawing::Stroke& stroke) {
  const double radius = tool_.radius_mm > 0 ? tool_.radius_mm : kNoToolRadius_mm;
  const auto tip = [&](const drawing::Spot& spot) {
    geometry::Point point = drawing::point_of(spot);
    point.z -= tool_.length_mm;
    return point;
  };
  bool has_met = false;
  for (std::size_t i = 1; i < stroke.spots.size(); ++i)
    has_met = stock_.cut(tip(stroke.spots[i - 1]), tip(stroke.spots[i]), radius) || has_met;
  if (!has_met) return;
  if (stroke.is_rapid) report({.kind = Kind::rapid_in_material, .block = item.source});
  if (!spindle_turns_) report({.kind = Kind::spindle_off_in_material, .block = item.source});
  if (tool_.radius_mm <= 0) report({.kind = Kind::tool_missing_in_material, .block = item.source});
}

void TestRun::report(Finding finding) {
  const bool is_known = std::ranges::any_of(findings_, [&](const Finding& told) {
    return told.kind == finding.kind && told.block == finding.block && told.axis == finding.axis;
  });
  if (is_known) return;
  if (findings_.size() < kMostFindings)
    findings_.push_back(std::move(finding));
  else
    ++findings_left_off_;
}

void TestRun::end() {
  has_ended_ = true;
  time_.finish();
}

double TestRun::progress() const {
  constexpr double kMostBeforeTheEnd = 0.99;  // a loop comes to the last block again and again
  if (has_ended_) return 1;
  return std::min(kMostBeforeTheEnd, static_cast<double>(main_index_) / static_cast<double>(main_blocks_));
}

drawing::Scene TestRun::scene() const {
  geometry::Point tip = position_;
  tip.z -= tool_.length_mm;
  return {.traces = {.path = path_, .contour = contour_},
          .workpiece = order_.workpiece,
          .relief = &stock_,
          .tool = tip,
          .tool_radius_mm = tool_.radius_mm > 0 ? tool_.radius_mm : kNoToolRadius_mm};
}

}  // namespace cnclab::testrun
