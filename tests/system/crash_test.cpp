// kill -9 while everybody stores blocks: what was acknowledged is there, and nobody else's (STO-001, STO-002,
// SEAT-004).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

/// Way of block `number` in mm: different for every student and block.
int way_mm(std::size_t student, int number) { return static_cast<int>(student + 1) * 100 + number; }

std::string stored_block(std::size_t student, int number) {
  const std::string digits = std::to_string(number);
  return "N" + std::string(3 - digits.size(), '0') + digits + "G00X+" + std::to_string(way_mm(student, number)) + "000";
}

/// The lines of a program's tape text that are blocks.
std::vector<std::string> blocks_of(const std::string& text) {
  std::vector<std::string> blocks;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("N")) blocks.push_back(line);
  }
  return blocks;
}

class Crash : public testing::Test {
 protected:
  static constexpr std::size_t kStudents = 4;

  Crash() {
    for (std::size_t i = 0; i < kStudents; ++i) {
      names_.push_back("student" + std::to_string(i + 1));
      room_.add_student(names_.back());
    }
  }

  /// Everybody keys in block `number`; EINGABE is acknowledged for all but, where given, the last round's.
  void key_in(std::vector<StationProcess>& stations, int number) {
    for (std::size_t i = 0; i < stations.size(); ++i) {
      stations[i].key(number == 1 ? "EINGABE ENTER ENTER ENTER" : "ENTER ENTER");
      stations[i].type(std::to_string(way_mm(i, number)));
    }
  }

  /// `program show` gives exactly the acknowledged blocks, and at most the one that was on its way.
  void expect_stored(std::size_t student, int acknowledged) {
    const auto blocks = blocks_of(room_.instructor().must({"program", "show", names_[student], "P0001"}).output);
    ASSERT_GE(blocks.size(), static_cast<std::size_t>(acknowledged)) << names_[student];
    ASSERT_LE(blocks.size(), static_cast<std::size_t>(acknowledged) + 1) << names_[student];
    int number = 0;
    for (const auto& block : blocks) EXPECT_EQ(block, stored_block(student, ++number));
  }

  Classroom room_;
  std::vector<std::string> names_;
};

TEST_F(Crash, STO_002_every_acknowledged_block_is_there_for_every_student_and_only_for_that_student) {
  constexpr int kBlocks = 5;
  {
    std::vector<StationProcess> stations;
    for (std::size_t i = 0; i < kStudents; ++i) stations.push_back(room_.seat(static_cast<int>(i) + 1, names_[i]));
    for (int number = 1; number <= kBlocks; ++number) {
      key_in(stations, number);
      for (auto& station : stations) station.key("EINGABE");
    }
    key_in(stations, kBlocks + 1);
    for (auto& station : stations) station.press("EINGABE");
    room_.crash_and_restart();
  }
  for (std::size_t i = 0; i < kStudents; ++i) {
    expect_stored(i, kBlocks);
    EXPECT_EQ(room_.instructor().must({"programs", names_[i]}).objects.size(), 1U);
  }
}

TEST_F(Crash, SEAT_004_after_a_crash_the_mode_returns_always_in_STOP) {
  room_.instructor().must(
      {"program", "send", room_.folder().write("t", "P0001\nN001G01X+100000F1000\n").string(), names_[0]});
  {
    StationProcess station = room_.seat(1, names_[0]);
    station.key("AUTOMAT ENTER ENTER START");
    ASSERT_TRUE(eventually(5s, [&] { return room_.instructor().station(1)["running"] == true; }));
    room_.crash_and_restart();
  }
  StationProcess station = room_.seat(1, names_[0]);
  EXPECT_EQ(room_.instructor().station(1)["running"], false);
  EXPECT_EQ(room_.instructor().station(1)["mode"], "AUTOMAT");
}

TEST_F(Crash, STO_001_the_same_keys_of_two_students_fill_two_memories) {
  StationProcess first = room_.seat(1, names_[0]);
  StationProcess second = room_.seat(2, names_[1]);
  for (StationProcess* station : {&first, &second}) station->key("EINGABE ENTER ENTER ENTER");
  first.type("11");
  second.type("22");
  second.key("EINGABE");
  first.key("EINGABE");
  EXPECT_THAT(room_.instructor().must({"program", "show", names_[0], "P0001"}).output, testing::HasSubstr("X+11000"));
  EXPECT_THAT(room_.instructor().must({"program", "show", names_[1], "P0001"}).output, testing::HasSubstr("X+22000"));
}

TEST_F(Crash, STO_008_the_database_of_a_killed_server_stays_readable_many_times) {
  StationProcess station = room_.seat(1, names_[0]);
  station.key("EINGABE ENTER");
  constexpr int kCrashes = 5;
  for (int crash = 1; crash <= kCrashes; ++crash) {
    station.key("ENTER ENTER");
    station.type(std::to_string(way_mm(0, crash)));
    station.key("EINGABE");
    station.kill_hard();
    room_.crash_and_restart();
    station = room_.seat(1, names_[0]);
    expect_stored(0, crash);
    station.key("MENU EINGABE ENTER");
  }
}

}  // namespace
}  // namespace cnclab::harness
