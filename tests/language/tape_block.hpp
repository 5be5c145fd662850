// Blocks for tests, written as tape text.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "language/tape.hpp"

namespace cnclab::language {

/// The block that the text says; a failure of the test where it says none.
inline Block tape_block(std::string_view text, std::uint16_t program = 1) {
  auto block = read_block(text, program);
  if (!block) {
    ADD_FAILURE() << text << ": " << explain(block.error(), Tongue::english);
    return {};
  }
  return *block;
}

/// Columns on the monitor: UTF-8 characters.
inline int columns_of(std::string_view text) {
  int columns = 0;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) ++columns;
  return columns;
}

}  // namespace cnclab::language
