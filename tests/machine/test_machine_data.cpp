// Machine data: the table of D-112, limits, files, DEC-20 and DEC-25.
#include <gtest/gtest.h>

#include "machine/machine_data.hpp"

namespace cnclab::machine {
namespace {

struct DatumRow {
  int number;
  std::int64_t least, most, standard;
};

TEST(MachineData, D112TableOfNumbersLimitsAndDefaults) {
  const std::vector<DatumRow> rows{{3, 1, 9'999'999, 500'000}, {4, 1, 9'999'999, 500'000},
                                   {5, 1, 9'999'999, 500'000}, {6, 300, 9999, 3000},
                                   {7, 1, 9999, 3000},         {9, 1, 99, 2},
                                   {10, 1, 3000, 300},         {11, 0, 9999, 500},
                                   {12, 1, 9999, 100},         {14, 1, 9999, 200},
                                   {15, 1, 9999, 200},         {16, 1, 9999, 200},
                                   {17, 1, 9999, 200},         {22, 0, 1, 1}};
  ASSERT_EQ(datum_forms().size(), 16U);
  for (const auto& row : rows) {
    MachineData data;
    EXPECT_EQ(data.get(row.number), row.standard) << row.number;
    EXPECT_TRUE(data.set(row.number, row.least)) << row.number;
    EXPECT_EQ(data.get(row.number), row.least) << row.number;
    EXPECT_TRUE(data.set(row.number, row.most)) << row.number;
    EXPECT_FALSE(data.set(row.number, row.least - 1)) << row.number;
    EXPECT_FALSE(data.set(row.number, row.most + 1)) << row.number;
    EXPECT_EQ(data.get(row.number), row.most) << "unchanged by a refused value";
  }
}

TEST(MachineData, MD004UndocumentedNumbersAreRefused) {
  for (const int number : {-1, 0, 1, 2, 8, 13, 18, 21, 23}) EXPECT_FALSE(MachineData().set(number, 1)) << number;
}

TEST(MachineData, MD119AndMD120TakeListedValuesOnly) {
  MachineData data;
  for (const int rate : {300, 600, 1200, 2400, 4800}) EXPECT_TRUE(data.set(20, rate)) << rate;
  for (const int rate : {301, 9600, 110}) EXPECT_FALSE(data.set(20, rate)) << rate;
  EXPECT_TRUE(data.set(19, 51503));
  EXPECT_FALSE(data.set(19, 202));
}

TEST(MachineData, DEC20MeaningInMotion) {
  const motion::Limits limits = motion_limits({});
  EXPECT_NEAR(limits.acceleration_mm_per_s2, 166.667, 1e-3);
  EXPECT_NEAR(limits.stop_deceleration_mm_per_s2, 166.667 / 1.2, 1e-3);
  EXPECT_DOUBLE_EQ(limits.f_max_mm_per_s, 50);
  EXPECT_DOUBLE_EQ(limits.start_stop_mm_per_s, 5);
  EXPECT_DOUBLE_EQ(limits.creep_way_mm, 0.5);
  EXPECT_EQ(limits.steps_per_mm, (std::array<double, 4>{200, 200, 200, 200}));
}

TEST(MachineData, DEC25WhoseDataHoldOnTheLabMachine) {
  MachineData student, lab;
  for (const auto& form : datum_forms()) {
    if (form.number == 19 || form.number == 20 || form.number == 22) continue;
    ASSERT_TRUE(student.set(form.number, form.standard + 1));
  }
  ASSERT_TRUE(student.set(3, 100));
  ASSERT_TRUE(student.set(6, 2000));
  ASSERT_TRUE(student.set(20, 4800));
  ASSERT_TRUE(student.set(22, 0));
  ASSERT_TRUE(lab.set(19, 51503));
  const MachineData both = on_lab_machine(student, lab);
  EXPECT_EQ(both.get(3), 100) << "the smaller: the student's";
  EXPECT_EQ(both.get(4), 500'000) << "the smaller: the machine's";
  EXPECT_EQ(both.get(6), 2000);
  EXPECT_EQ(both.get(7), 3000);
  for (const int number : {9, 10, 11, 12, 14, 15, 16, 17, 19}) EXPECT_EQ(both.get(number), lab.get(number)) << number;
  EXPECT_EQ(both.get(20), 4800);
  EXPECT_EQ(both.get(22), 0);
}

TEST(MachineData, DEC25FMaxBelowTheMachinesStartStopStaysTheLimit) {
  MachineData student;
  ASSERT_TRUE(student.set(10, 50));
  ASSERT_TRUE(student.set(6, 100));
  const motion::Limits limits = motion_limits(on_lab_machine(student, {}));
  EXPECT_LE(limits.start_stop_mm_per_s, limits.f_max_mm_per_s);
}

TEST(MachineData, FileSetsWhatItNamesAndKeepsTheRest) {
  const auto data = read_machine_data("# machine\n06 = 200 # F MAX\r\n\n 10=100\n3 =250000");
  ASSERT_TRUE(data) << data.error().reason;
  EXPECT_EQ(data->get(6), 200);
  EXPECT_EQ(data->get(10), 100) << "F MAX and F START/STOP in any order";
  EXPECT_EQ(data->get(3), 250'000);
  EXPECT_EQ(data->get(4), 500'000);
}

struct BadFileRow {
  const char* text;
  int line;
};

TEST(MachineData, FileErrorsNameTheLine) {
  const std::vector<BadFileRow> rows{
      {"06 = 3000\nF MAX 3000", 2},     {"06 = 30x", 1}, {"\n\n08 = 1", 3}, {"06 = 10000", 1}, {"10 = 4000", 1},
      {"06 = 99999999999999999999", 1}, {"= 5", 1}};
  for (const auto& row : rows) {
    const auto data = read_machine_data(row.text);
    ASSERT_FALSE(data) << row.text;
    EXPECT_EQ(data.error().line, row.line) << row.text << ": " << data.error().reason;
    EXPECT_FALSE(data.error().reason.empty()) << row.text;
  }
}

}  // namespace
}  // namespace cnclab::machine
