// The serial line, byte for byte (EXT-043 to EXT-066, D-97 to D-102, DEC-58).
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cstdlib>

#include "line_rig.hpp"

namespace cnclab::transfer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// One conversation: what the other side says, what the control sends, what happens.
struct Row {
  const char* name;
  bool remote;
  std::string_view said;
  const char* sent;  ///< from the first DC1 on
  std::vector<std::string> events;
};

class Conversation : public testing::TestWithParam<Row> {};

INSTANTIATE_TEST_SUITE_P(
    Rules, Conversation,
    testing::Values(
        Row{"EX_050_to_054",
            false,
            "P0001N001G00X+12Y-1500000Z+4150N999G01Z+500\r\nM05 \0\0\0\0\0\0P0002N003G11F1000%"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3>",
            {"text[P0001N001G00X+12Y-1500000Z+4150N999G01Z+500M05]", "text[P0002N003G11F1000]."}},
        Row{"EXT_046_asks_with_DC1", false, ""sv, "<DC1>", {}},
        Row{"EXT_047_leading_NUL_are_skipped",
            false,
            "\0\0\0\0\0\0\0\0P0001N001G05%"sv,
            "<DC1><DC3><DC3>",
            {"text[P0001N001G05]."}},
        Row{"EXT_047_line_ends_before_NUL_begin_nothing",
            false,
            "\r\n\0\0P0001N001G05%"sv,
            "<DC1><DC3><DC3>",
            {"text[P0001N001G05]."}},
        Row{"EXT_049_filter",
            false,
            " P0\t0`0~1abc N\x7F"
            "001G05\x1F%"sv,
            "<DC1><DC3><DC3>",
            {"text[P0001N001G05]."}},
        Row{"D_103_received_parity_is_masked",
            false,
            "\xD0\xB0\xB0\xB0\xB1\xCE\xB0\xB0\xB1\xC7\xB0\xB5\xA5"sv,
            "<DC1><DC3><DC3>",
            {"text[P0001N001G05]."}},
        Row{"EXT_053_data_behind_the_end_are_ignored",
            false,
            "P0001N001G05%P0002N001G05%"sv,
            "<DC1><DC3><DC3>",
            {"text[P0001N001G05]."}},
        Row{"EXT_054_one_NUL_ends_a_program",
            false,
            "P0001N001G05\0P0002N001G05\0"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3><DC1>",
            {"text[P0001N001G05]", "text[P0002N001G05]"}},
        Row{"EXT_055_end_behind_a_separator",
            false,
            "P0001N001G05\0\0\0\0\0\0%"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3>",
            {"text[P0001N001G05]", "text[]."}},
        Row{"EXT_051_begins_without_P", false, "N001G05%"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"EXT_051_three_digits", false, "P001N001G05%"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"EXT_051_too_short", false, "P0001N00%"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"EXT_051_no_block", false, "P0001%"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"D_101_tool_table", false, "P0000T001R+5000L+1000%"sv, "<DC1><DC3><DC3>", {"text[P0000T001R+5000L+1000]."}},
        Row{"D_102_T_only_in_the_tool_table", false, "P0001T001R+5000%"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"DEC_62_machine_data_are_exempt",
            false,
            "P0001N001G05\0MDN03=500000%"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3>",
            {"text[P0001N001G05]", "text[MDN03=500000]."}},
        Row{"DEC_58_continued_in_the_same_reading",
            false,
            "P0001N001G05\0N002G05\0N003G05%"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3><DC1><DC3><DC3>",
            {"text[P0001N001G05]", "more[P0001N002G05]", "more[P0001N003G05]."}},
        Row{"DEC_58_tool_table_is_continued",
            false,
            "P0000T001R+5000\0T002R+1000%"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3>",
            {"text[P0000T001R+5000]", "more[P0000T002R+1000]."}},
        Row{"EXT_066_no_start_without_REMOTE", false, "P0001N001*"sv, "<DC1>", {}},
        Row{"D_97_no_erasing_without_REMOTE", false, "#"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"D_98_no_query_without_REMOTE", false, "!"sv, "<DC1><DC3><DC3>", {"wrong"}},
        Row{"EXT_060_start", true, "P0002N015*"sv, "<DC1><DC3><DC3>", {"start P2 N15"}},
        Row{"EXT_060_star_is_text_behind_the_tenth",
            true,
            "P0002N015G*%"sv,
            "<DC1><DC3><DC3><DC1>",
            {"text[P0002N015G*]."}},
        Row{"EXT_061_continues_the_active_program",
            true,
            "N020G05\0"sv,
            "<DC1><DC3><DC3><DC1>",
            {"more[P0005N020G05]"}},
        Row{"EXT_062_erase",
            true,
            "#P0001N001G05\0"sv,
            "<DC1><DC3><DC3><DC1><DC3><DC3><DC1>",
            {"erase", "text[P0001N001G05]"}},
        Row{"D_97_only_as_the_first_character",
            true,
            "P0001N001G05#%"sv,
            "<DC1><DC3><DC3><DC1>",
            {"text[P0001N001G05#]."}},
        Row{"EXT_063_query", true, "!"sv, "<DC1>P0007N012S%", {"query"}},
        Row{"EXT_063_query_between_programs",
            true,
            "P0001N001G05\0!P0002N001G05\0"sv,
            "<DC1><DC3><DC3><DC1>P0007N012S%<DC3><DC3><DC1>",
            {"text[P0001N001G05]", "query", "text[P0002N001G05]"}},
        Row{"EXT_064_further_data_are_awaited",
            true,
            "P0001N001G05\0"sv,
            "<DC1><DC3><DC3><DC1>",
            {"text[P0001N001G05]"}},
        Row{"EXT_065_REMOTE_polls_on_behind_the_end",
            true,
            "P0001N001G05%"sv,
            "<DC1><DC3><DC3><DC1>",
            {"text[P0001N001G05]."}}),
    [](const testing::TestParamInfo<Row>& row) { return row.param.name; });

