// GRAFIK: the test run is played in portions by somebody else, and seen as it goes (DEC-37, architecture.md rule 7).
#include <gmock/gmock.h>

#include <deque>
#include <functional>
#include <thread>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

using testing::HasSubstr;

/// A pocket with rapids, then a fault: the rapid of N006 goes through material.
constexpr std::string_view kPart =
    "P0000T001R+5000L+0P0001N001G11F1000S1000T01M03N002G00Z+5000N003G00X+20000N004G01Z-10000N005G01X-40000"
    "N006G00Y+20000N007G00Z+30000%";

TEST(Graphics, PlaysWithoutMovingTheMachine) {
  Bench bench({.tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER START");
  bench.run_for(100);
  EXPECT_THAT(bench.row(18), HasSubstr("1/1 P0001 N006: Eilgang im Material"));
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N007 100 %"));
  EXPECT_THAT(bench.monitor(15), HasSubstr("Weg 125.000 mm"));
  EXPECT_EQ(bench.istwert(0), 0);
  EXPECT_FALSE(bench.snapshot().started);
  EXPECT_EQ(bench.stores(), 0);
}

TEST(Graphics, SingleBlocksStopBehindEach) {
  Bench bench({.tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER EINZELSATZ START");
  bench.run_for(50);
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N001"));
  bench.keys("START START");
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N003"));
  bench.keys("EINZELSATZ START");
  bench.run_for(50);
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N007 100 %"));
}

TEST(Graphics, APotentiometerAtZeroStandsStill) {
  Bench bench({.tape = std::string(kPart)});
  bench.control.set_override(0);
  bench.keys("GRAFIK ENTER START");
  bench.run_for(200);
  EXPECT_THAT(bench.row(18), HasSubstr("0 %. STOP hält ihn an."));
  bench.control.set_override(10);
  bench.run_for(100);
  EXPECT_THAT(bench.row(18), HasSubstr("Eilgang im Material"));
}

TEST(Graphics, AnEndlessProgramIsStoppedAndLeftAtAnyTime) {
  Bench bench({.tape = "P0001N001G11F1000M03N002G01X+10000N003G01X-10000N004G20P0001N002%"});
  bench.keys("GRAFIK ENTER START");
  bench.run_for(100);
  bench.keys("STOP");
  const std::string stopped = bench.monitor(15);
  bench.run_for(100);
  EXPECT_EQ(bench.monitor(15), stopped);
  EXPECT_THAT(bench.row(18), HasSubstr("START spielt ihn ohne Maschine ab."));
  bench.keys("START MENU");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
}

TEST(Graphics, WhatCannotBeStartedIsSaid) {
  Bench bench({.tape = std::string(kPart)});
  bench.keys("GRAFIK 9 ENTER");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Programm fehlt"));
  bench.keys("CLEAR ENTER");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Programm fehlt"));
  bench.keys("0 ENTER");  // the tool table is no program
  EXPECT_THAT(bench.monitor(15), HasSubstr("Programm fehlt"));
}

/// Somebody who takes jobs and does them when the test says so.
struct Worker {
  std::deque<std::function<void()>> jobs;
  LongWork taking() {
    return [this](std::function<void()> job) { jobs.push_back(std::move(job)); };
  }
  void work() {
    while (!jobs.empty()) {
      const auto job = std::move(jobs.front());
      jobs.pop_front();
      job();
    }
  }
};

TEST(Graphics, TheToolTableIsNoProgramThatRuns) {
  for (const std::string_view mode : {"GRAFIK CLEAR 0 ENTER", "AUTOMAT CLEAR 0 ENTER"}) {
    Bench bench({.tape = "P0000T001R+5000L+0%"});
    bench.keys(mode);
    EXPECT_EQ(bench.monitor(15), "Programm fehlt") << mode;
    EXPECT_THAT(bench.row(18), HasSubstr("P0000 ist die Werkzeugtabelle, sie läuft nicht")) << mode;
  }
}

TEST(Graphics, TheLabIsNeverHeldUp) {
  Worker worker;
  Bench bench({.settings = {.picture_work = worker.taking()}, .tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER START 4 5 MINUS_X");
  bench.run_for(100);
  EXPECT_EQ(worker.jobs.size(), 1u) << "one portion at a time";
  EXPECT_EQ(bench.monitor(15), "");
  worker.work();
  bench.run_for(20);
  worker.work();
  bench.run_for(20);
  worker.work();
  bench.run_for(20);
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N007 100 %  X-Y-Z"));
}

TEST(Graphics, LeavingDoesNotWaitForAPortion) {
  Worker worker;
  Bench bench({.settings = {.picture_work = worker.taking()}, .tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER START");
  bench.keys("MENU GRAFIK ENTER START");
  worker.work();  // the abandoned portion comes to nothing
  bench.run_for(20);
  worker.work();
  bench.run_for(20);
  EXPECT_THAT(bench.row(18), HasSubstr("Eilgang im Material"));
}

TEST(Graphics, AStartNeverWaitsForATestRun) {
  Worker pictures;
  Bench bench({.settings = {.picture_work = pictures.taking()},
               .tape = "P0000T001R+5000L+0P0001N001G41N002G11F1000T01N003G01X+1000N004G40N005G01X+1000%"});
  bench.keys("GRAFIK ENTER START");
  bench.run_for(20);
  ASSERT_EQ(pictures.jobs.size(), 1u) << "a portion that nobody does";
  bench.keys("MENU AUTOMAT ENTER ENTER START");
  EXPECT_TRUE(bench.run_until([&] { return bench.snapshot().started; }, 1000)) << bench.picture();
}

TEST(Graphics, SYS_013_ThePictureLeavesAsSvgAndPdf) {
  Bench bench({.tape = std::string(kPart)});
  bench.control.order_picture();
  EXPECT_FALSE(bench.control.poll(bench.now).picture) << "nothing to see in the menu";
  bench.keys("GRAFIK ENTER START");
  bench.run_for(100);
  bench.keys("4");
  bench.control.order_picture();
  std::optional<PutFiles> files;
  for (int i = 0; i < 3 && !files; ++i) files = bench.control.poll(bench.now).picture;
  ASSERT_TRUE(files);
  EXPECT_TRUE(files->is_printed);
  ASSERT_EQ(files->files.size(), 2U);
  EXPECT_EQ(files->files[0].name, "GRAFIK-P0001-XYZ.svg");
  EXPECT_THAT(files->files[0].bytes, HasSubstr("P0001"));
  EXPECT_THAT(files->files[0].bytes, HasSubstr("<svg"));
  EXPECT_EQ(files->files[1].name, "GRAFIK-P0001-XYZ.pdf");
  EXPECT_EQ(files->files[1].bytes.substr(0, 5), "%PDF-");
  EXPECT_FALSE(bench.control.poll(bench.now).picture) << "once";
}

// Row 16 tells of the picture that stands above it, not of the one to come.
TEST(Graphics, Row16NamesTheViewOfThePictureAboveIt) {
  Worker worker;
  Bench bench({.settings = {.picture_work = worker.taking()}, .tape = std::string(kPart)});
  const auto play_on = [&] {
    worker.work();
    bench.run_for(20);
  };
  bench.keys("GRAFIK ENTER START");
  while (!bench.row(18).contains("Eilgang im Material")) play_on();
  play_on();  // a portion that was begun before the end was known
  const auto picture = [&] {
    std::string rows;
    for (int row = 2; row < 15; ++row) rows += bench.monitor(row) + "\n";
    return rows;
  };
  const std::string seen_from_above = picture();
  ASSERT_THAT(bench.monitor(15), HasSubstr("X-Y "));
  bench.keys("2");
  EXPECT_EQ(picture(), seen_from_above);
  EXPECT_THAT(bench.monitor(15), HasSubstr("X-Y ")) << "nobody has drawn it anew";
  EXPECT_TRUE(bench.control.is_busy()) << "the screen is to be looked at again";
  worker.work();
  EXPECT_TRUE(bench.control.is_busy()) << "drawn, but not taken over";
  bench.run_for(20);
  EXPECT_NE(picture(), seen_from_above);
  EXPECT_THAT(bench.monitor(15), HasSubstr("X-Z "));
  EXPECT_FALSE(bench.control.is_busy());
}

// interfaces.md section 3: what a key has changed is contained in the next screen, so the key is handled with it.
TEST(Graphics, AKeyIsHandledWhenItsPictureHasCome) {
  Worker worker;
  Bench bench({.settings = {.picture_work = worker.taking()}, .tape = std::string(kPart)});
  const auto shows_after = [&](std::string_view keys, std::string_view text) {
    bench.keys(keys);
    EXPECT_TRUE(bench.control.awaits_effect()) << keys;
    const std::uint64_t before = bench.control.indication().pictures;
    worker.work();
    bench.run_for(10);
    EXPECT_FALSE(bench.control.awaits_effect()) << keys;
    EXPECT_GT(bench.control.indication().pictures, before) << keys << ": the screen is due";
    EXPECT_THAT(bench.monitor(15), HasSubstr(text)) << keys;
  };
  bench.keys("GRAFIK ENTER");
  EXPECT_TRUE(bench.control.awaits_effect());
  worker.work();
  bench.run_for(10);
  bench.keys("EINZELSATZ");
  EXPECT_FALSE(bench.control.awaits_effect()) << "nothing to draw";
  shows_after("START", "P0001 N001");
  shows_after("START", "P0001 N002");
  shows_after("2", "X-Z");
  shows_after("PLUS_X", "X-Z");
  bench.keys("EINZELSATZ START");
  EXPECT_FALSE(bench.control.awaits_effect()) << "while it plays pictures come by themselves";
}

// The view that the picture on paper takes along answers the key as any other does.
TEST(Graphics, APictureOnPaperLeavesNoKeyWaiting) {
  Worker worker;
  Bench bench({.settings = {.picture_work = worker.taking()}, .tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER");
  worker.work();
  bench.run_for(10);
  bench.keys("2");
  worker.work();
  bench.control.order_picture();
  bench.run_for(10);
  worker.work();
  bench.run_for(10);
  EXPECT_FALSE(bench.control.awaits_effect());
}

TEST(Graphics, AStepThatComesWhileAPortionIsPlayedIsNotLost) {
  Worker worker;
  Bench bench({.settings = {.picture_work = worker.taking()}, .tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER EINZELSATZ START");  // the first picture is still under way
  for (int i = 0; i < 3; ++i) {
    worker.work();
    bench.run_for(10);
  }
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N001"));
}

TEST(Graphics, DEC_37_EinzelsatzHasItsLampAndItsTime) {
  Bench bench({.tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER");
  EXPECT_THAT(bench.row(10), HasSubstr("EINZELS. ○"));
  bench.keys("EINZELSATZ");
  EXPECT_THAT(bench.row(10), HasSubstr("EINZELS. ●"));
  bench.keys("START START START START START");
  EXPECT_THAT(bench.monitor(15), HasSubstr("P0001 N005"));
  EXPECT_THAT(bench.monitor(15), HasSubstr("Weg 35.000 mm  0:00:01")) << "10 mm at 1000 mm/min, 25 mm at F MAX";
}

TEST(Graphics, Row16HasRoomForTheNumberOfFindingsOnLongRuns) {
  Bench bench({.tape = "P0001N001G22P0002N001W24%P0002N001G22P0003N001W99%"
                       "P0003N001G00X+200000N002G00X-200000%"});  // 2500 times 400 mm
  bench.keys("GRAFIK ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.monitor(15).contains("100 %"); })) << bench.picture();
  const std::string row = bench.monitor(15);
  EXPECT_THAT(row, HasSubstr("Weg 1000000 mm  "));
  EXPECT_TRUE(row.ends_with("Meldungen 0")) << row;
}

/// With a real thread, under the thread sanitizer too.
TEST(Graphics, APortionMayRunInAnotherThread) {
  std::vector<std::jthread> threads;
  const LongWork elsewhere = [&](std::function<void()> job) { threads.emplace_back(std::move(job)); };
  Bench bench({.settings = {.picture_work = elsewhere}, .tape = std::string(kPart)});
  bench.keys("GRAFIK ENTER START 2");
  EXPECT_TRUE(bench.run_until(
      [&] {
        std::this_thread::yield();
        return bench.row(18).find("Eilgang im Material") != std::string::npos;
      },
      10'000'000));
}

}  // namespace
}  // namespace cnclab::panel
