// A scene as a sheet of paper.
#include "testrun/test_picture.hpp"

#include <fmt/format.h>

namespace cnclab::testrun {

namespace {

drawing::Captions captions_of(language::Tongue tongue) {
  if (tongue == language::Tongue::german) return {};
  return {
      .start = "start", .end = "end", .feed = "feed", .rapid = "rapid", .workpiece = "workpiece", .contour = "contour"};
}

}  // namespace

drawing::Picture picture_of(const TestRun& test, drawing::View view, language::Tongue tongue) {
  const drawing::Scene scene = test.scene();
  return drawing::path_picture(scene.traces, {.title = fmt::format("P{:04}", test.program()),
                                              .view = view,
                                              .workpiece = scene.workpiece,
                                              .relief = scene.relief,
                                              .captions = captions_of(tongue)});
}

}  // namespace cnclab::testrun
