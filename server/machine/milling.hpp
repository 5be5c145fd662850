// What the tool does to the workpiece: points of its way in, cells and events out.
//
//   tick ── ToolPoint ──▶ CutFeed (bounded ring) ──▶ WorkpieceThread ──▶ Milling ──▶ Workpiece, events
//
// Milling itself knows no thread: the graphic test run feeds it with points of its own.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/path_item.hpp"
#include "machine/spsc_ring.hpp"
#include "machine/workpiece.hpp"

namespace cnclab::machine {

/// Where the tool's end is and what it is like there.
struct ToolPoint {
  std::uint64_t tick = 0;
  std::array<double, 3> mm{};  ///< Istwert coordinates of the run's start, tool length taken off
  double radius_mm = 0;        ///< 0: no tool was called; it is taken as thin as a cell
  geometry::SourceBlock source{};
  bool begins_run = false;  ///< a program starts here: a new piece is put under the tool (DEC-24)
  bool is_rapid = false;    ///< on the way to this point
  bool spindle_on = false;
  bool after_gap = false;  ///< points before this one were dropped: the way to it is unknown
};

/// One channel's points on their way to the thread. The tick pushes, one thread pops; neither waits.
struct CutFeed {
  static constexpr std::size_t kPoints = 8'192;  ///< 8 s of motion
  SpscRing<ToolPoint, kPoints> ring;
  std::atomic<std::uint64_t> dropped{0};  ///< points that found the ring full
};

struct MillingEvent {
  enum class Kind : std::uint8_t {
    rapid_in_material,        ///< G00 took material away
    spindle_off_in_material,  ///< so did a tool that did not turn
  };
  Kind kind{};
  std::uint64_t tick = 0;
  geometry::SourceBlock source;  ///< {0, 0}: by hand
  std::array<double, 3> mm{};
};

class Milling {
 public:
  /// Events beyond this many of a piece are only counted.
  static constexpr std::size_t kMostEvents = 256;
  /// What changes a cell by less is rounding, not contact.
  static constexpr double kTouch_mm = 0.01;
  /// The same way again differs by rounding to steps and by where its points were joined: by less than this. It is far
  /// below half a cell, by which the tool advances in a cut.
  static constexpr double kEdge_mm = 0.02;

  explicit Milling(const WorkpieceSpec& spec) : spec_(spec) {}

  /// From the next program start on.
  void set_spec(const WorkpieceSpec& spec) { spec_ = spec; }
  /// Points are joined until they are half a cell apart, or something else changes.
  void take(const ToolPoint& point);
  /// Cuts what was joined so far: before looking at the piece.
  void flush();

  /// nullptr before the first program start, and where the spec cannot be made. Large ones get larger cells.
  [[nodiscard]] const Workpiece* piece() const { return piece_.get(); }
  [[nodiscard]] const std::vector<MillingEvent>& events() const { return events_; }  ///< one per kind and block
  [[nodiscard]] std::uint64_t events_left_off() const { return events_left_off_; }

 private:
  void begin(const ToolPoint& point);
  void cut_to(const ToolPoint& point);
  void note(MillingEvent::Kind kind, const ToolPoint& point);

  WorkpieceSpec spec_;
  std::unique_ptr<Workpiece> piece_;
  std::vector<MillingEvent> events_;
  std::uint64_t events_left_off_ = 0;
  std::array<geometry::SourceBlock, 2> noted_{};  ///< by kind: the block noted last
  std::array<bool, 2> was_noted_{};
  bool has_place_ = false;
  ToolPoint cut_, newest_;  ///< cut up to here; known up to here
};

}  // namespace cnclab::machine
