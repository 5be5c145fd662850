// How the numbers become items and machine data, and how they are printed.
#include "random_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <ostream>
#include <string_view>

namespace cnclab::machine {

namespace {

using geometry::Point;

constexpr double kRadian = std::numbers::pi / 180;
constexpr int kChainLinks = 40;
constexpr int kDustGrains = 60;

struct Axes {
  double Point::*first, Point::*second, Point::*normal;
};

/// In the order in which a turn from the first to the second is counterclockwise (D-128).
Axes axes_of(int plane) {
  switch (plane % 3) {
    case 1:
      return {&Point::z, &Point::x, &Point::y};
    case 2:
      return {&Point::y, &Point::z, &Point::x};
    default:
      return {&Point::x, &Point::y, &Point::z};
  }
}

class Builder {
 public:
  void add(const Element& element);
  void end() { push(geometry::End{}, {}); }
  [[nodiscard]] std::vector<geometry::PathItem> take() { return std::move(items_); }

 private:
  void push(auto what, const Element& element) {
    geometry::PathItem item;
    item.what = what;
    item.sequence = items_.size() + 1;
    item.source = {1, static_cast<std::uint16_t>(item.sequence % 999 + 1)};
    item.ends_block = element.ends_block;
    item.exact_stop = element.exact_stop;
    item.override_off = element.override_off;
    items_.push_back(item);
  }
  void line_by(const Element& element, double way_mm, double heading, double rise_mm, bool rapid = false) {
    const Axes axes = axes_of(element.plane);
    Point to = at_;
    to.*axes.first += way_mm * std::cos(heading);
    to.*axes.second += way_mm * std::sin(heading);
    to.*axes.normal += rise_mm;
    push(geometry::Line{at_, to, 1.0 + element.feed, rapid}, element);
    at_ = to;
  }
  void arc(const Element& element);
  void event(const Element& element);

