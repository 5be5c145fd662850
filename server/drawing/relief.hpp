// The surface of a workpiece as pictures need it, and how dark each place of a picture is because of what was removed.
#pragma once

#include <vector>

#include "drawing/projection.hpp"

namespace cnclab::drawing {

/// A workpiece with material removed from above: over each place of its block the material reaches up to one height.
class Relief {
 public:
  virtual ~Relief() = default;
  [[nodiscard]] virtual Box block() const = 0;
  /// Path coordinates inside the block, mm; between the block's low and high Z.
  [[nodiscard]] virtual double height_mm(double x_mm, double y_mm) const = 0;
};

/// A raster over a field of the picture: row 0 at the top, mm to the right and up.
struct Raster {
  Bounds field;
  int columns = 1, rows = 1;
};

/// Darkness of each cell of the raster, 0 (untouched, or not of the workpiece) to 1; row by row.
///
///   XY       depth removed of the block's thickness
///   XZ, YZ   share of the material along the line of sight that is gone
///   iso      the surface's depth as in XY, walls half dark; what lies in front hides what is behind
[[nodiscard]] std::vector<float> shades_of(const Relief& relief, View view, const Raster& raster);

}  // namespace cnclab::drawing
