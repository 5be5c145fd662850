// The graphic test run: a program is played at full speed on a copy of the control's state, without a machine
// (SYS-011, MOD-071). What it finds wrong it says in words; what it draws is drawing::Scene's.
//
//   PathSource ──items──▶ travel, feed, tool, spindle ──▶ Stock      findings
//                   └──▶ MachineTime                                 time and path length
//                   └──▶ strokes                                     picture
//
// Rules
//  1. It is advanced in portions of blocks, on whatever thread its owner likes; between portions it may be drawn, asked
//     and thrown away. It holds no more than some megabytes, however long the program is.
//  2. Input 1 is inactive, halts and waits are passed.
//  3. It ends where the control would: at the program's end, an error, a limit switch; and at the limits of the order.
//  4. Each finding is told once for a block.
//  5. A contour that is longer than the order allows is checked in parts, and that is told: what cuts into a wall of an
//     earlier part is not found.
#pragma once

#include <cstdint>
#include <expected>
#include <vector>

#include "drawing/graphic_view.hpp"
#include "drawing/strokes.hpp"
#include "geometry/contour_check.hpp"
#include "machine/machine_data.hpp"
#include "program/path_source.hpp"
#include "testrun/finding.hpp"
#include "testrun/machine_time.hpp"
#include "testrun/stock.hpp"

namespace cnclab::testrun {

struct TravelRange {
  double least_mm = 0, most_mm = 0;
};

/// What is tested; values, taken at its beginning (DEC-28).
struct TestOrder {
  program::ProgramSet programs;
  program::Settings settings;
  program::Start start;
  machine::MachineData data;
  drawing::Box workpiece;               ///< in path coordinates (DEC-24)
  double cell_mm = 0.25;                ///< of its grid, > 0
  std::array<TravelRange, 3> travel{};  ///< where the switches of X, Y, Z stand, path coordinates
  bool ends_at_travel = true;           ///< false: goes on behind a limit switch, as if there were none
  std::uint64_t most_blocks = 200'000;  ///< then it counts as endless
  double most_machine_s = 36'000;       ///< then it is broken off: ten hours
  std::size_t most_spots = 50'000;      ///< kept of the path, and of the contour, for the picture; 12 bytes each
  std::size_t longest_contour = 2000;   ///< blocks of a contour that are checked as a whole; 400 bytes each
};

/// Travel of a machine whose axes stand in the middle at the start (DEC-23).
[[nodiscard]] std::array<TravelRange, 3> travel_about(const geometry::Point& start, const machine::MachineData& data);

class TestRun {
 public:
  static constexpr std::size_t kMostFindings = 200;

  /// errors   as PathSource::begin: the program cannot be started at all
  [[nodiscard]] static std::expected<TestRun, language::Error> begin(TestOrder order);

  /// Executes up to so many blocks; does nothing after the end.
  void advance(std::uint64_t blocks);

  [[nodiscard]] bool has_ended() const { return has_ended_; }
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] std::size_t findings_left_off() const { return findings_left_off_; }
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  /// Straight ways so far, arcs counted by their chords: what the time of a test run grows with.
  [[nodiscard]] std::uint64_t ways() const { return ways_; }
  /// The one that was started.
  [[nodiscard]] std::uint16_t program() const { return order_.start.program; }
  /// The block executed last; where there is none, the one that cannot be executed.
  [[nodiscard]] geometry::SourceBlock block() const { return block_; }
  /// Done of the main program's blocks, 0..1: jumps make it go back. 1 only at the end.
  [[nodiscard]] double progress() const;
  [[nodiscard]] double path_mm() const { return path_mm_; }
  [[nodiscard]] double machine_time_s() const {
    return time_.seconds();
  }  ///< ramps of the newest ways are missing before the end
  [[nodiscard]] const program::ModalState& modal() const { return source_.interpreter().modal(); }
  [[nodiscard]] const Stock& stock() const { return stock_; }
  /// Is the path longer than what is kept of it for the picture? Its newest part is missing then.
  [[nodiscard]] bool is_picture_cut() const { return spots_ > order_.most_spots || contour_spots_ > order_.most_spots; }
  /// Everything there is to see now. It looks at this object, which must not change meanwhile.
  [[nodiscard]] drawing::Scene scene() const;

 private:
  TestRun(program::PathSource source, TestOrder order);
  void execute_block();
  void follow_contour();
  void take(const geometry::PathItem& item);
  void keep(const geometry::PathItem& item, std::vector<drawing::Stroke>& strokes, std::size_t& spots) const;
  void take_way(const geometry::PathItem& item);
  void take_tool(const geometry::PathItem& item, const geometry::ToolChange& tool);
  void check_travel(const geometry::PathItem& item, const drawing::Stroke& stroke);
  void cut(const geometry::PathItem& item, const drawing::Stroke& stroke);
  void report(Finding finding);
  void end();

  TestOrder order_;
  program::PathSource source_;
  MachineTime time_;
  Stock stock_;
  std::vector<geometry::PathItem> items_;  ///< of the newest block
  std::vector<drawing::Stroke> path_, contour_;
  std::size_t spots_ = 0, contour_spots_ = 0;
  geometry::ContourCheck check_;
  std::size_t gouges_ = 0;          ///< findings of check_ that were told
  std::size_t contour_blocks_ = 0;  ///< of the contour that is followed now
  std::vector<Finding> findings_;
  std::size_t findings_left_off_ = 0;
  std::uint64_t blocks_ = 0, ways_ = 0;
  geometry::SourceBlock block_;
  std::size_t main_index_ = 0, main_blocks_ = 1;
  geometry::Point position_;
  geometry::ToolChange tool_;
  bool spindle_turns_ = false;
  double path_mm_ = 0;
  bool has_ended_ = false;
};

}  // namespace cnclab::testrun
