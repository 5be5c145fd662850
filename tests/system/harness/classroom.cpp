// A whole lab for a test: a server with an empty data folder, an instructor with a password of their own, students and
// stations as they are asked for.
#include "harness/classroom.hpp"

#include "harness/failure.hpp"

namespace cnclab::harness {
namespace {

constexpr auto kInstructorName = "lehrer";

}  // namespace

Classroom::Classroom(const std::string& configuration) : configuration_(configuration) {
  start(0);
  if (!server_->one_time_password()) throw Failure("the first start printed no one-time password");
  Passwords one_time;
  InstructorOptions options{.server = server_->address(),
                            .fingerprint = server_->fingerprint(),
                            .user = kInstructorName,
                            .password_file = one_time.set(kInstructorName, *server_->one_time_password()),
                            .new_password_file = passwords_.file_of(kInstructorName),
                            .state_folder = folder_.path() / "state"};
  Instructor(options).must({"passwd"});
  options.password_file = std::exchange(options.new_password_file, {});
  instructor_.emplace(options);
}

void Classroom::start(std::uint16_t port) {
  auto started = ServerProcess::start({.data = data(),
                                       .log = folder_.path() / "server.log",
                                       .port = port,
                                       .configuration = configuration_,
                                       .more = {}});
  if (!started) throw Failure("the server did not start:\n" + started.error().log);
  server_ = std::move(*started);
}

void Classroom::add_student(const std::string& name, const std::vector<std::string>& tapes) {
  instructor_->must({"student", "add", name, "--password-file", passwords_.file_of(name).string()});
  for (const auto& tape : tapes) {
    const auto file = folder_.write("tape", tape);
    instructor_->must({"program", "send", file.string(), name});
  }
}

StationOptions Classroom::station_options(int station, const std::string& student) {
  return {.server = server_->address(),
          .fingerprint = server_->fingerprint(),
          .station = station,
          .user = student,
          .password_file = passwords_.file_of(student),
          .new_password_file = {},
          .state_folder = folder_.path() / "state",
          .log = folder_.path() / ("station" + std::to_string(station) + ".log"),
          .more = {}};
}

StationProcess Classroom::seat(int station, const std::string& student) {
  StationProcess process(station_options(station, student));
  process.wait_for("CNC 3");
  return process;
}

StationProcess Classroom::seat_behind(const TcpProxy& line, int station, const std::string& student) {
  StationOptions options = station_options(station, student);
  options.server = line.address();
  StationProcess process(options);
  process.wait_for("CNC 3");
  return process;
}

Terminal Classroom::terminal(int station, const std::string& student, int rows, int columns) {
  return Terminal({.program = programs_folder() / "cnclab-station",
                   .arguments = station_arguments(station_options(station, student)),
                   .environment = {{"XDG_STATE_HOME", (folder_.path() / "state").string()},
                                   {"XDG_DATA_HOME", (folder_.path() / "state").string()}},
                   .rows = rows,
                   .columns = columns});
}

void Classroom::give_machine(int station, StationProcess& seat) {
  instructor_->must({"select", std::to_string(station)});
  seat.key("START");
  if (!eventually(kLimit, [&] { return instructor_->status().at("selected") == station; })) {
    throw Failure("station " + std::to_string(station) + " did not get the machine:\n" + seat.text());
  }
}

void Classroom::crash_and_restart() {
  const auto port = server_->port();
  server_->kill_hard();
  start(port);
}

}  // namespace cnclab::harness
