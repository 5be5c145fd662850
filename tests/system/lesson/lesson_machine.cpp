// One after the other on the lab's machine: selected, accepted, run, and disturbed in every way that a class can.
#include <fmt/format.h>

#include "harness/failure.hpp"
#include "lesson.hpp"

namespace cnclab::lesson {

using namespace std::chrono_literals;

namespace {

constexpr auto kAnswerLimit = 5s;
constexpr auto kLossLimit = 4s;        ///< AUTH-007 gives 1 s, the ramp 0.4 s
constexpr auto kReconnectLimit = 20s;  ///< SEAT-005: pauses grow up to 5 s

constexpr double kOnItsWay_mm = 8;  ///< fast by then, and far from the end

// Which station shows what; all others run plainly.
constexpr int kWatchedByRival = 2;
constexpr int kRival = 9;
constexpr int kRefusesSelect = 3;
constexpr int kStopped = 5;
constexpr int kCut = 8;
constexpr int kTurnsPotentiometer = 12;

Point position_in(const nlohmann::json& status) {
  const auto& machine = status.at("machine");
  return {machine.at("x").get<double>(), machine.at("y").get<double>(), machine.at("z").get<double>()};
}

}  // namespace

Point Lesson::machine_at_rest() const {
  nlohmann::json status;
  const auto rests = [&] {
    status = instructor_->status();
    return status.at("machine").at("state") == "standstill";
  };
  if (!harness::eventually(kAnswerLimit, rests)) throw harness::Failure("the machine does not rest: " + status.dump());
  return position_in(status);
}

void Lesson::expect_machine_at(const Point& place, const std::string& why) const {
  const auto status = instructor_->status();
  if (status.at("machine").at("state") != "standstill" || distance(position_in(status), place) > 1e-9) {
    throw harness::Failure("the machine moved although " + why + ": " + status.dump());
  }
}

void Lesson::wait_until_away_from(const Point& place) const {
  const auto is_on_its_way = [&] { return distance(position_in(instructor_->status()), place) > kOnItsWay_mm; };
  if (!harness::eventually(kAnswerLimit, is_on_its_way)) throw harness::Failure("the machine does not move");
}

void Lesson::give_machine_to(Seat& seat) {
  seat.process().key("MENU");
  const Point before = machine_at_rest();
  instructor_->must({"select", std::to_string(seat.station())});
  seat.process().wait_for("START nimmt an");
  if (instructor_->status().at("offered") != seat.station()) {
    throw harness::Failure(seat.name() + " was selected but `status` names no offer");
  }
  seat.process().key("START");
  nlohmann::json status;
  const auto is_given = [&] {
    status = instructor_->status();
    return status.at("selected") == seat.station();
  };
  if (!harness::eventually(kAnswerLimit, is_given)) {
    throw harness::Failure(seat.name() + " accepted with START but has no control: " + status.dump() + "\n" +
                           seat.process().text());
  }
  seat.process().wait_gone("TRAINING");
  if (seat.is_started()) throw harness::Failure(seat.name() + ": the START that accepts started something");
  expect_machine_at(before, "START only accepted the offer (AUTH-005)");
}

void Lesson::run_part(Seat& seat) {
  switch (seat.station()) {
    case kWatchedByRival:
      run_with_rival(seat);
      break;
    case kRefusesSelect:
      run_with_refused_select(seat);
      break;
    case kStopped:
      run_with_stop(seat);
      break;
    case kCut:
      run_with_cut_line(seat);
      break;
    case kTurnsPotentiometer:
      run_with_turned_potentiometer(seat);
      break;
    default:
      run_plainly(seat);
      break;
  }
  inspect_later(seat);
}

void Lesson::run_plainly(Seat& seat) {
  give_machine_to(seat);
  seat.choose_program();
  seat.start();
  seat.finish();
  say(seat.name() + ": " + seat.part().title + " has run on the lab's machine");
}

void Lesson::run_with_rival(Seat& seat) {
  give_machine_to(seat);
  seat.choose_program();
  const Point before = machine_at_rest();
  Seat& rival = this->seat(kRival);
  rival.choose_program();
  rival.start();
  expect_machine_at(before, "only " + rival.name() + " pressed START (AUTH-001)");
  if (!rival.is_started()) throw harness::Failure(rival.name() + ": the training run ended too early to show anything");
  seat.start();
  seat.finish();
  rival.finish();
  say(fmt::format("{}: {} has run; START at {} did not move the machine", seat.name(), seat.part().title,
                  rival.name()));
}

void Lesson::run_with_refused_select(Seat& seat) {
  give_machine_to(seat);
  seat.choose_program();
  seat.start();
  const auto refused = instructor_->run({"select", std::to_string(seat.station() + 1)});
  const bool was_running = seat.is_started();
  seat.finish();
  if (refused.exit_code != 1 || !was_running) {
    throw harness::Failure("`select` was not refused while a program ran (AUTH-004): " + refused.output);
  }
  say(seat.name() + ": " + seat.part().title + " has run; moving the selector meanwhile was refused");
}

void Lesson::run_with_stop(Seat& seat) {
  give_machine_to(seat);
  seat.choose_program();
  const Point before = machine_at_rest();
  seat.start();
  wait_until_away_from(before);
  seat.stop();
  const Point stopped = machine_at_rest();
  if (distance(stopped, before) < 1) throw harness::Failure(seat.name() + ": STOP came too late to show anything");
  expect_machine_at(stopped, "STOP was pressed");
  seat.start();
  seat.finish();
  say(seat.name() + ": " + seat.part().title + " has run; stopped with STOP on its way, went on with START");
}

void Lesson::run_with_turned_potentiometer(Seat& seat) {
  give_machine_to(seat);
  seat.choose_program();
  seat.start();
  for (const char* turn : {"pot 60", "pot 85", "pot 100"}) seat.process().expect_ok(turn);
  seat.finish();
  say(seat.name() + ": " + seat.part().title + " has run; the potentiometer was turned meanwhile");
}

void Lesson::run_with_cut_line(Seat& seat) {
  give_machine_to(seat);
  seat.choose_program();
  const Point before = machine_at_rest();
  seat.start();
  wait_until_away_from(before);
  lose_line(seat, before);
  come_back(seat);
  run_plainly(seat);
}

void Lesson::lose_line(Seat& seat, const Point& start) {
  line_->cut();
  nlohmann::json status;
  const auto nobody_has_control = [&] {
    status = instructor_->status();
    return status.at("selected") == 0 && status.at("machine").at("state") == "standstill";
  };
  if (!harness::eventually(kLossLimit, nobody_has_control)) {
    throw harness::Failure(seat.name() + " lost its line, the machine goes on (AUTH-007): " + status.dump());
  }
  const LabRun run = newest_lab_run(*instructor_, seat.part().student);
  const auto trace = fetch_trace(*instructor_, run, file("traces", seat.part(), "-cut.csv"));
  const Comparison part = inspect_part(seat.part(), trace, start);
  if (!part.is_as_drawn()) throw harness::Failure(seat.name() + ", line cut: " + part.fault);
  if (part.reached_mm > part.drawn_mm - 1) throw harness::Failure(seat.name() + ": the line was cut too late");
  if (const auto fault = fault_of_ramp(trace); !fault.empty()) {
    throw harness::Failure(seat.name() + ", line cut: no stop on the ramp: " + fault);
  }
  say(fmt::format("{}: line cut after {:.1f} of {:.1f} mm; the machine stopped on the ramp, nobody has control",
                  seat.name(), part.reached_mm, part.drawn_mm));
}

void Lesson::come_back(Seat& seat) {
  const Point stopped = machine_at_rest();
  line_->mend();
  const auto is_back = [&] {
    const auto entry = instructor_->station(seat.station());
    return entry.is_object() && entry.at("connected") == true &&
           seat.process().send("gone 200 VERBINDUNG VERLOREN") == "ok";
  };
  if (!harness::eventually(kReconnectLimit, is_back)) throw harness::Failure(seat.name() + " does not come back");
  seat.process().key("START");
  expect_machine_at(stopped, "the line had been cut (AUTH-007)");
  seat.choose_program();
  seat.start();
  expect_machine_at(stopped, "the reconnected station has no control");
  seat.finish();
  expect_machine_at(stopped, "the reconnected station has no control");
  if (instructor_->status().at("selected") != 0)
    throw harness::Failure(seat.name() + " has control without being asked");
  say(seat.name() + ": reconnected; START runs the training machine and moves nothing else");
}

void Lesson::inspect_later(const Seat& seat) {
  const auto look = [this, part = seat.part(), station = seat.station()] {
    const LabRun run = newest_lab_run(*instructor_, part.student);
    const auto trace = fetch_trace(*instructor_, run, file("traces", part, ".csv"));
    return ReportRow{station, part.student, part.title, run.seconds, inspect(part, trace)};
  };
  inspections_.push_back(std::async(std::launch::async, look));
}

}  // namespace cnclab::lesson
