// Portions of a test run, and the handing over of their views.
#include "panel/modes/graphic_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "drawing/pdf.hpp"
#include "drawing/svg.hpp"
#include "testrun/test_picture.hpp"

namespace cnclab::panel {

namespace {

/// Ways of the first portion, and of the largest: 2 and 20 ms (measured). So the first picture comes at once though
/// fifteen begin together, and a long program is not held up by its pictures.
constexpr std::uint64_t kFirstWays = 100, kMostWays = 1000;

GraphicTestView view_of(const testrun::TestRun& test, const drawing::Window& window) {
  return {.canvas = draw_scene(test.scene(), window),
          .view = window.view,
          .block = test.block(),
          .progress = test.progress(),
          .path_mm = test.path_mm(),
          .machine_time_s = test.machine_time_s(),
          .findings = test.findings(),
          .findings_left_off = test.findings_left_off(),
          .has_ended = test.has_ended(),
          .is_picture_cut = test.is_picture_cut()};
}

PutFiles files_of(const testrun::TestRun& test, drawing::View view, language::Tongue tongue) {
  constexpr std::array<std::string_view, 4> kViews{"XY", "XZ", "YZ", "XYZ"};
  const drawing::Picture picture = testrun::picture_of(test, view, tongue);
  const std::string name = fmt::format("GRAFIK-P{:04}-{}", test.program(), kViews[static_cast<std::size_t>(view)]);
  PutFiles files{.files = {{name + ".svg", drawing::svg_of(picture)}}, .is_printed = true};
  if (auto pdf = drawing::pdf_of({&picture, 1})) files.files.push_back({name + ".pdf", std::move(*pdf)});
  return files;
}

}  // namespace

struct GraphicTest::Shared {
  explicit Shared(testrun::TestRun begun) : test(std::move(begun)) {}

  testrun::TestRun test;                ///< the job's while it is busy
  std::optional<GraphicTestView> view;  ///< written by the job before it is busy no more, as are …
  std::optional<PutFiles> files;        ///< … these
  std::atomic<bool> is_busy = false, is_abandoned = false;
};

std::expected<GraphicTest, language::Error> GraphicTest::begin(testrun::TestOrder order, LongWork long_work) {
  auto test = testrun::TestRun::begin(std::move(order));
  if (!test) return std::unexpected(test.error());
  return GraphicTest(std::make_shared<Shared>(std::move(*test)), std::move(long_work));
}

GraphicTest::GraphicTest(std::shared_ptr<Shared> shared, LongWork long_work)
    : shared_(std::move(shared)), long_work_(std::move(long_work)), most_ways_(kFirstWays) {}

GraphicTest::~GraphicTest() {
  if (shared_) shared_->is_abandoned = true;
}

bool GraphicTest::is_busy() const { return shared_->is_busy.load(std::memory_order_acquire); }

void GraphicTest::advance(std::uint64_t blocks, const drawing::Window& window) {
  shared_->is_busy.store(true, std::memory_order_relaxed);
  is_view_due_ = true;
  long_work_([shared = shared_, blocks, window, ways = most_ways_] {
    testrun::TestRun& test = shared->test;
    const std::uint64_t last_way = test.ways() + ways;
    for (std::uint64_t left = blocks; left > 0 && test.ways() < last_way && !shared->is_abandoned; --left)
      test.advance(1);
    if (!shared->is_abandoned) shared->view = view_of(shared->test, window);
    shared->is_busy.store(false, std::memory_order_release);
  });
  if (blocks > 0) most_ways_ = std::min(2 * most_ways_, kMostWays);
}

void GraphicTest::draw_files(drawing::View view, language::Tongue tongue) {
  shared_->is_busy.store(true, std::memory_order_relaxed);
  long_work_([shared = shared_, view, tongue] {
    if (!shared->is_abandoned) shared->files = files_of(shared->test, view, tongue);
    shared->is_busy.store(false, std::memory_order_release);
  });
}

std::optional<PutFiles> GraphicTest::take_files() {
  if (is_busy()) return std::nullopt;
  return std::exchange(shared_->files, std::nullopt);
}

std::optional<GraphicTestView> GraphicTest::take_view() {
  if (is_busy()) return std::nullopt;
  is_view_due_ = false;
  return std::exchange(shared_->view, std::nullopt);
}

}  // namespace cnclab::panel
