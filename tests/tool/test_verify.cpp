// `cnclab-tool verify`: the blocks' check codes and the database's own soundness (interfaces.md section 5, SYS-018).
#include <gmock/gmock.h>

#include <functional>

#include "db/database.hpp"
#include "language/tape.hpp"
#include "tool_process.hpp"
#include "transfer/cassette.hpp"
#include "transfer/cassette_recording.hpp"

namespace cnclab::tool {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::int64_t kNow_ms = 1000;

class VerifyTest : public ToolTest {
 protected:
  /// A lab with one student who has stored these blocks, each as (program, number, text).
  struct Row {
    std::uint16_t program = 1;
    int number = 1;
    std::string text;
    std::uint32_t wrong_by = 0;  ///< added to the right check code
  };
  std::string make_lab(const std::vector<Row>& rows) {
    return make_lab([&](db::Database& database, db::PersonId anna) {
      for (const Row& row : rows)
        database.put_block(anna, row.program,
                           {row.number, row.text, language::check_code(row.program, row.text) + row.wrong_by}, kAnna);
    });
  }

  /// A lab with a student anna, who has what `fill` stores.
  std::string make_lab(const std::function<void(db::Database&, db::PersonId)>& fill) {
    auto database = db::Database::open(at("lab.db"));
    if (!database) throw std::runtime_error(database.error().text);
    db::Person anna;
    anna.name = "anna";
    anna.role = "student";
    fill(*database, database->add_person(anna, kNow_ms).value());
    return at("lab.db");
  }

  inline static const db::Author kAnna{"anna", 1, kNow_ms};
};

TEST_F(VerifyTest, ASoundLabIsZero) {
  const Said said = tool("verify " + make_lab({{1, 1, "N001G00X+1000"}, {0, 5, "T005R+5000L+0"}, {1, 2, "N002G17"}}));
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(said.out, "1 people, 2 programs, 3 blocks, 0 machine data, 0 recordings: 0 faults\n");
  EXPECT_EQ(said.err, "");
}

TEST_F(VerifyTest, EveryBlockWithAnotherCheckCodeIsNamed_SYS_018_ERR_010) {
  const std::string file = make_lab(
      {{1, 1, "N001G17"}, {1, 2, "N002G18", 1}, {1, 3, "N003G19"}, {7, 10, "N010G90", 1}, {0, 5, "T005R+5000L+0", 1}});
  const Said said = tool("verify " + file);
  EXPECT_EQ(said.exit_code, 1);
  for (const char* place : {": P0001 N002: anna: ", ": P0007 N010: anna: ", ": P0000 T005: anna: "})
    EXPECT_THAT(said.err, HasSubstr(file + place));
  EXPECT_THAT(said.err, AllOf(Not(HasSubstr("N001")), Not(HasSubstr("N003"))));
  EXPECT_THAT(said.out, HasSubstr("3 faults"));
}

TEST_F(VerifyTest, ABlockUnderAnothersNumberOrUnreadableIsDamaged_ERR_011) {
  const Said said = tool("verify " + make_lab({{1, 4, "N001G17"}, {1, 5, "N005G99"}}));
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, AllOf(HasSubstr("P0001 N004"), HasSubstr("P0001 N005")));
}

TEST_F(VerifyTest, EveryMachineDatumWithAnotherCheckCodeIsNamed_ERR_014) {
  const std::string file = make_lab([](db::Database& database, db::PersonId anna) {
    const auto put = [&](db::PersonId owner, int number, std::int64_t value, std::uint32_t wrong_by) {
      database.put_machine_datum(owner, {number, value, language::datum_check_code(number, value) + wrong_by}, kAnna);
    };
    put(anna, 3, 500'000, 0);
    put(anna, 4, 400'000, 1);
    put(anna, 12, 50, 1);
    put(db::kLabMachine, 5, 300'000, 1);
    put(db::kLabMachine, 9, 3000, 0);
  });
  const Said said = tool("verify " + file);
  EXPECT_EQ(said.exit_code, 1);
  for (const char* place : {": MD 04: anna: is damaged", ": MD 12: anna: is damaged", ": MD 05: the lab's machine: "})
    EXPECT_THAT(said.err, HasSubstr(file + place));
  EXPECT_THAT(said.err, AllOf(Not(HasSubstr("MD 03")), Not(HasSubstr("MD 09"))));
  EXPECT_THAT(said.out, HasSubstr("5 machine data, 0 recordings: 3 faults"));
}

TEST_F(VerifyTest, EveryDamagedBlockOfACassetteIsNamed_DEC_33) {
  using namespace transfer;
  const std::string recording = encode_recording({.program = 7, .text = std::string(300, 'A')});
  Cassette sound, worn;
  ASSERT_TRUE(sound.record(6000, recording));
  ASSERT_TRUE(sound.record(6500, recording));  // upon the first, which lacks its end from then on: no fault
  for (const std::uint32_t start_ms : {6000U, 9000U, 12'000U}) ASSERT_TRUE(worn.record(start_ms, recording));
  ASSERT_TRUE(worn.damage(1, 3));                                        // the mark of the second
  ASSERT_TRUE(worn.damage(2, kMarkLength + kRecordingBlockLength + 5));  // a byte of the second block of the third
  const std::string file = make_lab([&](db::Database& database, db::PersonId anna) {
    database.add_cassette(anna, "K01", sound.serialized(), kNow_ms);
    database.add_cassette(anna, "K02", worn.serialized(), kNow_ms);
    database.add_cassette(anna, "K03", "no cassette at all", kNow_ms);
  });
  const Said said = tool("verify " + file);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, AllOf(HasSubstr(file + ": K02 recording 2: anna: start mark is damaged"),
                              HasSubstr(file + ": K02 recording 3: anna: block 2 is damaged"),
                              HasSubstr(file + ": K03: anna: cassette unreadable (no cassette)")));
  EXPECT_THAT(said.err, AllOf(Not(HasSubstr("K01")), Not(HasSubstr("recording 1"))));
  EXPECT_THAT(said.out, HasSubstr("5 recordings: 3 faults"));
  EXPECT_THAT(tool("--language de verify " + file).err, HasSubstr("K02 Aufnahme 3: anna: Block 2 ist beschädigt."));
}

TEST_F(VerifyTest, ABrokenFileIsSaidAndLeftAsItIs_STO_008) {
  const std::string file = make_lab({{1, 1, "N001G17"}});
  std::string bytes = read(file);
  ASSERT_GT(bytes.size(), 8192u);
  bytes.resize(bytes.size() - 4096);
  write("lab.db", bytes);
  const Said said = tool("verify " + file);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith(file + ": "));
  EXPECT_EQ(read(file), bytes);
}

TEST_F(VerifyTest, WhatIsNoDatabaseIsSaid) {
  for (const std::string& file : {at("missing.db"), write("program.cnc", kPicture7), write("empty.db", "")}) {
    const Said said = tool("verify " + file);
    EXPECT_EQ(said.exit_code, 1) << file;
    EXPECT_THAT(said.err, StartsWith(file + ": ")) << file;
    EXPECT_EQ(said.out, "") << file;
  }
  EXPECT_EQ(tool("verify").exit_code, 2);
}

TEST_F(VerifyTest, STO_008_a_file_that_is_no_database_of_a_lab_is_told_without_a_remedy_that_does_not_help) {
  const std::string file = write("x", "root:x:0:0\n");
  const Said said = tool("verify " + file);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.err, StartsWith(file + ": "));
  EXPECT_THAT(said.err, Not(HasSubstr("--data")));
}

}  // namespace
}  // namespace cnclab::tool
