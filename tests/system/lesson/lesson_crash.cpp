// The server dies while everybody stores; every acknowledged block must be there afterwards, for its student alone.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <set>

#include "harness/failure.hpp"
#include "lesson.hpp"

namespace cnclab::lesson {

using namespace std::chrono_literals;

namespace {

constexpr int kStormProgram = 500;
constexpr int kEnoughBlocks = 4;  ///< at each seat before the server is killed
constexpr auto kStormLimit = 30s;
constexpr auto kKeyLimit = 3s;

WrittenBlock storm_block(int number) { return parse_block(fmt::format("G04 H{:04}", number)); }

/// Stores blocks until the server no longer answers.
void store_until_the_end(Seat& seat, std::atomic<int>& acknowledged) {
  for (int number = 1; number < 999; ++number) {
    for (const std::string& command : key_commands(storm_block(number), 17)) {
      if (seat.process().send(command, kKeyLimit) != "ok") return;
    }
    acknowledged = number;
  }
}

std::string storm_tape(int blocks) {
  std::string tape = fmt::format("P{:04}", kStormProgram);
  for (int number = 1; number <= blocks; ++number) tape += tape_text(storm_block(number), number, 17);
  return tape;
}

}  // namespace

void Lesson::crash_while_storing() {
  at_all_seats([](Seat& seat) { seat.open_program(kStormProgram); });
  std::vector<std::atomic<int>> acknowledged(seats_.size());
  const auto killer = std::async(std::launch::async, [&] {
    const auto everybody_stored = [&] {
      return std::ranges::all_of(acknowledged, [](const auto& count) { return count >= kEnoughBlocks; });
    };
    const bool in_time = harness::eventually(kStormLimit, everybody_stored);
    server_->kill_hard();
    return in_time;
  });
  at_all_seats(
      [&](Seat& seat) { store_until_the_end(seat, acknowledged[static_cast<std::size_t>(seat.station() - 1)]); });
  killer.wait();
  stored_in_storm_.assign(acknowledged.begin(), acknowledged.end());
  const int stored = std::accumulate(stored_in_storm_.begin(), stored_in_storm_.end(), 0);
  if (std::ranges::any_of(stored_in_storm_, [](int count) { return count < kEnoughBlocks; })) {
    throw harness::Failure("not every student could store before the crash");
  }
  acknowledged_ += stored;
  say(fmt::format("kill -9 of the server while all students stored; {} blocks were acknowledged", acknowledged_));
  auto started = harness::ServerProcess::start({.data = out_ / "data",
                                                .log = out_ / "logs" / "server.log",
                                                .port = server_->port(),
                                                .configuration = {},
                                                .more = {}});
  if (!started) throw harness::Failure("the server did not start again:\n" + started.error().log);
  server_ = std::move(*started);
  const auto status = instructor_->status();
  if (status.at("selected") != 0 || status.at("machine").at("state") == "moving") {
    throw harness::Failure("after the restart somebody has control (AUTH-012): " + status.dump());
  }
}

void Lesson::find_blocks_of(const Seat& seat) const {
  const Part& part = seat.part();
  std::set<std::string> expected{fmt::format("P{:04}", kStormProgram)};
  for (const WrittenProgram& program : part.programs) {
    expected.insert(fmt::format("P{:04}", program.number));
    const std::string stored = stored_tape(*instructor_, part.student, program.number);
    if (stored != tape_text(program)) {
      throw harness::Failure(seat.name() + ": keyed in was " + tape_text(program) + ", after the crash there is " +
                             stored);
    }
  }
  std::set<std::string> found;
  for (const auto& program : instructor_->must({"programs", part.student}).objects) found.insert(program.at("program"));
  if (found != expected) {
    throw harness::Failure(fmt::format("{}: {} programs after the crash instead of {} of their own", seat.name(),
                                       found.size(), expected.size()));
  }
  // One more block than acknowledged may be there: committed, but the answer died with the server.
  const int acknowledged = stored_in_storm_[static_cast<std::size_t>(seat.station() - 1)];
  const std::string stored = stored_tape(*instructor_, part.student, kStormProgram);
  if (stored != storm_tape(acknowledged) && stored != storm_tape(acknowledged + 1)) {
    throw harness::Failure(
        fmt::format("{}: {} blocks were acknowledged, after the crash there is {}", seat.name(), acknowledged, stored));
  }
}

void Lesson::find_every_block() {
  for (const auto& seat : seats_) find_blocks_of(*seat);
  say(fmt::format("after the restart all {} acknowledged blocks are there, each student's own", acknowledged_));
}

}  // namespace cnclab::lesson
