// A small lab with a console and a program that dwells long, and its time passed as by a busy server.
#pragma once

#include <vector>

#include "language/tape.hpp"
#include "small_lab.hpp"

namespace cnclab::lab {

/// The instructor lehrer at a console; eva, who sits down at seat 7 and has the machine when a test says so.
class KeyboardRig : public SmallLab {
 public:
  static constexpr std::uint32_t kSeat = 7;

  KeyboardRig() {
    with_database([](db::Database& database) {
      const std::string block = "N001G04H9999";
      const db::StoredBlock dwell{1, block, language::check_code(1, block)};
      database.put_block(database.person("eva")->id, 1, dwell, {.name = "eva", .station = kSeat, .time_ms = 1});
    });
    log_in(console, "lehrer", 0);
    log_in(eva, "eva", kSeat);
    alive = {&eva, &console};
  }

  /// All who are alive see what comes and answer.
  void pass_ms(std::int64_t milliseconds) {
    constexpr std::int64_t kPoll_ms = 11;
    for (std::int64_t passed = 0; passed < milliseconds; passed += kPoll_ms) {
      advance_ms(kPoll_ms);
      poll();
      for (Caller* caller : alive) look(*caller);
    }
  }
  [[nodiscard]] v1::InstructorAnswer order(const std::function<void(v1::InstructorRequest&)>& fill) {
    v1::InstructorRequest request;
    fill(request);
    return ask(console, request);
  }
  [[nodiscard]] v1::Status status() {
    return order([](auto& request) { request.mutable_status(); }).items(0).status();
  }
  /// Each line "kind|detail|student".
  [[nodiscard]] std::vector<std::string> journal_of(const std::string& student) {
    std::vector<std::string> lines;
    const auto answer = order([&](auto& request) { request.mutable_journal()->set_student(student); });
    for (const auto& item : answer.items())
      lines.push_back(item.journal().kind() + "|" + item.journal().detail() + "|" + item.journal().student());
    return lines;
  }
  /// Offers the machine to eva; `typist` accepts it and starts the program, on the keyboard that is typed at.
  void run_on_machine(Caller& typist) {
    ASSERT_EQ(order([](auto& request) { request.mutable_select()->set_station(kSeat); }).error(), "");
    pass_ms(100);
    strike(typist, Key::START);
    pass_ms(100);
    for (const Key key : {Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) {
      strike(typist, key);
      pass_ms(50);
    }
    ASSERT_TRUE(status().stations(0).running()) << eva.screen.text(18);
  }

  Caller console = call(v1::CLIENT_KIND_INSTRUCTOR);
  Caller eva = call();
  std::vector<Caller*> alive;
};

}  // namespace cnclab::lab
