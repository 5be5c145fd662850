// Random programs of ways in G90 and G91, with scale, renamed positions and calls: the programmed position is exact to
// the last nanometre, and the path follows it without a gap. The oracle adds whole numbers.
#include <gtest/gtest.h>

#include "random_cases.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using geometry::Point;
using language::Address;
using language::Block;
using language::Function;
using language::Word;

constexpr std::array kAxes{Address::X, Address::Y, Address::Z};

/// Words of some of the axes, at least one.
language::Words random_axes(int largest) {
  language::Words words;
  const int named = *rc::gen::inRange(1, 8);
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    if ((named >> axis & 1) != 0) words.push_back(word(kAxes[axis], *rc::gen::inRange(-largest, largest + 1)));
  return words;
}

/// A block of one of the functions that the oracle knows. G75 is refused under G90, so G91 stands before it.
void append_random(std::vector<Block>& blocks) {
  const auto add = [&blocks](int code, language::Words words = {}) {
    blocks.push_back({.number = static_cast<std::uint16_t>(blocks.size() + 1),
                      .function = {Function::Kind::g, static_cast<std::uint8_t>(code)},
                      .words = std::move(words)});
  };
  const int code = *rc::gen::element(0, 0, 1, 1, 1, 61, 68, 69, 74, 75, 90, 91);
  switch (code) {
    case 75:
      add(91);
      add(75, random_axes(5000));
      break;
    case 74:
    case 90:
    case 91:
      add(code);
      break;
    default:
      add(code, random_axes(99'999));
      break;
  }
}

/// The position in nanometres, worked out block by block from what the manual says.
struct Oracle {
  std::array<std::int64_t, 3> position_nm{}, path_nm{};
  std::array<std::int64_t, 3> factor{1000, 1000, 1000};
  bool is_absolute = false;

  void execute(const Block& block) {
    switch (block.function.code) {
      case 74:
      case 75:
        factor = {1000, 1000, 1000};
        break;
      case 90:
        is_absolute = true;
        break;
      case 91:
        is_absolute = false;
        break;
      default:
        break;  // words only
    }
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
      if (const Word* found = block.find(kAxes[axis])) take(block.function.code, axis, found->number);
  }
  void take(int code, std::size_t axis, std::int64_t number) {
    if (code == 75) {
      factor[axis] = number;
    } else if (code == 68 || code == 69) {
      position_nm[axis] = number * 1000;
    } else {
      const std::int64_t before = position_nm[axis];
      position_nm[axis] = (is_absolute ? 0 : before) + number * factor[axis];
      path_nm[axis] += position_nm[axis] - before;
    }
  }
};

std::int64_t rounded_to_um(std::int64_t nm) { return (nm + (nm < 0 ? -500 : 500)) / 1000; }

Point in_mm(const std::array<std::int64_t, 3>& nm) {
  return {static_cast<double>(nm[0]) / 1e6, static_cast<double>(nm[1]) / 1e6, static_cast<double>(nm[2]) / 1e6};
}

RC_GTEST_PROP(PositionProperty, IsExactAfterEveryBlock_G022_G090_G091_DEC05, ()) {
  std::vector<Block> blocks{{.number = 1, .function = {Function::Kind::g, 11}, .words = {word(Address::F, 1000)}}};
  const int count = *rc::gen::inRange(1, 60);
  for (int i = 0; i < count; ++i) append_random(blocks);
  ProgramSet programs;
  programs.put({.number = 1, .blocks = blocks});

  const RunResult run = run_programs(programs, wide_settings(), {});
  RC_ASSERT(!run.error);
  RC_ASSERT(run.blocks.size() == blocks.size());
  Oracle oracle;
  Point at;
  auto item = run.items.begin();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    oracle.execute(blocks[i]);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
      RC_ASSERT(run.blocks[i].programmed_um[axis] == rounded_to_um(oracle.position_nm[axis]));
    for (; item != run.items.end() && item->sequence == i + 1; ++item) {
      const auto* line = std::get_if<geometry::Line>(&item->what);
      if (line == nullptr) continue;
      RC_ASSERT(line->from == at);
      RC_ASSERT(line->to != at);
      at = line->to;
    }
    RC_ASSERT(at == in_mm(oracle.path_nm));
  }
}

/// The same ways as G91 and as G90 lead to the same places (EX-100's square, at random).
RC_GTEST_PROP(PositionProperty, DoesNotDependOnTheDimension_G900_G910, ()) {
  std::vector<Block> incremental, absolute{{.number = 1, .function = {Function::Kind::g, 90}}};
  std::array<int, 3> sum{};
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < count; ++i) {
    language::Words words = random_axes(100'000);
    incremental.push_back({.number = static_cast<std::uint16_t>(i + 2), .function = {}, .words = words});
    for (Word& way : words) {
      int& total = sum[static_cast<std::size_t>(language::letter(way.address) - 'X')];
      total += way.number;
      way.number = total;
    }
    absolute.push_back({.number = static_cast<std::uint16_t>(i + 2), .function = {}, .words = words});
  }
  const auto run = [](const std::vector<Block>& blocks) {
    ProgramSet programs;
    programs.put({.number = 1, .blocks = blocks});
    return run_programs(programs, wide_settings(), {.program = 1, .block = blocks.front().number});
  };
  RC_ASSERT(run(incremental).json() == run(absolute).json());
}

}  // namespace
}  // namespace cnclab::program
