// The slow, obvious planner: one backward and one forward pass over the whole path, in closed formulas (DEC-20,
// DEC-21).
//
// It knows the whole path from the start, looks at everything and keeps nothing; what it lacks is any cleverness that
// could be wrong. Rests cost no time here; a real one lasts one to two ticks.
#pragma once

#include <vector>

#include "motion/limits.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::motion {

struct ReferenceTime {
  double seconds = 0;
  int rests = 0;  ///< full stops, the last one included
};

/// The least time for the path within the rules. Dwells take their time.
[[nodiscard]] ReferenceTime reference_time(const std::vector<Segment>& segments, const Limits& limits);

}  // namespace cnclab::motion
