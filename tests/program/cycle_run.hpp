// Runs one cycle from a place, and reads what comes out as the steps of its description.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "run_text.hpp"

namespace cnclab::program {

/// One motion or event of a cycle.
struct Step {
  std::string what;         ///< rapid, feed, dwell, cw, ccw, off
  Nanometres at{};          ///< place after it
  std::int64_t tenths = 0;  ///< of a second; dwell only
  int block = 0;            ///< of the ROM program

  [[nodiscard]] std::string text() const {
    std::string result = "N" + std::to_string(block) + ' ' + what;
    if (what == "dwell") result += ' ' + std::to_string(tenths);
    if (what != "rapid" && what != "feed") return result;
    for (const std::int64_t nm : at) geometry::append_number(result += ' ', static_cast<double>(nm) / 1e6);
    return result;
  }
};

inline std::vector<Step> steps_of(const std::vector<geometry::PathItem>& items, Nanometres at) {
  std::vector<Step> steps;
  const auto nm = [](double mm) { return std::llround(mm * 1e6); };
  for (const geometry::PathItem& item : items) {
    Step step{.what = {}, .at = at, .tenths = 0, .block = item.source.block};
    if (const auto* line = std::get_if<geometry::Line>(&item.what)) {
      step.what = line->is_rapid ? "rapid" : "feed";
      step.at = at = {nm(line->to.x), nm(line->to.y), nm(line->to.z)};
    } else if (const auto* dwell = std::get_if<geometry::Dwell>(&item.what)) {
      step.what = "dwell";
      step.tenths = std::llround(dwell->seconds * 10);
    } else if (const auto* spindle = std::get_if<geometry::Spindle>(&item.what)) {
      using enum geometry::SpindleTurn;
      step.what = spindle->turn == clockwise ? "cw" : spindle->turn == counterclockwise ? "ccw" : "off";
    } else {
      continue;
    }
    steps.push_back(step);
  }
  return steps;
}

inline std::vector<std::string> texts_of(const std::vector<Step>& steps) {
  std::vector<std::string> texts;
  for (const Step& step : steps) texts.push_back(step.text());
  return texts;
}

/// What a cycle stands on: F 300, tool T01, the place of the call.
inline Start start_at(double x, double y, double z) {
  Start start;
  start.position = {.x = x, .y = y, .z = z};
  start.modal.feed_mm_per_min = 300;
  start.modal.tool = 1;
  return start;
}

/// A program of this one block, with a cutter of this radius.
inline RunResult run_cycle(const std::string& block, const Start& start, std::int64_t radius_um = 5000) {
  return run_text("P0000T001R+" + std::to_string(radius_um) + "L+0\nP0001N001" + block + "%", 100'000, start);
}

inline std::vector<Step> cycle_steps(const RunResult& run, const Start& start) {
  const auto nm = [](double mm) { return std::llround(mm * 1e6); };
  return steps_of(run.items, {nm(start.position.x), nm(start.position.y), nm(start.position.z)});
}

}  // namespace cnclab::program
