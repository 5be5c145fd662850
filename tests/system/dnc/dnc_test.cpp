// Computers at the serial line of a running lab: over TCP, over TLS, over a serial device (interfaces.md section 8,
// section EXT, AUTH-013, DEC-35). The sender is a Python program written after the manual.
#include <gmock/gmock.h>

#include <csignal>

#include "dnc/dnc_rig.hpp"

namespace cnclab::harness {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kProgram = "P0001\nN001G11F3000\nN002G01X+5000\nN003G01X-5000\n";
const std::string kTcp = "[dnc]\nlisten = \"127.0.0.1:0\"\npacing = false\n";

/// A lab with a serial line, and anna at station 1.
class Dnc : public testing::Test {
 protected:
  void open(const std::string& configuration) {
    room_ = std::make_unique<Classroom>(configuration);
    room_->add_student("anna", {kProgram});
    anna_ = std::make_unique<StationProcess>(room_->seat(1, "anna"));
  }

  /// The sender over socat to the server's TCP port, bound to anna's station.
  SenderResult send_over_tcp(std::vector<std::string> commands, const std::string& address = "TCP:127.0.0.1:") {
    const auto link = room_->folder().path() / "line";
    const ChildProcess socat = start_socat("PTY,raw,echo=0,wait-slave,link=" + link.string(),
                                           address + std::to_string(dnc_port(*room_)) + verify_, link);
    commands.insert(commands.begin(), {link.string(), "--bind", binding_on(*anna_)});
    SenderResult result = run_sender(commands, room_->folder());
    // The line is free for the next one when the server has seen its end.
    EXPECT_TRUE(eventually(kLimit, [&] { return line_of(1).empty(); }));
    return result;
  }
  std::string file(const std::string& content) const { return room_->folder().write("programs", content).string(); }
  std::string line_of(int station) { return room_->instructor().station(station)["line"]; }
  std::string journal() { return room_->instructor().must({"journal", "anna"}).output; }
  nlohmann::json machine() { return room_->instructor().status()["machine"]; }

