// Where the block of a picture and the workpiece of the machine meet.
#include "testrun/stock.hpp"

#include <algorithm>

namespace cnclab::testrun {

namespace {

/// Material thinner than this is no cut: the same way passed twice, or the chord of an arc beside it.
constexpr double kThinnest_mm = 0.02;

}  // namespace

Stock::Stock(const drawing::Box& block, double cell_mm) : block_(block) {
  const geometry::Point& low = block.low;
  const geometry::Point& high = block.high;
  const machine::WorkpieceSpec spec{{high.x - low.x, high.y - low.y, high.z - low.z}, cell_mm};
  auto piece = machine::Workpiece::make(machine::fitted(spec), {(low.x + high.x) / 2, (low.y + high.y) / 2, high.z, 0});
  if (piece) piece_ = std::move(*piece);
}

bool Stock::cut(const geometry::Point& from, const geometry::Point& to, double radius_mm) {
  return piece_ && piece_->cut(from, to, radius_mm, piece_->cell_mm()).contact_mm > kThinnest_mm;
}

/// On the block's far edges the last cell counts.
double Stock::height_mm(double x_mm, double y_mm) const {
  if (!piece_) return block_.high.z;
  const double half_cell = piece_->cell_mm() / 2;
  const double x = std::clamp(x_mm, block_.low.x, block_.high.x - half_cell);
  const double y = std::clamp(y_mm, block_.low.y, block_.high.y - half_cell);
  return piece_->surface_z(x, y).value_or(block_.high.z);
}

}  // namespace cnclab::testrun
