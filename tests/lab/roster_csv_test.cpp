// The roster's CSV: what is read, what is refused and in which line (INS-004).
#include "lab/console/roster_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cnclab::lab {
namespace {

using language::Tongue;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::vector<std::string>> fields(const Roster& roster) {
  std::vector<std::vector<std::string>> all;
  for (const auto& entry : roster.entries) all.push_back({entry.name, entry.password, entry.language});
  return all;
}

TEST(RosterCsv, INS_004_ReadsEveryWayToWriteALine) {
  struct Row {
    const char* name;
    const char* csv;
    std::vector<std::string> entry;
  };
  const Row rows[] = {
      {"all three", "anna,geheim123,de", {"anna", "geheim123", "de"}},
      {"name alone", "anna", {"anna", "", ""}},
      {"empty password", "anna,,en", {"anna", "", "en"}},
      {"commas at the end", "anna,,", {"anna", "", ""}},
      {"spaces around", "  anna , geheim123 , de ", {"anna", "geheim123", "de"}},
      {"quoted, with comma and quotation mark", "anna,\"ge,\"\"heim\"\"1\",de", {"anna", "ge,\"heim\"1", "de"}},
      {"quoted, spaces kept", "anna,\" geheim \"", {"anna", " geheim ", ""}},
      {"heading", "name,password,language\nanna", {"anna", "", ""}},
      {"heading of two columns (SEC-002)", "name,password\nanna,annas_wort", {"anna", "annas_wort", ""}},
      {"heading of one column", "name\nanna", {"anna", "", ""}},
      {"heading in large letters, with blanks", "Name, Password , LANGUAGE\nanna", {"anna", "", ""}},
      {"heading in quotation marks", "\"name\",\"password\"\nanna", {"anna", "", ""}},
      {"byte order mark and CR LF", "\xEF\xBB\xBFname,password,language\r\nanna,,de\r\n", {"anna", "", "de"}},
      {"umlaut", "jürgen", {"jürgen", "", ""}},
  };
  for (const Row& row : rows) {
    const Roster roster = read_roster(row.csv, Tongue::english);
    EXPECT_TRUE(roster.errors.empty()) << row.name;
    EXPECT_THAT(fields(roster), ElementsAre(row.entry)) << row.name;
  }
}

TEST(RosterCsv, INS_004_NamesTheLineOfEveryError) {
  struct Row {
    const char* name;
    const char* csv;
    const char* starts;
    const char* says;
  };
  const Row rows[] = {
      {"no name", "anna\n,geheim123,de", "line 2: ", "name"},
      {"blank in the name", "an na", "line 1: ", "name"},
      {"name of 33 bytes", "abcdefghijklmnopqrstuvwxyzabcdefg", "line 1: ", "name"},
      {"a folder's own name", "anna\n..", "line 2: ", "name"},
      {"twice", "anna\notto\n\nanna", "line 4: ", "above"},
      {"short password", "anna,kurz", "line 1: ", "password"},
      {"unknown language", "anna,,fr", "line 1: ", "language"},
      {"four fields", "anna,,de,1", "line 1: ", "expected"},
      {"quotation mark left open", "anna,\"geheim123", "line 1: ", "expected"},
      {"text behind a quoted field", "anna,\"geheim123\"x,de", "line 1: ", "expected"},
      {"heading in the middle", "anna\nname,password,language", "line 2: ", "language"},
  };
  for (const Row& row : rows) {
    const Roster roster = read_roster(row.csv, Tongue::english);
    EXPECT_THAT(roster.errors,
                ElementsAre(testing::Pair(testing::_, testing::AllOf(StartsWith(row.starts), HasSubstr(row.says)))))
        << row.name;
  }
}

TEST(RosterCsv, INS_004_WhatIsWrittenIsReadBack) {
  const std::vector<RosterEntry> entries{
      {"anna", "", "de", 0}, {"otto", "a,b\"c\"defg", "", 0}, {"eva", " blanks\t", "", 0}};
  const Roster back = read_roster(write_roster(entries), Tongue::german);
  EXPECT_TRUE(back.errors.empty());
  EXPECT_THAT(fields(back), ElementsAre(std::vector<std::string>{"anna", "", "de"},
                                        std::vector<std::string>{"otto", "a,b\"c\"defg", ""},
                                        std::vector<std::string>{"eva", " blanks\t", ""}));
}

}  // namespace
}  // namespace cnclab::lab
