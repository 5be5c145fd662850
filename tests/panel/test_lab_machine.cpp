// What a control does only while the lab's machine is connected: its tools (DEC-29), its reference (DEC-27), a switch
// that an axis meets while it brakes for a lost lease (ERR-020, AUTH-009); and what the tool did to the workpiece.
#include <gtest/gtest.h>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

constexpr machine::Epoch kEpoch{1};

machine::ToolList list_of(const std::map<int, machine::ListedTool>& tools) {
  machine::ToolList list;
  for (const auto& [number, tool] : tools) list.put(number, tool);
  return list;
}

/// The control at a lab machine that keeps a tool list: T03 with R 5 and L 12.5, T04 with R 2.
class Tools : public testing::Test {
 protected:
  explicit Tools(const std::string& tape) : bench({.tape = tape, .is_lab_machine = true}) { connect(bench.control); }
  Tools()
      : Tools(
            "P0000T003R+5005L+12500T004R+2000L+0T005R+1000L+0T006R+5000L+12500"
            "P0001N001G11F1000T03N002G01X+1000N003G01X+1000T04N004G11T04N005G01X+1000%"
            "P0002N001G11F1000N002G01X+1000T06N003G01X+1000%"
            "P0003N001G11F1000N002G01X+1000N003G01X+1000%"
            "P0004N001G11F1000T05N002G01X+1000%") {}

  void connect(Control& control) {
    control.connect({bench.channel, kEpoch, true, {}, false, list_of({{3, {5, 12.5}}, {4, {2, 0}}, {6, {4.9, 12.5}}})});
  }
  void start(char program) {
    bench.keys("MENU AUTOMAT CLEAR");
    bench.keys(std::string(1, program));
    bench.keys("ENTER ENTER START");
  }
  bool waits_for(std::string_view tool) {
    return bench.run_until([&] { return bench.monitor(15) == "Werkzeug " + std::string(tool) + " einsetzen"; }, 20'000);
  }

  Bench bench;
};

TEST_F(Tools, DEC_29_AnotherToolThanTheOneInTheSpindleHaltsLikeM00UntilSTART) {
  start('1');
  ASSERT_TRUE(waits_for("T03")) << bench.picture();
  EXPECT_TRUE(bench.row(18).contains("T03")) << bench.row(18);
  EXPECT_EQ(bench.istwert(0), 0) << "nothing has moved";
  EXPECT_TRUE(bench.control.is_running()) << "START state, as in M00";
  bench.keys("START");
  ASSERT_TRUE(waits_for("T04")) << bench.picture();
  EXPECT_EQ(bench.istwert(0), 1) << "before the block that calls it";
  EXPECT_EQ(bench.snapshot().tool, 3);
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 3) << "the second T04 does not halt";
  EXPECT_EQ(bench.snapshot().tool, 4);
  EXPECT_EQ(bench.monitor(15), "");
}

TEST_F(Tools, DEC_29_TheToolStaysInTheSpindleForTheNextStudent) {
  start('1');
  ASSERT_TRUE(waits_for("T03"));
  bench.keys("START");
  bench.run_for(20);
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  connect(bench.control);
  bench.run_for(20);
  start('1');
  ASSERT_TRUE(waits_for("T04")) << "T03 is in already: " << bench.picture();
}

TEST_F(Tools, DEC_29_AToolThatWasNotConfirmedIsAskedForAgain) {
  start('1');
  ASSERT_TRUE(waits_for("T03"));
  bench.keys("STOP MENU");
  ASSERT_TRUE(bench.run_to_rest());
  start('1');
  EXPECT_TRUE(waits_for("T03")) << bench.picture();
}

struct RefusedRow {
  char program;
  const char* monitor;
  std::vector<const char*> sentence;
  double x_mm;
};

TEST_F(Tools, DEC_29_ABlockWhoseToolIsNotTheListedOneIsRefusedWithValueAndLimits) {
  for (const RefusedRow& row :
       std::vector<RefusedRow>{{'2', "Werkzeug falsch", {"P0002 N002", "T06 R 5.000", "4.890..4.910"}, 0},
                               {'4', "Werkzeug fehlt", {"P0004 N001", "T05", "Werkzeugliste"}, 0}}) {
    start(row.program);
    ASSERT_TRUE(bench.run_to_rest());
    EXPECT_EQ(bench.monitor(15), row.monitor);
    for (const char* part : row.sentence) EXPECT_TRUE(bench.row(18).contains(part)) << bench.row(18);
    EXPECT_EQ(bench.istwert(0), row.x_mm);
  }
}

