// Pictures as SVG files.
#pragma once

#include <string>

#include "drawing/picture.hpp"

namespace cnclab::drawing {

/// The whole file. Words are escaped here.
[[nodiscard]] std::string svg_of(const Picture& picture);

}  // namespace cnclab::drawing
