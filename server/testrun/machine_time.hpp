// How long the machine will take: the same planner and follower that move it, in virtual time.
#pragma once

#include <cstddef>
#include <memory>

#include "geometry/path_item.hpp"
#include "motion/limits.hpp"

namespace cnclab::testrun {

/// Takes the path item by item and follows it behind, so that memory stays bounded. What is not followed yet counts
/// with its programmed speed, without ramps: so the sum never falls, and is exact once the path is finished. Dwells
/// count; waiting for inputs, halts and reference runs do not, since nobody knows how long they last.
class MachineTime {
 public:
  MachineTime(const geometry::Point& start, const motion::Limits& limits);
  ~MachineTime();
  MachineTime(MachineTime&&) noexcept;
  MachineTime& operator=(MachineTime&&) noexcept;

  void take(const geometry::PathItem& item);
  /// Nothing follows: follows the rest of the path to its end.
  void finish();
  [[nodiscard]] double seconds() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::testrun
