// The lesson's course, and what is done at all seats at once.
#include "lesson.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <numeric>

#include "harness/failure.hpp"

namespace cnclab::lesson {

using namespace std::chrono_literals;

namespace {

constexpr auto kInstructor = "lehrer";
constexpr int kCutStation = 8;  ///< sits behind a line that can be cut
constexpr double kCounterDigit_mm = 0.0005 + 1e-9;

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

void interrupt_lesson() { interrupted = 1; }

Lesson::Lesson(std::filesystem::path out) : out_(std::move(out)) {}

bool Lesson::play() {
  prepare_folder();
  open_lab();
  enrol();
  sit_down();
  key_in_everything();
  train_together();
  for (const auto& seat : seats_) run_part(*seat);
  std::vector<ReportRow> rows;
  for (auto& inspection : inspections_) rows.push_back(inspection.get());
  crash_while_storing();
  find_every_block();
  draw_pictures();
  close_lab();
  const int good = parts_as_drawn(rows);
  const std::string table = table_of(rows);
  std::ofstream(out_ / "table.txt") << table;
  fmt::print("\n{}\n{} of {} parts as drawn, in {:.0f} s\n", table, good, rows.size(),
             std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count());
  return good == static_cast<int>(parts().size());
}

void Lesson::say(const std::string& text) {
  if (interrupted != 0) throw harness::Failure("ended by the user");
  step_ = text;
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - began_;
  fmt::print("[{:6.1f} s] {}\n", since.count(), text);
  std::fflush(stdout);
}

void Lesson::at_all_seats(const std::function<void(Seat&)>& action) {
  std::vector<std::future<void>> hands;
  for (const auto& seat : seats_) {
    hands.push_back(std::async(std::launch::async, [&action, seat = seat.get()] { action(*seat); }));
  }
  std::exception_ptr first;
  for (auto& hand : hands) {
    try {
      hand.get();
    } catch (...) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

std::filesystem::path Lesson::file(const char* folder, const Part& part, const std::string& ending) const {
  const auto all = parts();
  const auto found = std::ranges::find(all, part.student, &Part::student);
  return out_ / folder / fmt::format("{:02}-{}{}", found - all.begin() + 1, part.student, ending);
}

Seat& Lesson::seat(int station) { return *seats_.at(static_cast<std::size_t>(station - 1)); }

void Lesson::prepare_folder() {
  for (const char* program : {"cnclab-server", "cnclab-station", "cnclab-instructor", "cnclab-tool"}) {
    if (!std::filesystem::exists(harness::programs_folder() / program)) {
      throw harness::Failure(
          fmt::format("{} is not in {}: build it first (./lab lesson does), or name the folder with --bin", program,
                      harness::programs_folder().string()));
    }
  }
  for (const char* folder : {"data", "traces", "tapes", "pictures", "logs", "state"}) {
    std::filesystem::remove_all(out_ / folder);
    if (std::string_view(folder) != "data") std::filesystem::create_directories(out_ / folder);
  }
}

void Lesson::open_lab() {
  say("starting the server with an empty data folder");
  auto started = harness::ServerProcess::start(
      {.data = out_ / "data", .log = out_ / "logs" / "server.log", .port = 0, .configuration = {}, .more = {}});
  if (!started) throw harness::Failure("the server did not start:\n" + started.error().log);
  server_ = std::move(*started);
  if (!server_->one_time_password()) throw harness::Failure("the first start printed no one-time password");
  say("server on " + server_->address() + "; the instructor changes the one-time password");
  harness::Passwords one_time;
  harness::InstructorOptions options{.server = server_->address(),
                                     .fingerprint = server_->fingerprint(),
                                     .user = kInstructor,
                                     .password_file = one_time.set(kInstructor, *server_->one_time_password()),
                                     .new_password_file = passwords_.file_of(kInstructor),
                                     .state_folder = out_ / "state"};
  harness::Instructor(options).must({"passwd"});
  options.password_file = std::exchange(options.new_password_file, {});
  instructor_.emplace(options);
}

void Lesson::enrol() {
  const auto all = parts();
  for (const Part& part : all) {
    instructor_->must({"student", "add", part.student, "--password-file", passwords_.file_of(part.student).string()});
  }
  say(fmt::format("{} students are on the roster", all.size()));
}

void Lesson::sit_down() {
  line_ = std::make_unique<harness::TcpProxy>(server_->port());
  int station = 0;
  for (const Part& part : parts()) {
    ++station;
    harness::StationOptions options{.server = station == kCutStation ? line_->address() : server_->address(),
                                    .fingerprint = server_->fingerprint(),
                                    .station = station,
                                    .user = part.student,
                                    .password_file = passwords_.file_of(part.student),
                                    .new_password_file = {},
                                    .state_folder = out_ / "state",
                                    .log = out_ / "logs" / fmt::format("station{:02}.log", station),
                                    .more = {}};
    seats_.push_back(std::make_unique<Seat>(part, options));
  }
  at_all_seats([](Seat& seat) { seat.log_in(); });
  const auto present = instructor_->status().at("stations").size();
  if (present != seats_.size()) throw harness::Failure(fmt::format("`status` shows {} stations", present));
  say(fmt::format("{} stations are logged in over TLS", present));
}

void Lesson::key_in_everything() {
  std::atomic<int> acknowledged = 0;
  at_all_seats([&](Seat& seat) { acknowledged += seat.key_in_programs(); });
  acknowledged_ = acknowledged;
  say(fmt::format("all students have keyed in their programs word by word: {} blocks acknowledged", acknowledged_));
}

void Lesson::train_together() {
  say("all fifteen run their programs on their training machines at once");
  at_all_seats([](Seat& seat) {
    seat.choose_program();
    seat.start();
    seat.finish();
    const Part& part = seat.part();
    if (distance(seat.shown_position(), part.shown_at_end) > kCounterDigit_mm) {
      throw harness::Failure(seat.name() + ": the training run did not end where the drawing ends\n" +
                             seat.process().text());
    }
  });
  const auto status = instructor_->status();
  if (status.at("selected") != 0 || status.at("machine").at("state") != "standstill") {
    throw harness::Failure("training runs moved the lab's machine: " + status.dump());
  }
}

void Lesson::draw_pictures() {
  for (const auto& seat : seats_) {
    const Part& part = seat->part();
    const auto tape = file("tapes", part, ".txt");
    std::ofstream text(tape);
    for (const WrittenProgram& program : part.programs) {
      text << instructor_->must({"program", "show", part.student, fmt::format("P{:04}", program.number)}).output;
    }
    text.close();
    draw_picture(tape, file("pictures", part, ".svg"), part.view);
  }
  say("tapes and pictures of all parts are in " + out_.string());
}

void Lesson::close_lab() {
  for (const auto& seat : seats_) static_cast<void>(seat->process().send("quit", 3s));
  seats_.clear();
  server_->terminate();
  const auto code = server_->wait(5s);
  if (code != 0) throw harness::Failure("the server did not end with 0 within 5 s of SIGTERM:\n" + server_->log());
  say("the lab is closed");
}

}  // namespace cnclab::lesson
