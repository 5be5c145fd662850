// Modal state and parameters through JSON: kept between two logins (SEAT-002) and for replays (STO-007).
#include <gtest/gtest.h>

#include "panel/modal_json.hpp"

namespace cnclab::panel {
namespace {

using Json = nlohmann::json;

/// Every field another than at power-on.
program::ModalState unusual() {
  return {.plane = geometry::Plane::yz,
          .radius = program::RadiusCompensation::minus,
          .length_compensation = true,
          .tool_radius = {5000},
          .tool_length = {-120'500},
          .scale_on = true,
          .scale = {500, -1000, 2000},
          .dimension = program::Dimension::absolute,
          .feed_mm_per_min = 1250,
          .spindle_rpm = 2800,
          .tool = 7,
          .m = 4,
          .spindle = geometry::SpindleTurn::counterclockwise,
          .coolant = true,
          .blocks_hidden = true,
          .subprogram_blocks_hidden = true,
          .potentiometer_off = true,
          .test_run = true};
}

TEST(ModalJson, SEAT_002_STO_007_EveryFieldComesBack) {
  EXPECT_EQ(modal_of(modal_json(unusual())), unusual());
  EXPECT_EQ(modal_of(modal_json({})), program::ModalState());
}

TEST(ModalJson, SEAT_002_WhatIsMissingWrongOrOutOfRangeKeepsItsDefault) {
  for (const Json& wrong :
       {Json(nullptr), Json(-1'000'000'000), Json(1'000'000'000), Json("one"), Json::array({1, 2}), Json(0.5)}) {
    Json json = modal_json(unusual());
    for (auto& [name, value] : json.items()) value = wrong;
    EXPECT_EQ(modal_of(json), program::ModalState()) << wrong;
  }
  EXPECT_EQ(modal_of(Json::object()), program::ModalState());
}

TEST(ModalJson, SEAT_002_AStateOfVersion010HasItsDimensionAsAFlag) {
  EXPECT_EQ(modal_of({{"absolute", true}}).dimension, program::Dimension::absolute);
  EXPECT_EQ(modal_of({{"absolute", false}}).dimension, program::Dimension::incremental);
}

TEST(ModalJson, SEAT_002_ParametersComeBackByTheirNumber) {
  program::Parameters parameters{};
  parameters[4] = 25'000'000;
  parameters[69] = -1;
  const Json json = parameters_json(parameters);
  EXPECT_EQ(json, (Json{{"4", 25'000'000}, {"69", -1}}));
  EXPECT_EQ(parameters_of(json), parameters);
  EXPECT_EQ(parameters_of({{"4", "x"}, {"70", 5}, {"69", 1e300}}), program::Parameters());
}

}  // namespace
}  // namespace cnclab::panel
