// The lab machine's travel: a block whose path would leave it is refused before it moves (AUTH-011, DEC-27).
//
// Only a referenced machine knows where it stands; without a reference the limit switches alone guard. The training
// machine has no such guard (D-116).
#pragma once

#include <array>
#include <optional>

#include "geometry/path_item.hpp"
#include "language/error.hpp"
#include "machine/machine_data.hpp"

namespace cnclab::panel {

class TravelGuard {
 public:
  /// machine_mm   where X, Y, Z stand, from the middle of their travel (DEC-23)
  /// start        what the path calls that place
  TravelGuard(const std::array<double, 3>& machine_mm, const machine::MachineData& data, const geometry::Point& start);

  /// Takes the items in the order of the path: a reference run (G69) tells where its axes stand afterwards.
  /// returns  the error of a line or arc that leaves the travel anywhere on its way; nothing for everything else
  [[nodiscard]] std::optional<language::Error> fault_of(const geometry::PathItem& item);

 private:
  void note_reference(const geometry::Reference& reference);
  void settle_references(const geometry::Point& from);
  void place(std::size_t axis, double path_mm, double machine_mm);

  std::array<double, 3> half_travel_{};                   ///< mm
  std::array<double, 3> low_{}, high_{};                  ///< mm, path coordinates X Y Z
  std::array<std::optional<double>, 3> referenced_at_{};  ///< machine coordinate; what the path calls it is still open
};

}  // namespace cnclab::panel
