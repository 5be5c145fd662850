// What a terminal sends and what it does at a station and at the console: unknown keys, pasted text, bursts, bytes that
// are no characters (AUTH-006); and how the terminal is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;
using testing::Not;

class KeyboardBytes : public testing::Test {
 protected:
  KeyboardBytes() { room_.add_student("anna"); }

  Terminal station(const std::string& term, const std::string& locale = "C.UTF-8") {
    return Terminal({.program = programs_folder() / "cnclab-station",
                     .arguments = station_arguments(room_.station_options(1, "anna")),
                     .environment = {{"TERM", term}, {"LC_ALL", locale}, {"XDG_STATE_HOME", state()}}});
  }
  Terminal console(const std::string& locale = "C.UTF-8") {
    return Terminal(
        {.program = programs_folder() / "cnclab-instructor",
         .arguments = {"--server", room_.server().address(), "--user", "lehrer", "--password-file",
                       room_.passwords().file_of("lehrer").string(), "--fingerprint", room_.server().fingerprint()},
         .environment = {{"LC_ALL", locale}}});
  }
  [[nodiscard]] std::string state() const { return (room_.folder().path() / "state").string(); }
  bool is_halted() {
    return eventually(kLimit, [&] { return !room_.instructor().status()["halted_by"].get<std::string>().empty(); });
  }
  void clear() {
    room_.instructor().must({"clear-halt"});
    ASSERT_EQ(room_.instructor().status()["halted_by"], "");
  }
  /// The keys have acted when one that was typed behind them has.
  static void settle(Terminal& terminal) {
    terminal.type("\t");
    terminal.wait_for("EINGABEMODUS");
    terminal.type("m");
    terminal.wait_for("EXTERNE DATEN");
  }
  [[nodiscard]] std::string last_key() { return room_.instructor().status()["stations"][0]["last_key"]; }

  Classroom room_;
};

TEST_F(KeyboardBytes, a_sequence_that_is_no_known_key_does_nothing_as_a_whole) {
  for (const char* const term : {"xterm-256color", "linux"}) {
    Terminal terminal = station(term);
    terminal.wait_for("EXTERNE DATEN");
    for (const char* const sequence : {"\x1bs", "\x1b[99~", "\x1b[57399u", "\x1b[1;5D", "\x1b[15;2~", "\x1b[1;3H"}) {
      terminal.type("h");
      terminal.wait_for("HANDBETRIEB");
      terminal.type("x");
      terminal.type(sequence);
      terminal.type("m");
      terminal.wait_for("EXTERNE DATEN");
      EXPECT_EQ(last_key(), "MENU") << term << " " << sequence + 1;
    }
    terminal.type("qj");
    ASSERT_EQ(terminal.wait(kLimit), 0);
  }
  const std::string journal = room_.instructor().run({"journal", "anna"}).output;
  for (const char* const key : {"START", "RESET", "SATZ_SUCHEN", "\"D9\""}) EXPECT_THAT(journal, Not(HasSubstr(key)));
}

TEST_F(KeyboardBytes, pasted_text_presses_no_key_of_the_control_and_is_text_in_a_form) {
  Terminal terminal = station("xterm-256color");
  terminal.wait_for("EXTERNE DATEN");
  terminal.type("\x1b[200~hxs123R\r\x1b[201~");
  settle(terminal);
  EXPECT_THAT(room_.instructor().run({"journal", "anna"}).output, Not(HasSubstr("\"HAND\"")));
  terminal.type("\x1b[200~hx!\x1b[201~");
  EXPECT_TRUE(is_halted()) << "a stop acts wherever it comes from";
}

TEST_F(KeyboardBytes, AUTH_006_MASCHINE_HALT_behind_a_burst_or_beside_bytes_that_are_no_characters_is_not_lost) {
  Terminal terminal = station("xterm-256color");
  terminal.wait_for("EXTERNE DATEN");
  for (const std::string& burst : {std::string(300, '1'), std::string(2000, '1'), std::string("\xF6"),
                                   std::string("\x1b"), std::string("\x1b[1;"), std::string("\x1b[200~abc")}) {
    terminal.type(burst + "!");
    EXPECT_TRUE(is_halted()) << burst.substr(0, 10);
    clear();
    terminal.type("\x1b[201~");
  }
}

TEST_F(KeyboardBytes, AUTH_006_in_a_locale_without_umlauts_too) {
  Terminal terminal = station("xterm-256color", "C");
  terminal.wait_for("EXTERNE DATEN");
  terminal.type("\xC3\xB6!");
  EXPECT_TRUE(is_halted());
  clear();
  Terminal beside = console("C");
  beside.wait_for("q Ende");
  beside.type("\xF6h");
  EXPECT_TRUE(is_halted());
  EXPECT_THAT(beside.text(), HasSubstr("s waehlen")) << "the console draws without Unicode there";
}

TEST_F(KeyboardBytes, at_the_console_Alt_and_a_letter_commands_nothing) {
  StationProcess anna = room_.seat(1, "anna");
  Terminal terminal = console();
  terminal.wait_for("anna");
  terminal.type("\x1bp\x1b[1;5S\x1bs\x1b[200~psS\x1b[201~:");
  terminal.wait_for(":_");
  terminal.type("\x1b[200~status\x1b[201~\r");
  terminal.wait_for("\"selected\":0,\"offered\":0");
  EXPECT_EQ(room_.instructor().status()["machine"]["state"], "standstill");
  terminal.type("\x1b\x1bh");
  EXPECT_TRUE(is_halted());
}

TEST_F(KeyboardBytes, the_terminal_is_left_as_it_was_and_the_next_program_can_wait_for_its_input) {
  std::string command = (programs_folder() / "cnclab-station").string();
  for (const std::string& argument : station_arguments(room_.station_options(1, "anna")))
    command += " '" + argument + "'";
  Terminal terminal({.program = "/bin/sh",
                     .arguments = {"-c", command + "; echo left $?; read -r line; echo \"got $line\"; stty -a"},
                     .environment = {{"XDG_STATE_HOME", state()}}});
  terminal.wait_for("EXTERNE DATEN");
  terminal.type("qj");
  terminal.wait_for("left 0");
  terminal.type("words\r");
  terminal.wait_for("got words");
  terminal.wait_for(" icanon ");
  EXPECT_EQ(terminal.wait(kLimit), 0);
}

TEST_F(KeyboardBytes, a_signal_ends_the_console_as_q_does) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    Terminal terminal = console();
    terminal.wait_for("q Ende");
    terminal.send_signal(signal);
    EXPECT_EQ(terminal.wait(kLimit), 0) << signal;
    terminal.wait_gone("q Ende", kLimit);  // the alternate screen is left
  }
}

}  // namespace
}  // namespace cnclab::harness
