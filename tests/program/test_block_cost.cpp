// Blocks that run again allocate nothing, so that a loop costs the same in its thousandth pass: operator new is
// replaced and counts.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "run_text.hpp"

namespace {

std::size_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace cnclab::program {
namespace {

TEST(BlockCost, NoAllocationOnceABlockHasRun) {
  auto interpreter = Interpreter::begin(
      programs_of(
          "P0000T001R+5000L+1\nP0001N001G11F0500S0100T01M03N002G01X+1000Y-1N003G02X+10000Y+0I+5000J+0"
          "N004G05X+1Y+1R+5000N005G22P0002N001W02N006G41N007G00X+0N008G40N009G01X-1000N010G21P0001N001"
          "N011G68X+0Y+0N012G20P0001N001\nP0002N001G01X#02F#01N002G04H0010N003G08X+0Y+0I+5000J+0Z+1N004G11M40%"),
      wide_settings(), {.position = {.x = 1}, .parameters = {0, 100 * kParameterUnit, kParameterUnit}});
  ASSERT_TRUE(interpreter);
  std::vector<geometry::PathItem> items;
  items.reserve(64);
  const auto run = [&](int blocks) {
    for (int i = 0; i < blocks; ++i) {
      items.clear();
      if (interpreter->awaited_input()) interpreter->answer_input(false);
      if (!interpreter->step(items)) return false;
    }
    return true;
  };
  ASSERT_TRUE(run(100));
  const std::size_t before = allocations;
  EXPECT_GT(before, 0u);
  ASSERT_TRUE(run(10'000));
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace cnclab::program
