// Arcs as stepping drives run them where the two axes of the plane have different steps per millimetre (G-031, MD-130).
//
// The original's circle is one of steps: in the grid of steps it is round, in millimetres an ellipse whose half axes
// are as 1/steps_per_mm. It leaves the start, ends exactly on the end, and where both lie at different distances from
// the centre in steps the radius changes linearly with the angle, as in D-55. Equal steps/mm leave the arc as it is.
#pragma once

#include <array>
#include <vector>

#include "geometry/path_item.hpp"

namespace cnclab::geometry {

/// Appends the item to `out`: unchanged, or an arc as lines that stay within a quarter of a step of the ellipse.
///
/// item           any; only arcs in a plane with unequal steps/mm change
/// steps_per_mm   X Y Z U, > 0
/// The lines keep source, sequence, feed and flags; `ends_block` and `exact_stop` belong to the last one alone. A
/// circle of radius r steps becomes about 3·√r lines. Its curvature is left to the joints: no axis' velocity steps by
/// more than F START/STOP at any of them.
void append_in_step_grid(const PathItem& item, const std::array<double, 4>& steps_per_mm, std::vector<PathItem>& out);

/// The same for a whole batch, in place; costs nothing where all steps/mm are equal.
void run_in_step_grid(std::vector<PathItem>& items, const std::array<double, 4>& steps_per_mm);

}  // namespace cnclab::geometry
