// The drawing of a test run at full resolution: what GRAFIK prints and what `cnclab-tool plot` writes.
#pragma once

#include <string>

#include "drawing/path_picture.hpp"
#include "language/units.hpp"
#include "testrun/test_run.hpp"

namespace cnclab::testrun {

/// All of it that was played so far, the whole part in the picture.
[[nodiscard]] drawing::Picture picture_of(const TestRun& test, drawing::View view, language::Tongue tongue);

}  // namespace cnclab::testrun
