// The only time that this folder knows: a number that its users bring.
#pragma once

#include <chrono>

namespace cnclab::transfer {

/// A moment, counted from any that stays the same; it never runs backwards. One character at 4800 baud lasts 2083 µs.
using Time = std::chrono::microseconds;

}  // namespace cnclab::transfer
