// Every byte on a serial device, against a pseudo-terminal and the real server (EXT-043 to EXT-056, D-98 to D-105).
#include <gmock/gmock.h>

#include "dnc/dnc_rig.hpp"

namespace cnclab::harness {
namespace {

using namespace std::string_view_literals;
using testing::HasSubstr;
using testing::Not;

// DC1 and DC3 with even parity in bit 8 (EXT-044).
constexpr std::string_view kOn = "\x11", kOff = "\x93\x93";

/// What is pressed, what the computer says, what it hears from the first byte to the last, what is stored then.
struct Row {
  const char* name;
  const char* keys;
  std::string_view said;
  std::string heard;
  const char* stored = "";  ///< part of what `program show` prints of P0001; empty: nothing is stored
};

std::string bytes(std::initializer_list<std::string_view> parts) {
  std::string all;
  for (const std::string_view part : parts) all += part;
  return all;
}

const std::vector<Row> kRows{
    {"EXT_046_047_leading_NUL", "9 CLEAR ENTER", "\0\0\0P0001N001G04H0001%"sv, bytes({kOn, kOff}), "N001G04H0001"},
    {"EXT_049_filter", "9 CLEAR ENTER",
     " \r\nP0`0abc0~1 N0\x7F"
     "02G04H00 02%"sv,
     bytes({kOn, kOff}), "N002G04H0002"},
    {"D_103_received_parity", "9 CLEAR ENTER",
     "\xD0\x30\x30\x30\xB1\x4E\x30\x30\x33\x47\x30\xB4H\x30\x30\x30\x33\xA5"sv, bytes({kOn, kOff}), "N003G04H0003"},
    {"EXT_052_054_two_programs", "9 CLEAR ENTER", "P0002N001G04H0001\0\0\0\0\0\0P0001N004G04H0004%"sv,
     bytes({kOn, kOff, kOn, kOff}), "N004G04H0004"},
    {"EXT_053_behind_the_end", "9 CLEAR ENTER", "P0001N005G04H0005%P0001N006G04H0006%"sv, bytes({kOn, kOff}),
     "N005G04H0005"},
    {"DEC_58_continued", "9 CLEAR ENTER", "P0001N006G04H0006\0N007G04H0007%"sv, bytes({kOn, kOff, kOn, kOff}),
     "N007G04H0007"},
    {"DEC_62_key_7", "7 CLEAR ENTER", "P0001N008G04H0008%"sv, bytes({kOn, kOff}), "N008G04H0008"},
    {"D_105_sought", "9 CLEAR 1 ENTER", "P0002N001G04H0001\0P0001N009G04H0009%"sv, bytes({kOn, kOff, kOn, kOff}),
     "N009G04H0009"},
    {"EXT_050_EX_050_signed_integers", "9 CLEAR ENTER", "P0001N010G00X+12Y-1500000Z+4150%"sv, bytes({kOn, kOff}),
     "N010G00X+12Y-1500000Z+4150"},
    {"EXT_051_D_102_wrong_beginning", "9 CLEAR ENTER", "N011G04H0001%"sv, bytes({kOn, kOff})},
    {"D_97_no_command_without_REMOTE", "9 CLEAR ENTER", "#"sv, bytes({kOn, kOff})},
    {"EXT_066_no_start_without_REMOTE", "9 CLEAR ENTER", "P0001N010*%"sv, bytes({kOn, kOff})},
    {"EXT_031_044_key_5_sends_even_parity", "5 CLEAR 1 ENTER", ""sv,
     "P\x30\x30\x30\xB1\x8D\x0AN\x30\xB1\x30G\x30\x30\xD8+\xB1\xB2Y-\xB1\x35\x30\x30\x30\x30\x30\x5A+"
     "\xB4\xB1\x35\x30\x8D\x0A\xA5"},
    {"DEC_62_key_3_sends_too", "3 CLEAR 2 ENTER", ""sv,
     "P\x30\x30\x30\xB2\x8D\x0AN\x30\x30\xB1G\x30\xB4H\x30\x30\x30\xB1\x8D\x0A\xA5"},
};

class DncBytes : public testing::Test {
 protected:
  DncBytes() : computer_(open_pseudo_terminal(device_)) {}
  std::string device_;
  LineEnd computer_;
};

TEST_F(DncBytes, EXT_043_to_056_are_held_to_the_byte) {
  Classroom room("[dnc]\ndevice = \"" + device_ + "\"\nstation = 1\n");
  room.add_student("anna");
  StationProcess anna = room.seat(1, "anna");
  anna.key("EXTERNE_DATEN");
  anna.wait_for("LEITUNG");
  const auto stored = [&] { return room.instructor().run({"program", "show", "anna", "P0001"}).output; };
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    const std::string before = stored();
    anna.key(row.keys);
    std::string heard = computer_.hear(row.said.empty() ? row.heard.size() : 1);
    computer_.say(row.said);
    heard += computer_.hear(row.heard.size() - heard.size());
    EXPECT_EQ(heard, row.heard);
    anna.wait_gone("STOP bricht ab");  // the transfer is over
    if (std::string_view(row.stored).empty())
      EXPECT_EQ(stored(), before);
    else
      EXPECT_THAT(stored(), HasSubstr(row.stored));
  }
  EXPECT_TRUE(computer_.is_silent_for(50ms)) << "and no byte more";
}

TEST_F(DncBytes, EXT_048_D_100_the_4097th_character_ends_the_reading) {
  Classroom room("[dnc]\ndevice = \"" + device_ + "\"\nstation = 1\n");
  room.add_student("anna");
  StationProcess anna = room.seat(1, "anna");
  anna.key("EXTERNE_DATEN 9 CLEAR ENTER");
  EXPECT_EQ(computer_.hear(1), kOn);
  std::string text = "P0001N001G04H0001";
  for (int block = 2; text.size() < 4097; ++block)
    text += "N" + std::string(block < 10 ? "00" : (block < 100 ? "0" : "")) + std::to_string(block) + "G04H0001";
  computer_.say(text);
  EXPECT_EQ(computer_.hear(2), kOff);
  anna.wait_for("Uebertragung falsch");
  EXPECT_NE(room.instructor().run({"program", "show", "anna", "P0001"}).exit_code, 0) << "nothing is stored";
}

TEST_F(DncBytes, D_107_STOP_tells_the_sender) {
  Classroom room("[dnc]\ndevice = \"" + device_ + "\"\nstation = 1\n");
  room.add_student("anna");
  StationProcess anna = room.seat(1, "anna");
  anna.key("EXTERNE_DATEN 9 CLEAR ENTER");
  EXPECT_EQ(computer_.hear(1), kOn);
  computer_.say("P0001N001G0");
  anna.key("STOP");
  EXPECT_EQ(computer_.hear(2), kOff);
  computer_.say("4H0001%");
  anna.wait_for("abgebrochen");
  EXPECT_NE(room.instructor().run({"program", "show", "anna", "P0001"}).exit_code, 0);
}

/// Over TCP the control keeps the time of machine datum 20 (EXT-045): 1200 baud are 120 characters in a second.
TEST(DncPace, EXT_045_TCP_has_the_pace_of_the_baud_rate) {
  Classroom room("[dnc]\nlisten = \"127.0.0.1:0\"\n");
  room.add_student("anna", {"P0001\nN001G04H0001\nN002G04H0002\nN003G04H0003\n"});
  StationProcess anna = room.seat(1, "anna");
  const std::string binding = binding_on(anna);
  const LineEnd computer(connect_to(dnc_port(room)));
  computer.say(binding + "\n");
  anna.wait_for("LEITUNG ●");
  const auto begun = std::chrono::steady_clock::now();
  anna.key("5 CLEAR 1 ENTER");
  constexpr std::size_t kLength = 7 + 3 * 14 + 1;  // "P0001" CR LF, three blocks with CR LF, "%"
  EXPECT_EQ(computer.hear(kLength).size(), kLength);
  const auto passed = std::chrono::steady_clock::now() - begun;
  EXPECT_GE(passed, 416ms) << "50 characters of 10 bits; slower it may be, never faster";
}

}  // namespace
}  // namespace cnclab::harness
