// One student at one station: what the hands on that keyboard do during the lesson.
#pragma once

#include <string>

#include "harness/station_process.hpp"
#include "parts.hpp"

namespace cnclab::lesson {

/// Used by one thread at a time. Every function throws harness::Failure with the station, the key and the screen when
/// the control does not do what the student expects.
class Seat {
 public:
  Seat(const Part& part, const harness::StationOptions& options);

  [[nodiscard]] int station() const { return station_; }
  [[nodiscard]] const Part& part() const { return part_; }
  /// "station 07 greta", for messages.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] harness::StationProcess& process() { return process_; }

  /// Waits for the menu and opens the potentiometer.
  void log_in();
  /// Opens EINGABEMODUS with a program that does not exist yet: N001 is offered.
  void open_program(int number);
  /// Keys in one block and stores it; the next number must be offered. Returns after the acknowledgement.
  void key_in(const WrittenBlock& block, int number, int plane);
  /// All programs of the part; returns the number of blocks that the control has acknowledged.
  int key_in_programs();

  /// AUTOMAT with the part's P0001 and its first block; nothing runs yet.
  void choose_program();
  /// START, and once more where the control asks for the zero's confirmation (DEC-27); the lamp START is lit.
  void start();
  /// STOP; returns when the lamp START is dark, that is after the ramp.
  void stop();
  /// Waits until the lamp START is dark by itself.
  void finish();
  /// The X, Y, Z on the monitor.
  [[nodiscard]] Point shown_position();
  [[nodiscard]] bool is_started();

 private:
  Part part_;
  int station_;
  harness::StationProcess process_;
};

}  // namespace cnclab::lesson
