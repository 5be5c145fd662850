// One row of a stopped server's database altered: what the check codes are for (STO-003). Nothing moves by it, nothing
// makes it good by itself, and nothing of it leaves the lab without a word.
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;
using testing::Not;

class Damage : public testing::Test {
 protected:
  OneShot ask(const std::vector<std::string>& arguments) { return room_.instructor().run(arguments); }
  OneShot must(const std::vector<std::string>& arguments) { return room_.instructor().must(arguments); }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& words) {
    const OneShot shot = ask(arguments);
    EXPECT_EQ(shot.exit_code, 1) << shot.output;
    EXPECT_THAT(shot.errors, HasSubstr(words));
  }
  /// The server starts again with what `sql` has made of its database.
  void damage(const std::string& sql) {
    room_.server().kill_hard();
    {
      SQLite::Database database((room_.data() / "cnclab.db").string(), SQLite::OPEN_READWRITE);
      ASSERT_GT(database.exec(sql), 0) << sql;
    }
    room_.crash_and_restart();
  }

  Classroom room_;
};

TEST_F(Damage, AUTH_011_STO_003_a_damaged_datum_of_the_machine_lifts_no_limit_nobody_is_given_the_machine) {
  room_.add_student("anna");
  must({"machine-data", "06=1000", "03=100000"});
  damage("UPDATE machine_datum SET check_code = check_code + 1 WHERE person_id = 0 AND number = 22");
  StationProcess anna = room_.seat(1, "anna");
  EXPECT_THAT(room_.server().log(), HasSubstr("CHECKSUM FEHLER"));
  EXPECT_TRUE(eventually(5s, [&] { return must({"journal", ""}).output.contains("CHECKSUM FEHLER"); }));
  EXPECT_EQ(room_.instructor().status()["machine"]["damaged_data"], nlohmann::json::array({22}));
  expect_refused({"select", "1"}, "CHECKSUM FEHLER: Maschinendaten der Maschine beschädigt, Nummer 22.");
  expect_refused({"select", "1", "--force"}, "machine-data 22=");
  expect_refused({"machine-data"}, "CHECKSUM FEHLER");
  expect_refused({"machine-data", "07=1000"}, "22");
  EXPECT_EQ(room_.instructor().status()["offered"], 0);
  must({"machine-data", "22=0"});
  EXPECT_TRUE(room_.instructor().status()["machine"]["damaged_data"].empty());
  const std::string data = must({"machine-data"}).output;
  EXPECT_THAT(data, HasSubstr(R"({"number":6,"value":1000})")) << "what was whole is as it was";
  EXPECT_THAT(data, HasSubstr(R"({"number":3,"value":100000})"));
  room_.give_machine(1, anna);
}

TEST_F(Damage, STO_003_STO_005_a_version_comes_back_as_it_was_stored_whatever_the_blocks_have_become) {
  room_.add_student("anna", {"P0002\nN001G91\nN002G11F1000\nN003G01X+1000\n"});
  damage("UPDATE block SET text = 'N003G01X+9000' WHERE program = 2 AND number = 3");
  must({"program", "restore", "anna", "P0002", "1"});
  EXPECT_EQ(must({"program", "show", "anna", "P0002"}).output, "P0002\nN001G91\nN002G11F1000\nN003G01X+1000\n%\n");
}

TEST_F(Damage, STO_003_STO_005_a_damaged_record_of_the_changes_restores_nothing) {
  room_.add_student("anna", {"P0002\nN001G91\nN002G01X+1000F1000\n"});
  damage("UPDATE program_change SET after = replace(after, 'X+1000', 'X+9000')");
  expect_refused({"program", "restore", "anna", "P0002", "1"}, "CHECKSUM FEHLER: P0002 N002 ist beschädigt.");
}

TEST_F(Damage, STO_003_damaged_blocks_and_data_do_not_leave_the_lab_by_the_instructors_commands) {
  room_.add_student("anna", {"P0001\nN001G91\n", "P0002\nN001G91\nN002G01X+1000F1000\n"});
  damage("UPDATE block SET text = 'N002G01X+9000F1000' WHERE program = 2 AND number = 2");
  expect_refused({"program", "show", "anna", "P0002"}, "CHECKSUM FEHLER: anna P0002 N002 ist beschädigt.");
  const auto folder = room_.folder().path() / "collected";
  std::filesystem::create_directory(folder);
  expect_refused({"program", "collect", folder.string()}, "CHECKSUM FEHLER: anna P0002 N002");
  EXPECT_THAT(must({"program", "show", "anna", "P0001"}).output, HasSubstr("N001G91")) << "the others do";
  EXPECT_THAT(must({"program", "show", "anna", "P0002", "--version", "1"}).output, HasSubstr("X+1000"));
  must({"program", "restore", "anna", "P0002", "1"});
  EXPECT_THAT(must({"program", "show", "anna", "P0002"}).output, Not(HasSubstr("X+9000")));
  must({"program", "collect", folder.string()});
}

}  // namespace
}  // namespace cnclab::harness
