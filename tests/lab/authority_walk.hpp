// Every state that three stations and an instructor can bring about, walked through with invariants (AUTH-014).
//
// The line between a station and the server loses, doubles, reorders and delays: each station has two logins, one after
// the other, and every message of both may come at any time, any number of times or never. The server may crash.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lab/authority.hpp"

namespace cnclab::lab {

/// What is wrong in a mutant: it changes what goes into the rules, what comes out, or what survives a crash. A walk
/// over it must find a broken invariant.
struct Mutation {
  std::string name;
  std::string breaks;  ///< ID of the requirement whose invariant must fail
  /// Changes the event; false swallows it.
  std::function<bool(Event&, const Authority&)> event;
  std::function<void(MachineView&)> machine;
  /// True drops the action.
  std::function<bool(const Action&)> drops;
  std::function<Authority(const Authority& before)> crash;
};

struct WalkResult {
  std::size_t states = 0, steps = 0;
  std::string broken;  ///< the first invariant that failed, headed by its ID; empty: none
  std::string how;     ///< state and event that led to it
};

/// Breadth first through all states; ends at the first violation.
[[nodiscard]] WalkResult walk(const Mutation& mutation);

}  // namespace cnclab::lab