  std::unique_ptr<Classroom> room_;
  std::unique_ptr<StationProcess> anna_;
  std::string verify_;
};

TEST_F(Dnc, EXT_060_to_065_SYS_021_a_computer_transfers_starts_and_queries_over_TCP) {
  open(kTcp + "training_start = true\n");
  EXPECT_TRUE(anna_->marks().empty());
  room_->instructor().must({"remote", "1", "on"});
  EXPECT_TRUE(eventually(kLimit, [&] { return anna_->marks() == std::vector<std::string>{"9 1 1"}; })) << "SCR-022";
  EXPECT_EQ(room_->instructor().station(1)["remote"], true);
  const std::string programs = file("P0002N001G04H0010\nP0003N005G11F3000N006G01X+5000N007G01X-5000\n");
  const SenderResult result = send_over_tcp(
      {"query", "send", programs, "query", "start", "P0003N006", "until", "L", "until", "S", "wait", "query"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.lines, ElementsAre("P0001N001S", "sent 2", "P0003N005S", "started", HasSubstr("L"), "P0003N006S",
                                        "asked", "P0003N006S"));
  EXPECT_THAT(room_->instructor().must({"program", "show", "anna", "P0003"}).output, HasSubstr("N006G01X+5000"));
  EXPECT_THAT(room_->instructor().must({"program", "versions", "anna", "P0003"}).output, HasSubstr("\"DNC\""))
      << "STO-005";
  EXPECT_TRUE(eventually(kLimit, [&] { return journal().find("\"remote_start\"") != std::string::npos; })) << journal();
  EXPECT_THAT(journal(), HasSubstr("received P0003"));
  EXPECT_THAT(room_->instructor().station(1)["mode"], "EXTERNE DATEN") << "EXT-065";
}

TEST_F(Dnc, EXT_061_062_parts_are_continued_and_the_memory_is_erased) {
  open(kTcp + "[control]\nremote = true\n");
  const std::string parts = file("P0004N001G04H0001\nN002G04H0002\n");
  EXPECT_THAT(send_over_tcp({"part", parts, "query"}).lines, ElementsAre("sent 2", "P0004N001S"));
  EXPECT_THAT(room_->instructor().must({"program", "show", "anna", "P0004"}).output, HasSubstr("N002G04H0002"));
  EXPECT_THAT(send_over_tcp({"refused", "X0001", "wait", "query"}).lines,
              ElementsAre("refused", "asked", "P0004N001F"));
  EXPECT_THAT(send_over_tcp({"erase", "query"}).lines, ElementsAre("erased", "P0001N001S"));
  EXPECT_EQ(room_->instructor().must({"programs", "anna"}).output, "");
}

TEST_F(Dnc, DEC_35_without_permission_a_training_machine_is_not_started) {
  open(kTcp + "[control]\nremote = true\n");
  EXPECT_THAT(send_over_tcp({"start", "P0001N001", "query"}).lines, ElementsAre("started", "P0001N001F"));
  EXPECT_EQ(room_->instructor().station(1)["running"], false);
  EXPECT_THAT(anna_->text(), HasSubstr("Fernstart abgelehnt"));
}

TEST_F(Dnc, AUTH_013_on_the_machine_only_what_the_student_has_released_starts_once) {
  open(kTcp + "training_start = true\n[control]\nremote = true\n");
  room_->give_machine(1, *anna_);
  EXPECT_THAT(send_over_tcp({"start", "P0001N001", "query"}).lines, Contains("P0001N001F")) << "nothing is released";
  EXPECT_EQ(machine()["x"], 0);
  const auto link = room_->folder().path() / "line";
  const std::string binding = binding_on(*anna_);
  ASSERT_TRUE(eventually(kLimit, [&] {  // a START that crosses a change of the screen is refused (AUTH-008)
    anna_->key("START");
    return anna_->shows("einmal starten");
  })) << anna_->text();
  {
    const ChildProcess socat = start_socat("PTY,raw,echo=0,wait-slave,link=" + link.string(),
                                           "TCP:127.0.0.1:" + std::to_string(dnc_port(*room_)), link);
    const SenderResult result = run_sender({link.string(), "--bind", binding, "start", "P0001N002", "query", "start",
                                            "P0001N001", "until", "L", "until", "S", "start", "P0001N001", "query"},
                                           room_->folder());
    EXPECT_THAT(result.lines,
                ElementsAre("started", "P0001N001F", "started", HasSubstr("L"), "P0001N001S", "started", "P0001N001F"))
        << result.errors << anna_->text();
  }
  EXPECT_TRUE(eventually(kLimit, [&] { return journal().find("\"remote_start\"") != std::string::npos; })) << journal();
  EXPECT_THAT(journal(), HasSubstr("another program or block is released"));
  EXPECT_THAT(room_->instructor().must({"runs", "anna"}).output, HasSubstr("lab"));
}

TEST_F(Dnc, SEC_001_beyond_loopback_the_line_is_TLS) {
  open("[dnc]\nlisten = \"0.0.0.0:0\"\npacing = false\n[control]\nremote = true\n");
  verify_ = ",verify=0";
  EXPECT_THAT(send_over_tcp({"query"}, "OPENSSL:127.0.0.1:").lines, ElementsAre("P0001N001S"));
  const LineEnd plain(connect_to(dnc_port(*room_)));
  plain.say(binding_on(*anna_) + "\n");
  EXPECT_TRUE(plain.is_closed_within(kLimit));
}

TEST_F(Dnc, SEC_006_whoever_does_not_name_the_token_is_closed_and_journalled) {
  open(kTcp + "[control]\nremote = true\n");
  const std::string binding = binding_on(*anna_);
  for (const std::string& line : {std::string("STATION 1 AAAA-AAAA-AAAA\n"), std::string("STATION 2 AAAA-AAAA-AAAA\n"),
                                  std::string("GET / HTTP/1.1\r\n"), std::string(200, 'x')}) {
    const LineEnd guest(connect_to(dnc_port(*room_)));
    guest.say(line);
    EXPECT_TRUE(guest.is_closed_within(kLimit)) << line;
  }
  const LineEnd computer(connect_to(dnc_port(*room_)));
  computer.say(binding + "\n!");
  EXPECT_EQ(computer.hear(12), "\x11P\x30\x30\x30\xB1N\x30\x30\xB1S\xA5") << "DC1, then the answer with even parity";
  const LineEnd second(connect_to(dnc_port(*room_)));
  second.say(binding + "\n");
  EXPECT_TRUE(second.is_closed_within(kLimit)) << "one line to a station";
  anna_->quit();
  EXPECT_TRUE(computer.is_closed_within(kLimit)) << "the token was of that login";
  const auto all = read_file(room_->folder().path() / "server.log");
  EXPECT_THAT(all, HasSubstr("wrong token"));
  EXPECT_THAT(all, HasSubstr("line too long"));
  EXPECT_THAT(all, HasSubstr("has a line already"));
}

TEST_F(Dnc, SEC_004_nobody_else_reads_the_token_off_a_screen_that_is_shown) {
  open(kTcp);
  room_->add_student("otto");
  StationProcess otto = room_->seat(2, "otto");
  const std::string binding = binding_on(*anna_);
  room_->instructor().must({"show", "1"});
  otto.wait_for("STATION 1 **************");
  EXPECT_FALSE(otto.shows(binding));
  EXPECT_TRUE(anna_->shows(binding));
}

TEST_F(Dnc, SEC_003_after_five_wrong_tokens_a_guesser_waits_and_the_right_one_comes_in_later) {
  open(kTcp);
  const std::string binding = binding_on(*anna_);
  constexpr int kTries = 8;
  std::vector<std::unique_ptr<LineEnd>> guessers;
  for (int i = 0; i < kTries; ++i) guessers.push_back(std::make_unique<LineEnd>(connect_to(dnc_port(*room_))));
  for (const auto& guesser : guessers) guesser->say("STATION 1 AAAA-AAAA-AAAA\n");
  for (const auto& guesser : guessers) EXPECT_TRUE(guesser->is_closed_within(kLimit));
  EXPECT_THAT(read_file(room_->folder().path() / "server.log"), HasSubstr("too many wrong tokens"));
  EXPECT_TRUE(eventually(10s, [&] {
    const LineEnd computer(connect_to(dnc_port(*room_)));
    computer.say(binding + "\n");
    return !computer.is_closed_within(2s);
  }));
}

TEST_F(Dnc, SYS_020_a_serial_device_is_opened_again_when_it_has_disappeared) {
  const TemporaryFolder place;
  const auto device = place.path() / "tty", computer = place.path() / "computer";
  open("[dnc]\ndevice = \"" + device.string() + "\"\nstation = 1\ntraining_start = true\n[control]\nremote = true\n");
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(eventually(kLimit, [&] { return line_of(1).empty(); }));
    const ChildProcess socat =
        start_socat("PTY,raw,echo=0,link=" + device.string(), "PTY,raw,echo=0,link=" + computer.string(), computer);
    ASSERT_TRUE(eventually(kLimit, [&] { return line_of(1) == device.string(); })) << round;
    const SenderResult result = run_sender({computer.string(), "wait", "send", file("P0002N001G11F3000N002G01X+2000\n"),
                                            "start", "P0002N001", "until", "L", "until", "S"},
                                           room_->folder());
    EXPECT_THAT(result.lines, ElementsAre("asked", "sent 1", "started", HasSubstr("L"), "P0002N001S")) << result.errors;
  }
}

}  // namespace
}  // namespace cnclab::harness
