// A whole lab for a test: a server with an empty data folder, an instructor with a password of their own, students and
// stations as they are asked for.
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <string>

#include "harness/instructor.hpp"
#include "harness/passwords.hpp"
#include "harness/server_process.hpp"
#include "harness/station_process.hpp"
#include "harness/tcp_proxy.hpp"
#include "harness/temporary_folder.hpp"
#include "harness/terminal.hpp"

namespace cnclab::harness {

class Classroom {
 public:
  /// Starts the server and changes the instructor's one-time password. `configuration` is a whole lab.toml.
  explicit Classroom(const std::string& configuration = "");

  /// Adds a student and a program for each tape (P0001N001…, one or several programs in each).
  void add_student(const std::string& name, const std::vector<std::string>& tapes = {});
  /// How that student would log in at a station.
  [[nodiscard]] StationOptions station_options(int station, const std::string& student);
  /// The student at the station, logged in and with the first screen there.
  [[nodiscard]] StationProcess seat(int station, const std::string& student);
  /// As `seat`, over a line that can fail.
  [[nodiscard]] StationProcess seat_behind(const TcpProxy& line, int station, const std::string& student);
  /// The student at the station in a real terminal.
  [[nodiscard]] Terminal terminal(int station, const std::string& student, int rows, int columns);
  /// Selects the station and lets its student accept with START.
  void give_machine(int station, StationProcess& seat);

  /// Kills the server and starts it again on the same port with the same data.
  void crash_and_restart();

  [[nodiscard]] ServerProcess& server() { return *server_; }
  [[nodiscard]] const Instructor& instructor() const { return *instructor_; }
  [[nodiscard]] Passwords& passwords() { return passwords_; }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path data() const { return folder_.path() / "data"; }

 private:
  void start(std::uint16_t port);

  TemporaryFolder folder_;
  Passwords passwords_;
  std::string configuration_;
  std::optional<ServerProcess> server_;
  std::optional<Instructor> instructor_;
};

}  // namespace cnclab::harness
