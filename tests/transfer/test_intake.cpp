// All or nothing, and how parts join.
#include <gmock/gmock.h>

#include "transfer/intake.hpp"

namespace cnclab::transfer {
namespace {

using language::Reading;
using language::Tongue;

TEST(Intake, TakesProgramsAndMachineData_DEC_34) {
  const auto intake =
      take_in("P0000T001R+5000L+0P0002N001G05P0001N003G11F1000MDN03=400000N20=2400%", Reading::strict, Tongue::german);
  ASSERT_TRUE(intake.has_value());
  ASSERT_EQ(intake->programs.size(), 3u);
  EXPECT_EQ(intake->programs[1].number, 2);  // storage order
  ASSERT_EQ(intake->machine_data.size(), 2u);
  EXPECT_EQ(intake->machine_data[1].value, 2400);
}

TEST(Intake, OneFaultRefusesEverything_DEC_57) {
  const auto intake = take_in("P0001N001G05P0002N001G01X+Y%", Reading::strict, Tongue::german);
  ASSERT_FALSE(intake.has_value());
  EXPECT_EQ(intake.error().program, 2);
}

TEST(Intake, NothingIsAFault) {
  EXPECT_EQ(take_in("%", Reading::strict, Tongue::german).error().code, language::ErrorCode::transfer_wrong);
  EXPECT_EQ(take_in("", Reading::file, Tongue::german).error().code, language::ErrorCode::transfer_wrong);
}

TEST(Intake, CyclesAreLeftOutWithANotice_DEC_06) {
  const auto intake = take_in("P9981N001G05%", Reading::strict, Tongue::german);
  ASSERT_TRUE(intake.has_value());
  EXPECT_TRUE(intake->programs.empty());
  EXPECT_EQ(intake->notices.size(), 1u);
}

TEST(Intake, APartJoinsItsProgram_EXT_061) {
  const auto program = [](std::string_view text) {
    return take_in(text, Reading::strict, Tongue::german).value().programs.front();
  };
  EXPECT_EQ(joined(program("P0001N001G05N003G05N005G05"), program("P0001N003G11F1000N004G05N009G05")),
            program("P0001N001G05N003G11F1000N004G05N005G05N009G05"));
}

}  // namespace
}  // namespace cnclab::transfer