TEST_P(Conversation, IsHeldToTheByte) {
  const Row& row = GetParam();
  LineRig rig;
  row.remote ? rig.line.begin_remote(5, rig.now) : rig.line.begin_reading(rig.now);
  rig.say(row.said);
  EXPECT_EQ(rig.sent(), row.sent);
  EXPECT_EQ(rig.events, row.events);
}

/// The same one character at a time gives the same.
TEST_P(Conversation, DoesNotDependOnHowBytesArrive) {
  const Row& row = GetParam();
  LineRig rig;
  row.remote ? rig.line.begin_remote(5, rig.now) : rig.line.begin_reading(rig.now);
  for (const char byte : row.said) rig.say({&byte, 1}).pass(Time(100));
  EXPECT_EQ(rig.sent(), row.sent);
  EXPECT_EQ(rig.events, row.events);
}

TEST(SerialLine, SendsEvenParity_EXT_044) {
  LineRig rig;
  rig.line.begin_remote(5, rig.now);
  rig.say("!P0001N001G05\0"sv);
  EXPECT_EQ(rig.line.take_output(rig.now), "\x11P00\x30\xB7N0\xB1\xB2S\xA5\x93\x93\x11"sv);
}

std::string program_of(std::size_t characters) {
  std::string text = "P0001N001";
  text.append(characters - text.size(), 'X');
  return text;
}

TEST(SerialLine, The4096thCharacterIsKept_EXT_048) {
  LineRig rig;
  rig.line.begin_reading(rig.now);
  rig.say(program_of(kLineBuffer)).say("%");
  ASSERT_EQ(rig.events.size(), 1u);
  EXPECT_EQ(rig.events[0], "text[" + program_of(kLineBuffer) + "].");
}

TEST(SerialLine, The4097thIsAnOverflow_D_100) {
  LineRig rig;
  rig.line.begin_reading(rig.now);
  rig.say(program_of(kLineBuffer)).say("\r\n ").say("X%");
  EXPECT_THAT(rig.events, ElementsAre("overflow"));
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>");
  EXPECT_EQ(rig.line.mode(), SerialLine::Mode::off);
}

