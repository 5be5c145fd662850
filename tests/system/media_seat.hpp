// A student at a station with a folder for diskettes, tapes and printed pages, as the tests of EXTERNE DATEN use it.
#pragma once

#include <fstream>

#include "harness/classroom.hpp"

namespace cnclab::harness {

inline constexpr const char* kTape = "P0007N001G11F1000N002G01X+12000Y-1500N003G00Z+5000%";

class MediaSeat {
 public:
  explicit MediaSeat(const std::string& configuration = "") : room_(configuration) {
    room_.add_student("anna", {kTape});
  }
  [[nodiscard]] Classroom& room() { return room_; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return media_.path() / name; }
  [[nodiscard]] std::string content(const std::string& name) const { return read_file(file(name)); }
  void lay(const std::string& name, const std::string& content) const { std::ofstream(file(name)) << content; }
  [[nodiscard]] const std::filesystem::path& folder() const { return media_.path(); }

  /// The station in EXTERNE DATEN; over `server`, if another address than the server's is given.
  [[nodiscard]] StationProcess sit_down(const std::string& server = "") {
    StationOptions options = room_.station_options(1, "anna");
    options.more = {"--media", media_.path().string()};
    if (!server.empty()) options.server = server;
    StationProcess station(options);
    station.wait_for("CNC 3");
    station.key("EXTERNE_DATEN");
    return station;
  }
  /// The program's tape text as the instructor sees it; empty where there is none.
  [[nodiscard]] std::string stored(const std::string& program) {
    const OneShot shown = room_.instructor().run({"program", "show", "anna", program});
    return shown.exit_code == 0 ? shown.output : std::string();
  }

 private:
  TemporaryFolder media_;
  Classroom room_;
};

}  // namespace cnclab::harness
