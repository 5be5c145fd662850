// The same random cases in every run; RC_PARAMS in the environment asks for others.
#pragma once

#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstdlib>

#include "language/block.hpp"

namespace cnclab::program {

[[maybe_unused]] inline const int kSeeded = ::setenv("RC_PARAMS", "seed=3300 max_success=100", 0);

inline language::Word word(language::Address address, int number) {
  return {.address = address, .is_parameter = false, .number = number};
}

/// A number of least..most, each as likely as any other.
inline std::int64_t between(std::int64_t least, std::int64_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(least, most + 1));
}

}  // namespace cnclab::program