TEST(SerialLine, NothingIsReadUntilTheProgramIsStored_EXT_053) {
  LineRig rig;
  rig.answers = false;
  rig.line.begin_reading(rig.now);
  rig.say("P0001N001G05\0"sv).pass(Time(1000));
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>");
  rig.say("P0002N001G05\0"sv).pass(Time(1000));  // nobody asked for it
  EXPECT_THAT(rig.events, ElementsAre("text[P0001N001G05]"));
  rig.line.accept();
  rig.say("P0003N001G05%"sv);
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>");
  EXPECT_THAT(rig.events, ElementsAre("text[P0001N001G05]", "text[P0003N001G05]."));
  EXPECT_NE(rig.line.mode(), SerialLine::Mode::off);
  rig.line.accept();
  EXPECT_EQ(rig.line.mode(), SerialLine::Mode::off);
}

TEST(SerialLine, AProgramThatIsRefusedEndsTheReading) {
  LineRig rig;
  rig.accepts = false;
  rig.line.begin_reading(rig.now);
  rig.say("P0001N001G05\0P0002N001G05\0"sv);
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>");
  EXPECT_THAT(rig.events, ElementsAre("text[P0001N001G05]"));
  EXPECT_EQ(rig.line.mode(), SerialLine::Mode::off);
}

TEST(SerialLine, WhatIsRefusedUnderRemoteIsAnsweredWithF_DEC_35) {
  LineRig rig;
  rig.accepts = false;
  rig.line.begin_remote(5, rig.now);
  rig.say("P0002N001*!"sv);
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3><DC1>P0007N012F%");
  rig.accepts = true;
  rig.say("P0002N001G05\0!"sv);
  EXPECT_EQ(rig.sent(), "<DC3><DC3><DC1>P0007N012S%");
}

TEST(SerialLine, ARunningControlAnswersAndAsksForDataAtTheEnd_EXT_060) {
  LineRig rig;
  rig.line.begin_remote(5, rig.now);
  rig.say("P0002N001*"sv);
  rig.status.letter = ControlStatus::Letter::running;
  rig.say("P0003N001G05\0!#!"sv);
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>P0007N012L%P0007N012L%");
  EXPECT_THAT(rig.events, ElementsAre("start P2 N1", "query", "query"));
  rig.line.run_ended(rig.now);
  rig.line.run_ended(rig.now);
  rig.say("N020G05\0"sv);
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3><DC1>");
  EXPECT_THAT(rig.events, ElementsAre("start P2 N1", "query", "query", "more[P0002N020G05]"));
}

