// A graphic test run that is played by long work, portion after portion, while the mode shows what has come so far.
//
//   mode ── advance(blocks, window) ──▶ job: plays, draws ──▶ view ── take_view ──▶ mode
//
// Only one job is under way at a time; the test run belongs to it, and to nobody while there is none. Everything that
// the screen needs comes back as a value.
#pragma once

#include <atomic>
#include <expected>
#include <memory>
#include <optional>
#include <vector>

#include "drawing/graphic_view.hpp"
#include "panel/media.hpp"
#include "panel/run/long_work.hpp"
#include "testrun/test_run.hpp"

namespace cnclab::panel {

/// What was to be seen when a portion was over.
struct GraphicTestView {
  drawing::BrailleCanvas canvas;
  drawing::View view = drawing::View::xy;  ///< from where it is seen on the canvas
  geometry::SourceBlock block;
  double progress = 0;  ///< 0..1
  double path_mm = 0, machine_time_s = 0;
  std::vector<testrun::Finding> findings;
  std::size_t findings_left_off = 0;
  bool has_ended = false;
  bool is_picture_cut = false;
};

class GraphicTest {
 public:
  /// errors   the program cannot be started at all
  [[nodiscard]] static std::expected<GraphicTest, language::Error> begin(testrun::TestOrder order, LongWork long_work);
  ~GraphicTest();
  GraphicTest(GraphicTest&&) noexcept = default;
  GraphicTest& operator=(GraphicTest&&) noexcept = default;
  GraphicTest(const GraphicTest&) = delete;
  GraphicTest& operator=(const GraphicTest&) = delete;

  /// Is a portion under way?
  [[nodiscard]] bool is_busy() const;
  /// Is there anything to come: a portion under way, or its view not taken?
  [[nodiscard]] bool has_news() const { return is_busy() || is_view_due_; }
  /// Plays up to so many blocks, fewer where they are long; 0 only draws. Not while busy.
  void advance(std::uint64_t blocks, const drawing::Window& window);
  /// What the last portion has left to see; once.
  [[nodiscard]] std::optional<GraphicTestView> take_view();
  /// Draws the picture at full resolution, as "GRAFIK-P0001-XY.svg" and ".pdf"; not while busy.
  void draw_files(drawing::View view, language::Tongue tongue);
  /// The files, once.
  [[nodiscard]] std::optional<PutFiles> take_files();

 private:
  struct Shared;
  GraphicTest(std::shared_ptr<Shared> shared, LongWork long_work);

  std::shared_ptr<Shared> shared_;
  LongWork long_work_;
  bool is_view_due_ = false;  ///< of the newest portion
  std::uint64_t most_ways_;   ///< of the next portion
};

}  // namespace cnclab::panel