  std::vector<geometry::PathItem> items_;
  Point at_;
};

void Builder::arc(const Element& element) {
  const double radius = (1 + std::abs(element.way_um)) / 1000.0;
  const double heading = element.heading_deg * kRadian;
  const Axes axes = axes_of(element.plane);
  Point center = at_, to = at_;
  center.*axes.first += radius * std::cos(heading);
  center.*axes.second += radius * std::sin(heading);
  const bool is_spiral = element.kind == Element::Kind::spiral;
  if (element.turn_deg % 360 != 0 || is_spiral) {
    const int turn = element.turn_deg % 360 != 0 ? element.turn_deg : 1;
    const double end = heading + std::numbers::pi + turn * kRadian;
    constexpr int kOff_um = 20;
    const double off = is_spiral ? (std::abs(element.way_um) % (2 * kOff_um + 1) - kOff_um) / 1000.0 : 0;
    const double end_radius = std::max(radius + off, radius / 2);
    to.*axes.first = center.*axes.first + end_radius * std::cos(end);
    to.*axes.second = center.*axes.second + end_radius * std::sin(end);
  }
  to.*axes.normal += element.rise_um / 1000.0;
  const auto turn = element.turn_deg >= 0 ? geometry::Turn::counterclockwise : geometry::Turn::clockwise;
  constexpr std::array kPlanes{geometry::Plane::xy, geometry::Plane::xz, geometry::Plane::yz};
  const auto plane = kPlanes[static_cast<std::size_t>(element.plane % 3)];
  push(geometry::Arc{at_, to, center, turn, plane, 1.0 + element.feed}, element);
  at_ = to;
}

void Builder::event(const Element& element) {
  using Kind = Element::Kind;
  const int number = std::abs(element.way_um);
  if (element.kind == Kind::dwell) push(geometry::Dwell{number % 300 / 1000.0}, element);
  if (element.kind == Kind::spindle) {
    const bool off = number % 3 == 0;
    push(geometry::Spindle{off ? geometry::SpindleTurn::off : geometry::SpindleTurn::clockwise, 100.0 + number},
         element);
  }
  if (element.kind == Kind::coolant) push(geometry::Coolant{number % 2 == 0}, element);
  if (element.kind == Kind::mark) push(geometry::Mark{}, element);
  if (element.kind == Kind::output) push(geometry::Output{1 + number % 2, number % 9, number % 3 != 0}, element);
  if (element.kind == Kind::rename) push(geometry::SetActual{{true, false, true}, {number / 1000.0, 0, 7}}, element);
  if (element.kind == Kind::wait) push(geometry::Wait{0, 0}, element);
  if (element.kind == Kind::halt) push(geometry::Halt{number % 2 == 0}, element);
  if (element.kind == Kind::signal) push(geometry::Signal{}, element);
  if (element.kind == Kind::reference) {
    const int axes = 1 + number % 7;  // one bit each
    const double side = element.turn_deg < 0 ? -1 : 1;
    push(geometry::Reference{{(axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0}, {side, side, side}}, element);
    items_.back().ends_block = true;  // the snapshot tells its end by the block's
  }
}

void Builder::add(const Element& element) {
  const double heading = element.heading_deg * kRadian, turn = element.turn_deg * kRadian;
  const double way = element.way_um / 1000.0, rise = element.rise_um / 1000.0;
  switch (element.kind) {
    case Element::Kind::line:
    case Element::Kind::rapid:
      return line_by(element, way, heading, rise, element.kind == Element::Kind::rapid);
    case Element::Kind::arc:
    case Element::Kind::spiral:
      return arc(element);
    case Element::Kind::chain:
      for (int i = 0; i < kChainLinks; ++i) {
        line_by(element, way / kChainLinks, heading + turn * i / kChainLinks, rise / kChainLinks);
      }
      return;
    case Element::Kind::dust:
      for (int i = 0; i < kDustGrains; ++i) line_by(element, way / 10'000, heading + i * turn, rise / 10'000);
      return;
    case Element::Kind::fourth_axis: {
      Point to = at_;
      to.u += way;
      push(geometry::Line{at_, to, 1.0 + element.feed, false}, element);
      at_ = to;
      return;
    }
    case Element::Kind::dwell:
    case Element::Kind::spindle:
    case Element::Kind::coolant:
    case Element::Kind::mark:
    case Element::Kind::output:
    case Element::Kind::rename:
    case Element::Kind::wait:
    case Element::Kind::halt:
    case Element::Kind::signal:
    case Element::Kind::reference:
      return event(element);
  }
}

constexpr std::array<std::string_view, 17> kElementNames{
    "line",    "rapid", "arc",    "spiral", "chain", "dust", "fourth_axis", "dwell",    "spindle",
    "coolant", "mark",  "output", "rename", "wait",  "halt", "signal",      "reference"};
constexpr std::array<std::string_view, 19> kActionNames{
    "stop",   "go",        "potentiometer", "single_block", "power_off", "power_on",     "fault",
    "revoke", "expire",    "grant",         "stale_go",     "halt",      "release_halt", "abandon",
    "jog",    "reference", "input",         "begin_again",  "feed"};

}  // namespace

MachineData data_of(const Setup& setup) {
  MachineData data;
  const int start_stop = std::min(setup.start_stop, setup.f_max);
  const auto set = [&data](int number, std::int64_t value) {
    if (!data.set(number, value)) std::abort();
  };
  set(10, 1);
  set(6, setup.f_max);
  set(10, start_stop);
  set(9, setup.stop_delay);
  set(11, setup.creep_um);
  set(12, setup.ramp);
  for (int axis = 0; axis < 3; ++axis) set(3 + axis, setup.travel_um);
  for (int axis = 0; axis < 4; ++axis) set(14 + axis, setup.steps_per_mm[static_cast<std::size_t>(axis)]);
  return data;
}

std::vector<geometry::PathItem> items_of(const std::vector<Element>& elements) {
  Builder builder;
  for (const Element& element : elements) builder.add(element);
  builder.end();
  return builder.take();
}

std::ostream& operator<<(std::ostream& out, const Element& e) {
  out << '{' << kElementNames[static_cast<std::size_t>(e.kind)] << " heading " << e.heading_deg << " turn "
      << e.turn_deg << " way " << e.way_um << " rise " << e.rise_um << " plane " << e.plane << " F" << e.feed + 1;
  return out << (e.exact_stop ? " exact" : "") << (e.override_off ? " M23" : "") << (e.ends_block ? "" : " …") << '}';
}

std::ostream& operator<<(std::ostream& out, const Action& a) {
  return out << '{' << kActionNames[static_cast<std::size_t>(a.kind)] << " after " << a.after << " value " << a.value
             << '}';
}

std::ostream& operator<<(std::ostream& out, const Setup& s) {
  out << "F MAX " << s.f_max << " F START/STOP " << s.start_stop << " RAMPE " << s.ramp << " STOPVERZÖGERUNG "
      << s.stop_delay << " SCHLEICHWEG " << s.creep_um << " travel " << s.travel_um << " steps/mm";
  for (const int per_mm : s.steps_per_mm) out << ' ' << per_mm;
  return out << " fed " << s.fed_at_once << " planned " << s.plan_every;
}

std::ostream& operator<<(std::ostream& out, const RandomRun& run) {
  out << run.setup << "\nprogram:";
  for (const auto& element : run.elements) out << "\n  " << element;
  out << "\noperator:";
  for (const auto& action : run.actions) out << "\n  " << action;
  return out << '\n';
}

}  // namespace cnclab::machine
