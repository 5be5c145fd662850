// Modal groups: plane, scale, dimension (G-170, G-740, G-750, G-900).
#include <fmt/core.h>

#include "program/compensation.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

Outcome select_plane(BlockRun& run, geometry::Plane plane) {
  if (is_compensating(run.state.modal) && plane != run.state.modal.plane)  // D-69
    return error_at(language::ErrorCode::plane_locked, run.source, 'G', fmt::format("G{:02}", run.block.function.code));
  run.state.modal.plane = plane;
  return {};
}

}  // namespace

Outcome select_plane_xy(BlockRun& run) { return select_plane(run, geometry::Plane::xy); }
Outcome select_plane_xz(BlockRun& run) { return select_plane(run, geometry::Plane::xz); }
Outcome select_plane_yz(BlockRun& run) { return select_plane(run, geometry::Plane::yz); }

Outcome cancel_scale(BlockRun& run) {
  run.state.modal.scale_on = false;
  run.state.modal.scale = {1000, 1000, 1000};
  return {};
}

Outcome set_scale(BlockRun& run) {
  using language::Address;
  ModalState& modal = run.state.modal;
  if (modal.dimension == Dimension::absolute)  // D-68
    return error_at(language::ErrorCode::scale_not_allowed, run.source, 'G', "G90", "G91");
  if (is_compensating(modal))
    return error_at(language::ErrorCode::scale_not_allowed, run.source, 'G', "G75", "G40, G45");
  modal.scale_on = true;
  // New factors replace the old ones, an empty word is 1 (G-753, G-754).
  modal.scale = {value_of(run.block, Address::X, 1000), value_of(run.block, Address::Y, 1000),
                 value_of(run.block, Address::Z, 1000)};
  return {};
}

Outcome select_absolute(BlockRun& run) {
  run.state.modal.dimension = Dimension::absolute;
  return {};
}

Outcome select_incremental(BlockRun& run) {
  run.state.modal.dimension = Dimension::incremental;
  return {};
}

}  // namespace cnclab::program
