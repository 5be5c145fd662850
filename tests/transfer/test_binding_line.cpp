// "STATION N TOKEN" (interfaces.md section 8).
#include <gtest/gtest.h>

#include "transfer/binding_line.hpp"

namespace cnclab::transfer {
namespace {

TEST(BindingLine, NamesStationAndToken) {
  EXPECT_EQ(parse_binding("STATION 7 k3Rt92Qd"), (Binding{.station = 7, .token = "k3Rt92Qd"}));
  EXPECT_EQ(parse_binding("STATION 15 a-b_C\r"), (Binding{.station = 15, .token = "a-b_C"}));
}

TEST(BindingLine, EverythingElseIsRefused) {
  for (const char* line :
       {"", "STATION", "STATION ", "STATION 7", "STATION 7 ", "station 7 abc", "STATION 0 abc", "STATION 16 abc",
        "STATION 07 abc", "STATION +7 abc", "STATION -7 abc", "STATION 7x abc", "STATION  7 abc", "STATION 7  abc",
        "STATION 7 abc def", "STATION 7 abc\r\r", "STATION 7 a/b", "STATION 99999999999 abc", "GET / HTTP/1.1"})
    EXPECT_FALSE(parse_binding(line).has_value()) << line;
  EXPECT_TRUE(parse_binding("STATION 7 " + std::string(64, 'a')).has_value());
  EXPECT_FALSE(parse_binding("STATION 7 " + std::string(65, 'a')).has_value());
  EXPECT_FALSE(parse_binding(std::string_view("STATION 7 a\0b", 13)).has_value());
}

}  // namespace
}  // namespace cnclab::transfer
