// What only the lab's machine has: a tool list (DEC-29), a zero per student (DEC-27), the signal Start (HW-005).
#include <gtest/gtest.h>

#include "channel_rig.hpp"
#include "machine/tool_list.hpp"
#include "machine/zero_book.hpp"

namespace cnclab::machine {
namespace {

struct ToolRow {
  const char* name;
  geometry::ToolChange called;
  std::optional<ToolFault> fault;
};

TEST(ToolList, DEC29RadiusAndLengthAgreeWithinAHundredth) {
  ToolList list;
  list.put(3, {5, 12.5});
  using Kind = ToolFault::Kind;
  const std::vector<ToolRow> rows{{"the same", {3, 5, 12.5}, {}},
                                  {"within", {3, 5.01, 12.49}, {}},
                                  {"radius too large", {3, 5.011, 12.5}, ToolFault{Kind::radius_differs, 3, 5.011, 5}},
                                  {"radius too small", {3, 4.5, 12.5}, ToolFault{Kind::radius_differs, 3, 4.5, 5}},
                                  {"length", {3, 5, 12.6}, ToolFault{Kind::length_differs, 3, 12.6, 12.5}},
                                  {"not listed", {4, 5, 12.5}, ToolFault{Kind::not_listed, 4, 0, 0}},
                                  {"T00 calls none", {0, 0, 0}, {}}};
  for (const auto& row : rows) EXPECT_EQ(list.fault_of(row.called), row.fault) << row.name;
  list.remove(3);
  EXPECT_TRUE(list.fault_of({3, 5, 12.5}));
}

TEST(ToolList, DEC29AnotherToolThanTheOneInTheSpindleHalts) {
  ToolList list;
  EXPECT_TRUE(list.needs_change({3, 5, 0})) << "nobody said what is in the spindle";
  list.set_in_spindle(3);
  EXPECT_FALSE(list.needs_change({3, 5, 0}));
  EXPECT_TRUE(list.needs_change({4, 5, 0}));
  EXPECT_FALSE(list.needs_change({0, 0, 0}));
}

std::array<double, 3> per_mm() { return {200, 200, 200}; }

class Zeros : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(rig.channel.command(RunReference{kLease, {1, 1, 1}}));
    rig.tick();
    ASSERT_TRUE(rig.tick_to_rest());
    ASSERT_TRUE(rig.channel.snapshot().is_referenced);
  }
  void call_it(double x, double y, double z) {
    ASSERT_TRUE(rig.channel.command(SetIstwert{kLease, {true, true, true}, {x, y, z}}));
    rig.tick();
  }
  void move_by(double mm) {
    Items items;
    items.line_to({mm, mm / 2, 0, 0}).add(geometry::End{});
    rig.run(items);
    ASSERT_TRUE(rig.tick_to_rest());
  }

  ChannelRig rig{data_with({{3, 40'000}, {4, 40'000}, {5, 40'000}})};
  ZeroBook book{per_mm()};
};

TEST_F(Zeros, DEC27EachStudentFindsTheOwnZeroWhereverTheMachineStands) {
  call_it(10, 20, 30);
  book.keep(1, rig.channel.snapshot());
  move_by(-5);
  call_it(0, 0, 0);
  book.keep(2, rig.channel.snapshot());
  move_by(-4);
  const auto first = book.istwert(1, rig.channel.snapshot()), second = book.istwert(2, rig.channel.snapshot());
  ASSERT_TRUE(first && second);
  EXPECT_NEAR((*first)[0], 10 - 9, 1e-9);
  EXPECT_NEAR((*first)[1], 20 - 4.5, 1e-9);
  EXPECT_NEAR((*first)[2], 30, 1e-9);
  EXPECT_NEAR((*second)[0], -4, 1e-9);
  const auto third = book.istwert(3, rig.channel.snapshot());
  ASSERT_TRUE(third);
  EXPECT_NEAR((*third)[0], -9, 1e-9) << "never was here: counts from the reference point";
}

TEST_F(Zeros, DEC27ALostPositionVoidsThemEvenAfterANewReference) {
  call_it(10, 20, 30);
  book.keep(1, rig.channel.snapshot());
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {-1, 0, 0}}));
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.cause == StopCause::limit_switch; }));
  ASSERT_FALSE(rig.channel.snapshot().is_referenced) << "stopped without ramp from F MAX";
  EXPECT_FALSE(book.istwert(1, rig.channel.snapshot()));
  ASSERT_TRUE(rig.channel.command(RunReference{kLease, {1, 1, 1}}));
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  ASSERT_TRUE(rig.channel.snapshot().is_referenced);
  const auto machines = book.istwert(1, rig.channel.snapshot());
  ASSERT_TRUE(machines);
  EXPECT_NEAR((*machines)[0], 0, 1e-9) << "steps may be lost for good: the machine's zero";
}

TEST_F(Zeros, DEC27NewMachineDataVoidThem) {
  call_it(10, 20, 30);
  book.keep(1, rig.channel.snapshot());
  ASSERT_NEAR((*book.istwert(1, rig.channel.snapshot()))[0], 10, 1e-9);
  book.set_steps_per_mm({100, 200, 200});
  EXPECT_NEAR((*book.istwert(1, rig.channel.snapshot()))[0], 0, 1e-9) << "at the reference point";
}

TEST(ZeroBook, DEC27NothingIsKeptWhileUnreferenced) {
  ChannelRig rig;
  ZeroBook book(per_mm());
  book.keep(1, rig.channel.snapshot());
  EXPECT_FALSE(book.istwert(1, rig.channel.snapshot()));
}

TEST(StartSignal, HW005IsSetByStartAndResetAtRest) {
  ChannelRig rig;
  Items items;
  items.line_to({5, 0, 0, 0}).add(geometry::Halt{}).line_to({6, 0, 0, 0}).add(geometry::End{});
  rig.begin(items);
  rig.tick(3);
  EXPECT_FALSE(rig.machine.last.start);
  rig.go();
  rig.tick();
  EXPECT_TRUE(rig.machine.last.start);
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.state == MotionState::halted; }));
  EXPECT_TRUE(rig.machine.last.start) << "M00 is START state";
  rig.channel.stop(StopCause::operator_stop);
  rig.tick(2);
  EXPECT_FALSE(rig.machine.last.start);
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  rig.tick();
  EXPECT_FALSE(rig.machine.last.start);
}

}  // namespace
}  // namespace cnclab::machine
