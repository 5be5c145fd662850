// Work that takes longer than a key press may: it is done elsewhere, on values of its own, and whoever asked looks at
// the result when it is there (architecture.md rule 7).
#pragma once

#include <functional>

namespace cnclab::panel {

/// Takes a job and returns at once; the job runs some time later, in any thread, each job once.
using LongWork = std::function<void(std::function<void()> job)>;

/// Without anybody to do it elsewhere it is done now: tests and tools.
inline void do_at_once(const std::function<void()>& job) { job(); }

}  // namespace cnclab::panel
