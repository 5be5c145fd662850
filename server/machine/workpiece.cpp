// Row by row: which cells the tool's disc sweeps over, and how low it was there.
//
//        ╭───────────╮     The disc swept along a way is convex, so it meets a row in one interval: that of the disc at
//        │ a ─────▶ b │    the start, the disc at the end and the rectangle between them, whichever reach further.
//        ╰───────────╯
//
// Where the tool has just come to `a` at this depth, the disc there is empty already, and only what lies beyond it is
// looked at: chords of an arc and the ways of single ticks are far shorter than the tool is wide.
#include "machine/workpiece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cnclab::machine {

/// One straight way of the tool, in coordinates from the corner.
struct Workpiece::Way {
  geometry::Point from, to;
  double radius = 0;
  double edge = 0;
  double length_sq = 0;       ///< in X and Y
  bool is_start_cut = false;  ///< nothing is left above `from.z` within the radius about `from`

  struct Interval {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void include(double value) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  };

  void include_disc(const geometry::Point& center, double y, Interval& interval) const {
    const double off = y - center.y;
    if (std::abs(off) > radius) return;
    const double half = std::sqrt(radius * radius - off * off);
    interval.include(center.x - half);
    interval.include(center.x + half);
  }

  /// Where the row at `y` crosses the four sides of the rectangle.
  void include_rectangle(double y, Interval& interval) const {
    if (length_sq <= 0) return;
    const double scale = radius / std::sqrt(length_sq);
    const double nx = -(to.y - from.y) * scale, ny = (to.x - from.x) * scale;
    const std::array<std::array<double, 2>, 4> corners{
        {{from.x + nx, from.y + ny}, {to.x + nx, to.y + ny}, {to.x - nx, to.y - ny}, {from.x - nx, from.y - ny}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& a = corners[i];
      const auto& b = corners[(i + 1) % 4];
      if ((a[1] - y) * (b[1] - y) > 0) continue;
      if (a[1] == b[1]) {
        interval.include(a[0]);
        interval.include(b[0]);
      } else {
        interval.include(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
      }
    }
  }

  [[nodiscard]] Interval at(double y) const {
    Interval interval;
    include_disc(from, y, interval);
    include_disc(to, y, interval);
    include_rectangle(y, interval);
    return interval;
  }

  /// What of the row need not be looked at: a way that does not fall takes nothing from where it began.
  [[nodiscard]] Interval empty_at(double y) const {
    Interval interval;
    if (is_start_cut && to.z >= from.z) include_disc(from, y, interval);
    return interval;
  }

  /// The same way of a tool that is thinner by its edge.
  [[nodiscard]] Way without_edge() const {
    Way inner = *this;
    inner.radius -= std::min(edge, radius / 2);
    return inner;
  }

  /// Lowest Z of the end while the disc is over the place: at one end of the part of the way that is near enough.
  [[nodiscard]] double lowest_over(double x, double y) const {
    if (length_sq <= 0) return std::min(from.z, to.z);
    const double wx = to.x - from.x, wy = to.y - from.y;
    const double dx = x - from.x, dy = y - from.y;
    const double nearest = (dx * wx + dy * wy) / length_sq;
    const double cross = dx * wy - dy * wx;
    const double reach_sq = radius * radius / length_sq - cross * cross / (length_sq * length_sq);
    const double reach = std::sqrt(std::max(0.0, reach_sq));
    const double first = std::clamp(nearest - reach, 0.0, 1.0), last = std::clamp(nearest + reach, 0.0, 1.0);
    const double fall = to.z - from.z;
    return std::min(from.z + fall * first, from.z + fall * last);
  }
};

WorkpieceSpec fitted(WorkpieceSpec spec, double most_cells) {
  const double area_mm2 = std::max(spec.size_mm[0], 0.0) * std::max(spec.size_mm[1], 0.0);
  spec.cell_mm = std::max(spec.cell_mm, std::sqrt(area_mm2 / most_cells));
  return spec;
}

std::expected<Workpiece, WorkpieceError> Workpiece::make(const WorkpieceSpec& spec, const geometry::Point& top_center) {
  const auto& [x, y, z] = spec.size_mm;
  const bool is_positive = x > 0 && y > 0 && z > 0 && spec.cell_mm > 0;
  if (!is_positive) return std::unexpected(WorkpieceError::not_positive);
  const double columns = std::ceil(x / spec.cell_mm - 1e-9), rows = std::ceil(y / spec.cell_mm - 1e-9);
  if (!(columns * rows <= static_cast<double>(kMostCells))) return std::unexpected(WorkpieceError::too_many_cells);
  Workpiece piece;
  piece.columns_ = static_cast<std::size_t>(columns);
  piece.rows_ = static_cast<std::size_t>(rows);
  piece.cell_mm_ = spec.cell_mm;
  piece.full_height_mm_ = z;
  piece.corner_ = {top_center.x - x / 2, top_center.y - y / 2, top_center.z - z, 0};
  piece.heights_.assign(piece.columns_ * piece.rows_, static_cast<float>(z));
  return piece;
}

std::optional<double> Workpiece::surface_z(double x, double y) const {
  const double column = std::floor((x - corner_.x) / cell_mm_), row = std::floor((y - corner_.y) / cell_mm_);
  const bool is_inside =
      column >= 0 && row >= 0 && column < static_cast<double>(columns_) && row < static_cast<double>(rows_);
  if (!is_inside) return std::nullopt;
  const std::size_t index = static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
  return corner_.z + static_cast<double>(heights_[index]);
}

/// What the cell lost.
float Workpiece::lower(std::size_t index, double z) {
  const auto target = static_cast<float>(std::max(0.0, z));
  const float lost = heights_[index] - target;
  if (lost <= 0) return 0;
  heights_[index] = target;
  return lost;
}

void Workpiece::cut_row(std::size_t row, const Way& way, Cut& cut) {
  const double y = (static_cast<double>(row) + 0.5) * cell_mm_;
  const Way::Interval interval = way.at(y);
  const double first = std::max(0.0, std::ceil(interval.low / cell_mm_ - 0.5));
  const double last = std::min(static_cast<double>(columns_) - 1, std::floor(interval.high / cell_mm_ - 0.5));
  const Way::Interval empty = way.empty_at(y);
  if (!(empty.low <= empty.high)) return cut_columns(row, first, last, way, cut);
  cut_columns(row, first, std::min(last, std::ceil(empty.low / cell_mm_ - 0.5) - 1), way, cut);
  cut_columns(row, std::max(first, std::floor(empty.high / cell_mm_ - 0.5) + 1), last, way, cut);
}

/// The cells from column `first` to `last`; none where they are the other way about.
void Workpiece::cut_columns(std::size_t row, double first, double last, const Way& way, Cut& cut) {
  if (!(first <= last)) return;
  const double y = (static_cast<double>(row) + 0.5) * cell_mm_;
  const bool is_level = way.from.z == way.to.z || way.length_sq <= 0;
  const double level = std::min(way.from.z, way.to.z);
  float lost = 0, most = 0, contact = 0;
  std::optional<Way::Interval> inside;
  for (auto column = static_cast<std::size_t>(first); column <= static_cast<std::size_t>(last); ++column) {
    const double z = is_level ? level : way.lowest_over((static_cast<double>(column) + 0.5) * cell_mm_, y);
    const float here = lower(row * columns_ + column, z);
    lost += here;
    most = std::max(most, here);
    if (here <= contact) continue;
    if (!inside) inside = way.without_edge().at(y);
    const double x = (static_cast<double>(column) + 0.5) * cell_mm_;
    if (x >= inside->low && x <= inside->high) contact = here;
  }
  cut.removed_mm3 += static_cast<double>(lost) * cell_mm_ * cell_mm_;
  cut.deepest_mm = std::max(cut.deepest_mm, static_cast<double>(most));
  cut.contact_mm = std::max(cut.contact_mm, static_cast<double>(contact));
}

Cut Workpiece::cut(const geometry::Point& from, const geometry::Point& to, double radius_mm, double edge_mm) {
  const auto inside = [this](const geometry::Point& p) {
    return geometry::Point{p.x - corner_.x, p.y - corner_.y, p.z - corner_.z, 0};
  };
  Way way{.from = inside(from), .to = inside(to), .radius = radius_mm, .edge = edge_mm};
  way.is_start_cut = radius_mm == last_radius_mm_ && way.from == last_end_;
  last_end_ = way.to;
  last_radius_mm_ = radius_mm;
  Cut cut;
  if (std::min(way.from.z, way.to.z) >= full_height_mm_) return cut;
  way.length_sq = (to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y);
  const double low = std::min(way.from.y, way.to.y) - radius_mm, high = std::max(way.from.y, way.to.y) + radius_mm;
  const double first = std::max(0.0, std::ceil(low / cell_mm_ - 0.5));
  const double last = std::min(static_cast<double>(rows_) - 1, std::floor(high / cell_mm_ - 0.5));
  if (!(first <= last)) return cut;
  for (auto row = static_cast<std::size_t>(first); row <= static_cast<std::size_t>(last); ++row) cut_row(row, way, cut);
  removed_mm3_ += cut.removed_mm3;
  return cut;
}

}  // namespace cnclab::machine