TEST_F(Tools, DEC_29_AToolThatWasCalledBeforeSTARTCountsToo) {
  start('1');
  ASSERT_TRUE(waits_for("T03"));
  bench.keys("START");
  ASSERT_TRUE(waits_for("T04"));
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  // Somebody else has put T03 in; the modal T of this control is still T04.
  ASSERT_NE(bench.channel->begin_run(kEpoch, {}), nullptr);
  geometry::PathItem other;
  other.what = geometry::ToolChange{3, 5, 12.5};
  other.sequence = 1;
  ASSERT_TRUE(bench.channel->planner().append(other));
  bench.channel->planner().plan();
  ASSERT_TRUE(bench.channel->command(machine::Go{kEpoch}));
  ASSERT_TRUE(bench.run_until([&] { return bench.snapshot().tool == 3; }, 1000));
  ASSERT_TRUE(bench.channel->command(machine::Abandon{}));
  bench.run_for(50);
  start('3');
  ASSERT_TRUE(waits_for("T04")) << bench.picture();
  EXPECT_EQ(bench.istwert(0), 3) << "before anything moves";
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 5);
}

TEST_F(Tools, DEC_29_InHandeingabeToo) {
  bench.keys("HANDEINGABE");
  bench.type("11");
  bench.keys("ENTER");
  bench.type("1000");
  bench.keys("ENTER ENTER");
  bench.type("03");
  bench.keys("START");
  ASSERT_TRUE(waits_for("T03")) << bench.picture();
  EXPECT_TRUE(bench.row(18).contains("T03")) << bench.row(18);
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.snapshot().tool, 3);
}

