// What a run was begun with, read back from a database that may hold anything (STO-007).
#include "lab/runs/run_order_json.hpp"

#include <gtest/gtest.h>

#include "language/tape.hpp"

namespace cnclab::lab {
namespace {

using Json = nlohmann::json;

class RunOrderJson : public testing::Test {
 protected:
  RunOrderJson() {
    db::Person person;
    person.name = "eva";
    person.role = "student";
    eva_ = database_.add_person(person, 1).value();
  }
  Json good() {
    panel::RunOrder order;
    order.programs.put(language::read_tape("P0001N001G01X+1000", language::Reading::file).programs.at(0).program);
    return order_json(order, database_, eva_);
  }
  db::Database database_ = db::Database::open(":memory:").value();
  db::PersonId eva_{};
};

TEST_F(RunOrderJson, STO_007_WhatWasWrittenIsReadAsTheSame) {
  const auto order = order_of(good(), database_, eva_);
  ASSERT_TRUE(order) << order.error();
  EXPECT_EQ(order_json(*order, database_, eva_), good());
}

TEST_F(RunOrderJson, STO_007_ERR_010_DamagedBlocksStayDamaged) {
  panel::RunOrder order;
  for (language::ReadProgram& read :
       language::read_tape("P0000T001R+5000L+0P0001N001G01X+1000N002G90", language::Reading::file).programs) {
    read.program.blocks.back().is_damaged = true;
    order.programs.put(std::move(read.program));
  }
  const auto again = order_of(order_json(order, database_, eva_), database_, eva_);
  ASSERT_TRUE(again) << again.error();
  EXPECT_TRUE(again->programs.has_damaged_row(1));
  EXPECT_FALSE(again->programs.find(1)->blocks[0].is_damaged);
  EXPECT_TRUE(again->programs.find(1)->blocks[1].is_damaged);
}

TEST_F(RunOrderJson, STO_007_AValueOutsideItsRangeIsRefusedByName) {
  struct Row {
    const char* place;
    Json value;
    const char* named;
  };
  const std::vector<Row> rows{{"/modal/plane", 3, "plane"},
                              {"/modal/radius", -1, "radius"},
                              {"/modal/dimension", 2, "dimension"},
                              {"/modal/spindle", 99, "spindle"},
                              {"/modal/f", 100'000, "f"},
                              {"/modal/t", "one", "t: "},
                              {"/modal/m25", true, "m25"},
                              {"/program", 10'000, "program"},
                              {"/block", 7, "P0001 N007"},
                              {"/texts/10000", Json::array({"N001G90"}), "P10000"},
                              {"/versions/2", 99, "P0002 version 99"},
                              {"/parameters/70", 1, "70"},
                              {"/parameters/69", 0.5, "69"},
                              {"/position", Json::array({1.0}), ""}};
  for (const Row& row : rows) {
    Json json = good();
    json[Json::json_pointer(row.place)] = row.value;
    const auto order = order_of(json, database_, eva_);
    ASSERT_FALSE(order) << row.place;
    EXPECT_NE(order.error().find(row.named), std::string::npos) << row.place << ": " << order.error();
  }
}

}  // namespace
}  // namespace cnclab::lab
