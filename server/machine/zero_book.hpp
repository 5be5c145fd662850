// Each student's zero on the lab machine (DEC-27): ISTWERT, G68, G69 and a limit switch move only a name for the
// machine's place, and that name is kept per student.
//
// A zero is what a place in machine steps is called. It is void once the position was lost: after a server restart (the
// book is in memory alone) and after a stop that lost the reference.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "machine/channel.hpp"

namespace cnclab::machine {

class ZeroBook {
 public:
  /// steps_per_mm   X Y Z of the machine's data
  explicit ZeroBook(const std::array<double, 3>& steps_per_mm) : per_mm_(steps_per_mm) {}

  /// The student leaves the machine at rest: keeps what its place is called. Nothing is kept while unreferenced, and
  /// what was kept before is forgotten then.
  void keep(std::int64_t student, const Snapshot& now);
  /// The Istwert of X, Y, Z that the student reads where the machine stands now: by the own zero, and where there is
  /// none or it is void by the machine's, which is 0 at the reference point. Nothing while unreferenced. To be set with
  /// `SetIstwert` when the student is connected.
  [[nodiscard]] std::optional<std::array<double, 3>> istwert(std::int64_t student, const Snapshot& now) const;
  /// New machine data: all zeros are void.
  void set_steps_per_mm(const std::array<double, 3>& steps_per_mm);

 private:
  struct Zero {
    std::array<double, 3> steps{};  ///< where Istwert 0 is
    std::uint64_t references_lost = 0;
  };

  std::array<double, 3> per_mm_;
  std::map<std::int64_t, Zero> zeros_;
};

}  // namespace cnclab::machine