TEST(SerialLine, TheRestOfAWrongTransmissionIsNotTakenForAnother) {
  LineRig rig;
  rig.line.begin_remote(5, rig.now);
  rig.say("X0001N001G05#!\0"sv).pass(Time(999'000));
  rig.say("P0001N001G05\0"sv).pass(Time(999'999));
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>");
  rig.pass(Time(1));
  EXPECT_EQ(rig.sent(), "<DC1>");
  rig.say("!"sv);
  EXPECT_EQ(rig.sent(), "P0007N012F%");
  EXPECT_THAT(rig.events, ElementsAre("wrong", "query"));
}

TEST(SerialLine, StopDropsWhatIsHalfReceived_D_107) {
  LineRig rig;
  rig.line.begin_reading(rig.now);
  rig.say("P0001N001G0");
  EXPECT_TRUE(rig.line.is_reading());
  rig.line.stop(rig.now);
  EXPECT_EQ(rig.sent(), "<DC1><DC3><DC3>");
  rig.say("5%");
  EXPECT_THAT(rig.events, IsEmpty());
  rig.line.begin_reading(rig.now);
  rig.say("P0002N001G05%");
  EXPECT_THAT(rig.events, ElementsAre("text[P0002N001G05]."));
}

TEST(SerialLine, SendsProgramsInItsTime_EXT_045) {
  LineRig rig({.baud = 300});
  const std::string text = "P0001\r\nN001G05\r\n%";
  rig.line.begin_sending(text, rig.now);
  rig.pass(Time(33'332));
  EXPECT_EQ(rig.sent(), "");
  rig.pass(Time(1));
  EXPECT_EQ(rig.sent(), "P");
  rig.pass(Time(33'333 * 16));
  EXPECT_EQ(rig.sent(), text.substr(1));
  EXPECT_THAT(rig.events, IsEmpty());
  rig.pass(Time(0));
  EXPECT_THAT(rig.events, ElementsAre("sent"));
  EXPECT_EQ(rig.line.mode(), SerialLine::Mode::off);
}

TEST(SerialLine, ReceivesInItsTime_EXT_045) {
  LineRig rig({.baud = 1200});
  rig.line.begin_reading(rig.now);
  rig.say("P0001N001G05%");  // 13 characters
  rig.pass(Time(8333 * 13 - 1));
  EXPECT_THAT(rig.events, IsEmpty());
  rig.pass(Time(1));
  EXPECT_THAT(rig.events, ElementsAre("text[P0001N001G05]."));
}

TEST(SerialLine, SixNulGiveTimeToStoreAtFullSpeed_EXT_052) {
  LineRig rig({.baud = 4800});
  rig.line.begin_reading(rig.now);
  rig.say("P0001N001G05\0\0\0\0\0\0P0002N001G05%"sv);
  rig.pass(std::chrono::seconds(1));  // followed late, nothing is lost
  EXPECT_THAT(rig.events, ElementsAre("text[P0001N001G05]", "text[P0002N001G05]."));
}

TEST(SerialLine, ABacklogIsBounded) {
  SerialLine line({.baud = 300});
  line.begin_reading(Time(0));
  EXPECT_EQ(line.receive(std::string(5000, '\0'), Time(0)), SerialLine::kBacklog);
  EXPECT_EQ(line.receive("P", Time(0)), 0u);
  EXPECT_EQ(line.advance(Time(10 * 33'333), {}), std::nullopt);
  EXPECT_EQ(line.receive(std::string(50, '\0'), Time(10 * 33'333)), 10u);
}

TEST(SerialLine, QueriesThatNobodyReadsTheAnswersOfAreNotHeapedUp) {
  LineRig rig({.baud = 300});
  rig.line.begin_remote(5, rig.now);
  for (int second = 0; second < 100; ++second) rig.say(std::string(30, '!')).pass(std::chrono::seconds(1));
  EXPECT_LE(rig.line.take_output(rig.now + std::chrono::hours(1)).size(), 1024u + 11u + 100 * 30u);
}

/// Any bytes at any speed: events and answers stay in order, everything sent has even parity.
TEST(SerialLine, AnyBytesAreSurvived) {
  setenv("RC_PARAMS", "seed=3300 max_success=500", 0);
  EXPECT_TRUE(rc::check([] {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(
        rc::gen::oneOf(rc::gen::arbitrary<std::string>(),
                       rc::gen::element<std::string>("P0001N001", "N002G05", std::string(6, '\0'), "%", "*", "#", "!",
                                                     "P0000T001R+1", "MDN03=1")));
    LineRig rig({.baud = 4800, .is_paced = *rc::gen::arbitrary<bool>()});
    rig.accepts = *rc::gen::arbitrary<bool>();
    *rc::gen::arbitrary<bool>() ? rig.line.begin_remote(1, rig.now) : rig.line.begin_reading(rig.now);
    for (const std::string& piece : pieces) {
      static_cast<void>(rig.line.receive(piece, rig.now));
      rig.pass(Time(*rc::gen::inRange(0, 2'000'000)));
    }
    RC_ASSERT(rig.sent().find("<odd>") == std::string::npos);
  }));
}

}  // namespace
}  // namespace cnclab::transfer
