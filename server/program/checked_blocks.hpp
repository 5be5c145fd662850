// Which blocks have passed their check. Stored blocks never change during a run, so what is written in them is checked
// once; the values of parameters are checked whenever they are read.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/block.hpp"

namespace cnclab::program {

/// For each block that has run, the planes in which it has passed: a block may fit one and not another (D-54).
class CheckedBlocks {
 public:
  [[nodiscard]] bool has_passed(const language::Program& program, std::size_t index, geometry::Plane plane) {
    return (planes_of(program)[index] & bit_of(plane)) != 0;
  }
  void pass(const language::Program& program, std::size_t index, geometry::Plane plane) {
    std::uint8_t& planes = planes_of(program)[index];
    planes = static_cast<std::uint8_t>(planes | bit_of(plane));
  }

 private:
  static std::uint8_t bit_of(geometry::Plane plane) { return static_cast<std::uint8_t>(1U << static_cast<int>(plane)); }

  std::vector<std::uint8_t>& planes_of(const language::Program& program) {
    if (newest_ != &program) change_to(program);
    return planes_[place_];
  }
  void change_to(const language::Program& program) {
    const auto [found, is_new] = places_.try_emplace(&program, planes_.size());
    if (is_new) planes_.emplace_back(program.blocks.size());
    newest_ = &program;
    place_ = found->second;
  }

  const language::Program* newest_ = nullptr;  ///< the program asked for last, whose planes are `planes_[place_]`
  std::size_t place_ = 0;
  std::unordered_map<const language::Program*, std::size_t> places_;
  std::vector<std::vector<std::uint8_t>> planes_;
};

}  // namespace cnclab::program
