// Short names of stream items, so that a test can write down what must come out: "spindle cw 500", "line", "mark" …
#pragma once

#include <array>
#include <string>
#include <vector>

#include "run_text.hpp"

namespace cnclab::program {

struct Namer {
  std::string operator()(const geometry::Line& line) const { return line.is_rapid ? "rapid" : "line"; }
  std::string operator()(const geometry::Arc&) const { return "arc"; }
  std::string operator()(const geometry::Dwell& dwell) const { return "dwell " + number(dwell.seconds); }
  std::string operator()(const geometry::Spindle& spindle) const {
    if (spindle.turn == geometry::SpindleTurn::off) return "spindle off";
    return (spindle.turn == geometry::SpindleTurn::clockwise ? "spindle cw " : "spindle ccw ") + number(spindle.rpm);
  }
  std::string operator()(const geometry::Coolant& coolant) const { return coolant.on ? "coolant on" : "coolant off"; }
  std::string operator()(const geometry::ToolChange& tool) const {
    return "tool " + number(tool.number) + " R" + number(tool.radius_mm) + " L" + number(tool.length_mm);
  }
  std::string operator()(const geometry::Output& output) const {
    return "output " + number(output.card) + "." + number(output.line) + (output.on ? " on" : " off");
  }
  std::string operator()(const geometry::Wait& wait) const {
    return "wait " + number(wait.card) + "." + number(wait.line);
  }
  std::string operator()(const geometry::SetActual&) const { return "set"; }
  std::string operator()(const geometry::Reference&) const { return "reference"; }
  std::string operator()(const geometry::Halt& halt) const { return halt.signal ? "halt signal" : "halt"; }
  std::string operator()(const geometry::Signal&) const { return "signal"; }
  std::string operator()(const geometry::SpindleDigits& digits) const { return "digits " + number(digits.rpm); }
  std::string operator()(const geometry::End&) const { return "end"; }
  std::string operator()(const geometry::Mark&) const { return "mark"; }
  std::string operator()(const geometry::RadiusOffset& offset) const {
    constexpr std::array kSides{"off", "left", "right", "plus", "minus"};
    return std::string("radius ") + kSides.at(static_cast<std::size_t>(offset.side)) + " " + number(offset.radius_mm) +
           in(offset.plane);
  }
  std::string operator()(const geometry::LengthOffset& offset) const {
    return "length " + number(offset.length_mm) + in(offset.plane);
  }
  std::string operator()(const geometry::CornerRounding& corner) const { return "round " + number(corner.radius_mm); }
  static std::string in(geometry::Plane plane) {
    return plane == geometry::Plane::xy ? " xy" : plane == geometry::Plane::xz ? " xz" : " yz";
  }
  static std::string number(double value) {
    std::string text;
    geometry::append_number(text, value);
    return text;
  }
};
/// The names of all items of a run.
inline std::vector<std::string> names_of(const RunResult& result) {
  std::vector<std::string> names;
  for (const geometry::PathItem& item : result.items) names.push_back(std::visit(Namer{}, item.what));
  return names;
}

}  // namespace cnclab::program
