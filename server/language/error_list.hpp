// The errors of one text, bounded. Private to this folder.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "language/error.hpp"

namespace cnclab::language {

/// Hostile text may hold an error in every byte: beyond these, errors are counted but not kept.
inline constexpr std::size_t kMostErrors = 1000;

/// Every error found so far, in the order of the text.
struct ErrorList {
  std::vector<Error> errors;
  std::size_t dropped = 0;

  void add(Error error) {
    if (errors.size() < kMostErrors)
      errors.push_back(std::move(error));
    else
      ++dropped;
  }
};

}  // namespace cnclab::language
