// What the harness throws when a process under test does not do what the test relies on.
#pragma once

#include <stdexcept>

namespace cnclab::harness {

/// The message tells which process, what was expected, what came instead, and the end of its log.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cnclab::harness
