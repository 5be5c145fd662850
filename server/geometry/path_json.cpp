// Writes path elements and events as JSON, by hand: a program of 100 000 blocks prints in a moment.
#include "geometry/path_json.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <type_traits>

namespace cnclab::geometry {

namespace {

constexpr std::array<std::string_view, 3> kAxisNames{"x", "y", "z"};

void append_integer(std::string& text, std::int64_t value) {
  std::array<char, 24> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), result.ptr);
}

/// One object: `{"op":"…","program":…,"block":…` and then its fields.
class Object {
 public:
  Object(std::string& text, std::string_view op, SourceBlock source) : text_(text) {
    text_ += R"({"op":")";
    text_ += op;
    text_ += '"';
    integer("program", source.program);
    integer("block", source.block);
  }
  ~Object() { text_ += '}'; }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  void integer(std::string_view name, std::int64_t value) {
    key(name);
    append_integer(text_, value);
  }
  void number(std::string_view name, double value) {
    key(name);
    append_number(text_, value);
  }
  void boolean(std::string_view name, bool value) {
    key(name);
    text_ += value ? "true" : "false";
  }
  void word(std::string_view name, std::string_view value) {
    key(name);
    text_ += '"';
    text_ += value;
    text_ += '"';
  }
  void point(std::string_view name, const Point& point) {
    key(name);
    text_ += R"({"x":)";
    append_number(text_, point.x);
    text_ += R"(,"y":)";
    append_number(text_, point.y);
    text_ += R"(,"z":)";
    append_number(text_, point.z);
    text_ += '}';
  }
  void axes(const std::array<bool, 3>& named, const std::array<double, 3>& values) {
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis)
      if (named[axis]) number(kAxisNames[axis], values[axis]);
  }

 private:
  void key(std::string_view name) {
    text_ += ",\"";
    text_ += name;
    text_ += "\":";
  }
  std::string& text_;
};

std::string_view name_of(Turn turn) { return turn == Turn::clockwise ? "cw" : "ccw"; }

std::string_view name_of(SpindleTurn turn) {
  switch (turn) {
    case SpindleTurn::off:
      return "off";
    case SpindleTurn::clockwise:
      return "cw";
    case SpindleTurn::counterclockwise:
      return "ccw";
  }
  return "off";
}

std::string_view name_of(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return "xy";
    case Plane::xz:
      return "xz";
    case Plane::yz:
      return "yz";
  }
  return "xy";
}

/// Writes one object per kind of item.
struct Writer {
  std::string& text;
  const PathItem& item;

  bool operator()(const Line& line) const {
    if (item.is_fourth_axis) {
      Object object(text, "axis4", item.source);
      object.number("to", line.to.u);
      object.number("feed", line.feed_mm_per_min);
      return true;
    }
    Object object(text, line.is_rapid ? "rapid" : "line", item.source);
    object.point("from", line.from);
    object.point("to", line.to);
    object.number("feed", line.feed_mm_per_min);
    return true;
  }
  bool operator()(const Arc& arc) const {
    Object object(text, "arc", item.source);
    object.point("from", arc.from);
    object.point("to", arc.to);
    object.number("feed", arc.feed_mm_per_min);
    object.point("center", arc.center);
    object.word("turn", name_of(arc.turn));
    object.word("plane", name_of(arc.plane));
    return true;
  }
  bool operator()(const Dwell& dwell) const {
    Object(text, "dwell", item.source).number("seconds", dwell.seconds);
    return true;
  }
  bool operator()(const Spindle& spindle) const {
    Object object(text, "spindle", item.source);
    object.word("turn", name_of(spindle.turn));
    object.number("rpm", spindle.rpm);
    return true;
  }
  bool operator()(const Coolant& coolant) const {
    Object(text, "coolant", item.source).boolean("on", coolant.on);
    return true;
  }
  bool operator()(const ToolChange& tool) const {
    Object object(text, "tool", item.source);
    object.integer("number", tool.number);
    object.number("radius", tool.radius_mm);
    object.number("length", tool.length_mm);
    return true;
  }
  bool operator()(const Output& output) const {
    Object object(text, "output", item.source);
    object.integer("card", output.card);
    object.integer("line", output.line);
    object.boolean("on", output.on);
    return true;
  }
  bool operator()(const Wait& wait) const {
    Object object(text, "wait", item.source);
    object.integer("card", wait.card);
    object.integer("line", wait.line);
    return true;
  }
  bool operator()(const SetActual& set) const {
    Object(text, "set_actual", item.source).axes(set.axes, set.value);
    return true;
  }
  bool operator()(const Reference& reference) const {
    Object(text, "reference", item.source).axes(reference.axes, reference.value);
    return true;
  }
  bool operator()(const Halt& halt) const {
    Object(text, "halt", item.source).boolean("signal", halt.signal);
    return true;
  }
  bool operator()(const Signal&) const {
    const Object signal(text, "signal", item.source);
    return true;
  }
  bool operator()(const End&) const {
    const Object end(text, "end", item.source);
    return true;
  }
  bool operator()(const SpindleDigits&) const { return false; }
  bool operator()(const Mark&) const { return false; }
  bool operator()(const RadiusOffset&) const { return false; }
  bool operator()(const LengthOffset&) const { return false; }
  bool operator()(const CornerRounding&) const { return false; }
};

}  // namespace

void append_number(std::string& text, double value) {
  constexpr double kUnit = 1e9;
  constexpr double kLargest = 9e9;  // beyond this the digits behind the point no longer fit the integer
  std::array<char, 40> digits{};
  if (!(std::abs(value) < kLargest)) {
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), result.ptr);
    return;
  }
  const std::int64_t units = std::llround(value * kUnit);
  if (units < 0) text += '-';
  const std::int64_t size = units < 0 ? -units : units;
  append_integer(text, size / 1'000'000'000);
  std::int64_t rest = size % 1'000'000'000;
  if (rest == 0) return;
  text += '.';
  for (std::int64_t place = 100'000'000; rest != 0; place /= 10) {
    text += static_cast<char>('0' + rest / place);
    rest %= place;
  }
}

bool append_json(std::string& text, const PathItem& item) { return std::visit(Writer{text, item}, item.what); }

}  // namespace cnclab::geometry
