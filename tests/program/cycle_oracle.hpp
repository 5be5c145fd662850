// What the cycles must do, written from their step lists (CYC-081 to CYC-085, DEC-03): no parameter, no ROM program.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace cnclab::program {

/// The words of a cycle, and the cutter.
struct CycleWords {
  std::int64_t x_um = 0, y_um = 0, z_um = 0, q_um = 0, r_um = 0;
  int v_mm = 1, h_tenths = 0, d_degrees = 0, w_holes = 1;
  std::int64_t cutter_um = 0;
};

/// A step in µm from the point on the surface (Z 0) under the place of the call.
struct IdealStep {
  std::string what;
  std::array<double, 3> at_um{};
  int tenths = 0;
};

/// Keeps the place between steps. A way of no length is no step.
class IdealCycle {
 public:
  explicit IdealCycle(const CycleWords& words)
      : words_(words), safety_um_(words.v_mm * 1000.0), at_{0, 0, safety_um_} {}

  /// G81, or G82 with Q: "rapid to +0.5, feed to Q, rapid to V, rapid to Q + 0.5, feed to 2Q, …, remaining way to Z,
  /// dwell, rapid to V".
  void drill(bool has_q) {
    const auto depth = static_cast<double>(words_.z_um);
    const double cut = has_q ? static_cast<double>(words_.q_um) : depth;
    for (double floor = 0; floor > depth;) {
      to_z("rapid", floor + 500);
      floor = std::max(floor + cut, depth);
      to_z("feed", floor);
      if (floor == depth) dwell();
      to_z("rapid", safety_um_);
    }
  }

  void thread() {
    event("cw");
    to_z("rapid", 500);
    to_z("feed", static_cast<double>(words_.z_um));
    event("off");
    dwell();
    event("ccw");
    to_z("feed", safety_um_);
    event("off");
  }

  /// The slot lies along `axis`, 0 or 1.
  void slot(std::size_t axis) {
    const std::int64_t length = axis == 0 ? words_.x_um : words_.y_um;
    double end = -static_cast<double>(length - 2 * words_.cutter_um) / 2;
    const auto depth = static_cast<double>(words_.z_um);
    to("rapid", axis, end);
    for (double floor = 0; floor > depth;) {
      to_z("rapid", floor + 500);
      floor = std::max(floor + static_cast<double>(words_.q_um), depth);
      to_z("feed", floor);
      end = -end;
      to("feed", axis, end);
      to_z("rapid", safety_um_);
    }
    to("rapid", axis, 0);
  }

  /// W holes from D on, counterclockwise, each as G82 or G81; back to the centre.
  void hole_circle(bool has_q) {
    for (int hole = 0; hole < words_.w_holes; ++hole) {
      const double angle = (words_.d_degrees + 360.0 * hole / words_.w_holes) / 180 * std::numbers::pi;
      const auto radius = static_cast<double>(words_.r_um);
      to_xy(radius * std::cos(angle), radius * std::sin(angle));
      drill(has_q);
    }
    to_xy(0, 0);
  }

  [[nodiscard]] const std::vector<IdealStep>& steps() const { return steps_; }

 private:
  void to(const std::string& what, std::size_t axis, double value_um) {
    if (at_[axis] == value_um) return;
    at_[axis] = value_um;
    event(what);
  }
  void to_z(const std::string& what, double value_um) { to(what, 2, value_um); }
  void to_xy(double x_um, double y_um) {
    at_[0] = x_um;
    at_[1] = y_um;
    event("rapid");
  }
  void event(const std::string& what) { steps_.push_back({.what = what, .at_um = at_}); }
  void dwell() {
    if (words_.h_tenths == 0) return;
    event("dwell");
    steps_.back().tenths = words_.h_tenths;
  }

  CycleWords words_;
  double safety_um_;
  std::array<double, 3> at_;
  std::vector<IdealStep> steps_;
};

}  // namespace cnclab::program
