// Portions of a test run, and the handing over of their views.
#include "panel/graphic_test.hpp"

#include <algorithm>
#include <utility>

namespace cnclab::panel {

namespace {

/// So many blocks between two looks at whether anybody still wants the result.
constexpr std::uint64_t kBlocksBetween = 20;

GraphicTestView view_of(const testrun::TestRun& test, const drawing::Window& window) {
  return {.canvas = draw_scene(test.scene(), window),
          .block = test.block(),
          .progress = test.progress(),
          .path_mm = test.path_mm(),
          .machine_time_s = test.machine_time_s(),
          .findings = test.findings(),
          .findings_left_off = test.findings_left_off(),
          .has_ended = test.has_ended(),
          .is_picture_cut = test.is_picture_cut()};
}

}  // namespace

struct GraphicTest::Shared {
  explicit Shared(testrun::TestRun begun) : test(std::move(begun)) {}

  testrun::TestRun test;                ///< the job's while it is busy
  std::optional<GraphicTestView> view;  ///< written by the job before it is busy no more
  std::atomic<bool> is_busy = false, is_abandoned = false;
};

std::expected<GraphicTest, language::Error> GraphicTest::begin(testrun::TestOrder order, LongWork long_work) {
  auto test = testrun::TestRun::begin(std::move(order));
  if (!test) return std::unexpected(test.error());
  return GraphicTest(std::make_shared<Shared>(std::move(*test)), std::move(long_work));
}

GraphicTest::GraphicTest(std::shared_ptr<Shared> shared, LongWork long_work)
    : shared_(std::move(shared)), long_work_(std::move(long_work)) {}

GraphicTest::~GraphicTest() {
  if (shared_) shared_->is_abandoned = true;
}

bool GraphicTest::is_busy() const { return shared_->is_busy.load(std::memory_order_acquire); }

void GraphicTest::advance(std::uint64_t blocks, const drawing::Window& window) {
  shared_->is_busy.store(true, std::memory_order_relaxed);
  long_work_([shared = shared_, blocks, window] {
    for (std::uint64_t left = blocks; left > 0 && !shared->test.has_ended() && !shared->is_abandoned;) {
      const std::uint64_t portion = std::min(left, kBlocksBetween);
      shared->test.advance(portion);
      left -= portion;
    }
    if (!shared->is_abandoned) shared->view = view_of(shared->test, window);
    shared->is_busy.store(false, std::memory_order_release);
  });
}

std::optional<GraphicTestView> GraphicTest::take_view() {
  if (is_busy()) return std::nullopt;
  return std::exchange(shared_->view, std::nullopt);
}

}  // namespace cnclab::panel