TEST(TrainingMachine, DEC_29_AsksForNoTool) {
  Bench bench({.tape = "P0001N001G11F1000T07N002G01X+1000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 1);
}

TEST(LabMachine, DEC_27_UnreferencedOnlyHandbetriebAndReferenceMoveWhereItIsRequired) {
  Bench bench({.tape = "P0001N001G11F1000N002G01X+1000%", .is_lab_machine = true});
  bench.control.connect({bench.channel, kEpoch, true, {}, true});
  bench.run_for(20);
  const auto is_refused = [&](const char* keys) {
    bench.keys(keys);
    bench.run_for(300);
    const bool told = bench.row(18).contains("referenziert");
    bench.keys("STOP MENU");
    return told && bench.istwert(0) == 0;
  };
  EXPECT_TRUE(is_refused("AUTOMAT ENTER ENTER START")) << "AUTOMAT";
  EXPECT_TRUE(is_refused("TEACH_IN ENTER PLUS_X START")) << "TEACH IN";
  EXPECT_TRUE(is_refused("HANDEINGABE 1 1 ENTER 1 0 0 0 START")) << "HANDEINGABE";
  bench.keys("HAND PLUS_X START");
  bench.run_for(300);
  EXPECT_GT(bench.istwert(0), 0) << "HANDBETRIEB moves";
}

TEST(LabMachine, AUTH_010_DEC_01_ThatTheDrivesAreOffIsToldBeforeAndAtEveryKeyThatWouldStartSomething) {
  constexpr std::string_view kOff =
      "Die Maschine ist abgeschaltet: erst muss die Lehrkraft sie einschalten (power-on).";
  Bench bench({.tape = "P0001N001G11F1000N002G01X+1000%", .is_lab_machine = true});
  ASSERT_TRUE(bench.channel->command(machine::PowerOff{}));
  bench.run_for(20);
  const auto says = [&](const char* keys) {
    bench.keys(keys);
    bench.run_for(100);
    const std::string said = bench.row(18) + " " + bench.row(19);
    return said.starts_with(kOff.substr(0, 78)) ? "" : said;
  };
  EXPECT_EQ(says(""), "") << "in the menu";
  EXPECT_EQ(says("HAND"), "");
  for (const char* keys : {"FRAESER", "KUEHLMITTEL", "PLUS_X START", "PLUS_X REFERENZ"}) {
    EXPECT_EQ(says(keys), "") << keys;
    bench.keys("STOP");
  }
  EXPECT_EQ(says("MENU AUTOMAT ENTER ENTER"), "");
  EXPECT_EQ(says("START"), "");
  EXPECT_EQ(says("MENU HANDEINGABE 1 1 ENTER 1 0 0 0 START"), "");
  EXPECT_EQ(bench.snapshot().dropped, 0U) << "nothing was ordered of a machine that could not do it";
  ASSERT_TRUE(bench.channel->command(machine::PowerOn{}));
  bench.run_for(20);
  bench.keys("MENU HAND FRAESER");
  bench.run_for(20);
  EXPECT_NE(bench.snapshot().spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(bench.row(18).contains("abgeschaltet")) << bench.row(18);
}

/// X has 3 mm to the switch; it is braked for the lost lease at F3000 so near that it meets it.
class LostLease : public testing::Test {
 protected:
  LostLease()
      : bench({.data = small(),
               .tape = "P0001N001G11F3000N002G01X+20000%",
               .is_lab_machine = true,
               .lab_data = small()}) {}
  static machine::MachineData small() {
    machine::MachineData data;
    EXPECT_TRUE(data.set(3, 20'000));
    return data;
  }
  Bench bench;
};

TEST_F(LostLease, ERR_020_ASwitchThatIsMetWhileBrakingForItIsTold) {
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(0) > 6; }));
  bench.channel->revoke(machine::StopCause::lease_ended);
  ASSERT_TRUE(bench.run_until([&] { return bench.snapshot().state == machine::MotionState::standstill; }));
  ASSERT_EQ(bench.snapshot().cause, machine::StopCause::lease_ended) << "the first cause";
  ASSERT_EQ(bench.snapshot().limit_axis, 0);
  EXPECT_EQ(bench.monitor(15), "Endschalter");
  EXPECT_TRUE(bench.row(18).contains("Endschalter X")) << bench.row(18);
  // The lab takes the machine away; what happened is still to be read.
  machine::SimulatedMachine other{{}};
  const auto training = std::make_shared<machine::Channel>(other, machine::MachineData{});
  training->grant(kEpoch, machine::kNeverExpires);
  bench.control.connect({training, kEpoch, false, {}});
  EXPECT_EQ(bench.monitor(15), "Endschalter");
  EXPECT_TRUE(bench.row(18).contains("Endschalter X")) << bench.row(18);
  bench.keys("AUTOMAT");
  EXPECT_EQ(bench.monitor(15), "") << "until the next key";
  bench.control.connect({bench.channel, kEpoch, true, small()});
}

TEST_F(LostLease, ERR_020_AlsoWhereTheLabIsFasterThanTheControl) {
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(0) > 6; }));
  bench.channel->revoke(machine::StopCause::lease_ended);
  for (int i = 0; i < 5000; ++i) bench.channel->tick(bench.now.monotonic_ns += 1'000'000, 0.001);
  machine::SimulatedMachine other{{}};
  const auto training = std::make_shared<machine::Channel>(other, machine::MachineData{});
  bench.control.connect({training, kEpoch, false, {}});
  EXPECT_EQ(bench.monitor(15), "Endschalter");
  bench.control.connect({bench.channel, kEpoch, true, small()});
}

TEST(Milling, DEC_24_WhatTheToolMustNotDoIsToldInRow18UntilTheNextKey) {
  Bench bench({.tape = "P0001N001G11F1000%"});
  bench.keys("AUTOMAT ENTER ENTER");
  using Kind = machine::MillingEvent::Kind;
  bench.control.tell_milling({Kind::rapid_in_material, 1, {1, 3}, {}});
  EXPECT_TRUE(bench.row(18).starts_with("P0001 N003: Eilgang im Material.")) << bench.row(18);
  bench.control.tell_milling({Kind::spindle_off_in_material, 1, {0, 0}, {}});
  EXPECT_TRUE(bench.row(18).starts_with("Fräser steht im Material.")) << "by hand: " << bench.row(18);
  bench.keys("START");
  EXPECT_FALSE(bench.row(18).contains("Material")) << bench.row(18);
}

TEST(Milling, DEC_24_GrafikCutsTheConfiguredWorkpiece) {
  const std::string tape = "P0000T001R+5000L+0P0001N001G11F1000T01M03N002G01X+55000N003G00Z-1000%";
  const auto finds_rapid = [&](const std::array<double, 3>& size_mm) {
    Bench bench({.tape = tape});
    bench.control.set_workpiece({size_mm, 0.5});
    bench.keys("GRAFIK ENTER START");
    bench.run_for(500);
    return bench.row(18).contains("Eilgang im Material");
  };
  EXPECT_TRUE(finds_rapid({120, 80, 30}));
  EXPECT_FALSE(finds_rapid({60, 80, 30})) << "it ends 20 mm before";
}

}  // namespace
}  // namespace cnclab::panel
