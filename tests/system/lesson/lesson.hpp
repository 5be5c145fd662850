// The demo lesson: a classroom of real processes that is played from the first login to the closing table.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/instructor.hpp"
#include "harness/passwords.hpp"
#include "harness/server_process.hpp"
#include "harness/tcp_proxy.hpp"
#include "inspection.hpp"
#include "seat.hpp"

namespace cnclab::lesson {

/// Played from top to bottom by `play`. Any step that does not go as the users rely on throws harness::Failure; the
/// destructor ends every process that was started.
class Lesson {
 public:
  /// out   folder for database, traces, tapes, pictures and logs; those of an earlier lesson are removed
  explicit Lesson(std::filesystem::path out);

  /// Whether every part came out as drawn.
  [[nodiscard]] bool play();
  /// What was being done last, for the message of a failure.
  [[nodiscard]] const std::string& step() const { return step_; }

 private:
  void prepare_folder();
  void open_lab();
  void enrol();
  void sit_down();
  void key_in_everything();
  void train_together();

  // On the lab's machine, one seat after the other.
  void give_machine_to(Seat& seat);
  void run_part(Seat& seat);
  void run_plainly(Seat& seat);
  void run_with_rival(Seat& seat);
  void run_with_stop(Seat& seat);
  void run_with_turned_potentiometer(Seat& seat);
  void run_with_refused_select(Seat& seat);
  void run_with_cut_line(Seat& seat);
  void lose_line(Seat& seat, const Point& start);
  void come_back(Seat& seat);
  void inspect_later(const Seat& seat);

  void crash_while_storing();
  void find_every_block();
  void find_blocks_of(const Seat& seat) const;
  void draw_pictures();
  void close_lab();

  /// One line of progress; throws when the user wants to stop.
  void say(const std::string& text);
  /// The same for all seats at once; the first failure is thrown when all have come to an end.
  void at_all_seats(const std::function<void(Seat&)>& action);
  [[nodiscard]] std::filesystem::path file(const char* folder, const Part& part, const std::string& ending) const;
  [[nodiscard]] Seat& seat(int station);
  [[nodiscard]] Point machine_at_rest() const;
  void wait_until_away_from(const Point& place) const;
  void expect_machine_at(const Point& place, const std::string& why) const;

  std::filesystem::path out_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::string step_ = "preparing";
  harness::Passwords passwords_;
  std::optional<harness::ServerProcess> server_;
  std::optional<harness::Instructor> instructor_;
  std::unique_ptr<harness::TcpProxy> line_;  ///< of the station whose line is cut
  std::vector<std::unique_ptr<Seat>> seats_;
  std::vector<std::future<ReportRow>> inspections_;
  std::vector<int> stored_in_storm_;  ///< blocks acknowledged before the crash, by seat
  int acknowledged_ = 0;
};

/// Asks the running lesson to end at its next step; for signal handlers.
void interrupt_lesson();

}  // namespace cnclab::lesson
