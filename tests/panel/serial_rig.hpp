// A control with a computer at its serial line, in virtual time.
#pragma once

#include <gtest/gtest.h>

#include "bench.hpp"
#include "language/tape.hpp"
#include "transfer/iso_code.hpp"

namespace cnclab::panel {

using namespace std::string_view_literals;

inline constexpr std::string_view kLineMemory = "P0001N001G04H0010N002G04H0010P0007N005G04H0001%";

class SerialPortTest : public testing::Test {
 public:
  explicit SerialPortTest(bool is_remote = false, bool is_lab_machine = false,
                          std::string tape = std::string(kLineMemory))
      : bench({.settings = {.remote = is_remote}, .tape = std::move(tape), .is_lab_machine = is_lab_machine}) {
    bench.control.fit_line({.is_fitted = true, .is_paced = false, .binding = "STATION 7 ABCD-EFGH-2345"});
    bench.control.connect_line(true, bench.now);
    bench.run_for(20);
  }

  /// What the computer says; the control has 50 ms for it.
  void say(std::string_view bytes) {
    ASSERT_EQ(bench.control.line_received(bytes, bench.now), bytes.size());
    bench.run_for(50);
  }
  /// What the control has said since, DC1 and DC3 as "1" and "3" in angle brackets.
  std::string heard() {
    std::string text;
    for (const char byte : bench.control.take_line_output(bench.now, std::string::npos)) {
      const char c = transfer::without_parity(byte);
      EXPECT_EQ(byte, transfer::with_even_parity(c)) << "EXT-044";
      text += c == transfer::kReaderOn ? "<1>" : (c == transfer::kReaderOff ? "<3>" : std::string(1, c));
    }
    return text;
  }
  [[nodiscard]] std::string memory() const {
    std::string text;
    for (const language::Program& program : bench.control.memory().programs()) text += language::write_program(program);
    return text;
  }

  Bench bench;
};

}  // namespace cnclab::panel
