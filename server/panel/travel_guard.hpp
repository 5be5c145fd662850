// The lab machine's travel: a block whose path would leave it is refused before it moves (AUTH-011, DEC-27).
//
// Only a referenced machine knows where it stands; without a reference the limit switches alone guard. The training
// machine has no such guard (D-116).
#pragma once

#include <array>
#include <optional>

#include "geometry/path_item.hpp"
#include "language/error.hpp"
#include "machine/channel.hpp"
#include "machine/machine_data.hpp"

namespace cnclab::panel {

class TravelGuard {
 public:
  /// start   path coordinates of the point where the machine stands in `snapshot`
  /// The machine's coordinates count from the middle of its travel (DEC-23).
  TravelGuard(const machine::Snapshot& snapshot, const machine::MachineData& data, const geometry::Point& start);

  /// The error of a line or arc that leaves the travel anywhere on its way; nothing for everything else.
  [[nodiscard]] std::optional<language::Error> fault_of(const geometry::PathItem& item) const;

 private:
  std::array<double, 3> low_{}, high_{};  ///< mm, path coordinates X Y Z
};

}  // namespace cnclab::panel
