// A control with a real channel and the simulated machine, in virtual time; the test answers its stores.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/channel.hpp"
#include "machine/simulated_machine.hpp"
#include "panel/control.hpp"

namespace cnclab::panel {

inline constexpr double kStep_mm = 0.005;  ///< of an axis, as delivered (MD-131)

class Bench {
 public:
  struct Setup {
    Settings settings{};
    machine::MachineData data{};
    std::string tape{};  ///< programs in the memory at the start
    bool is_lab_machine = false;
    machine::MachineData lab_data{};
  };

  Bench() : Bench(Setup{}) {}
  explicit Bench(const Setup& setup);

  /// Key names of interfaces.md separated by blanks; "ENTER+RESET" is a chord. Stores are answered at once.
  void keys(std::string_view names);
  void press(Key key);
  /// Digits, '.' and '-' (sign) one by one.
  void type(std::string_view text);
  /// Virtual time: ticks of 1 ms, a poll each 10 ms.
  void run_for(int ms);
  /// Runs until `condition`, at most `most_ms`; false when that was not enough.
  bool run_until(const std::function<bool()>& condition, int most_ms = 600'000);
  /// Runs until the control is in STOP state and no axis moves.
  bool run_to_rest(int most_ms = 600'000);

  /// The next store gets this answer instead of "it is on disk".
  void fail_next_store(std::string sentence) { next_store_error_ = std::move(sentence); }
  [[nodiscard]] int stores() const { return stores_; }

  /// → or another key held so long.
  void hold(Key key, int ms);

  [[nodiscard]] Screen screen() const;
  [[nodiscard]] std::string row(int index) const;        ///< without trailing blanks
  [[nodiscard]] std::string monitor(int index) const;    ///< a line of the 64×16 monitor, without trailing blanks
  [[nodiscard]] std::string picture() const;             ///< 24 lines
  [[nodiscard]] std::vector<std::string> marks() const;  ///< inverse cells as "ROW COL LENGTH"
  [[nodiscard]] machine::Snapshot snapshot() const { return channel->snapshot(); }
  [[nodiscard]] double istwert(int axis) const { return snapshot().istwert_mm[static_cast<std::size_t>(axis)]; }

  machine::SimulatedMachine machine;
  std::shared_ptr<machine::Channel> channel;
  Control control;
  Now now{0, {11, 39, 58, 2, 3, 82}};
  SideView side;
  std::map<std::string, std::string> media;  ///< the files at the station
  std::vector<RemoteStart> remote_starts;    ///< that the control has asked about
  std::string remote_refusal;                ///< the answer to them; empty: allowed
  std::vector<std::string> line_news;

 private:
  void answer(const Outcome& outcome);

  std::optional<std::string> next_store_error_;
  int stores_ = 0;
};

/// The memory that holds the programs of a tape; a tape with errors fails the test.
[[nodiscard]] Memory memory_of(const std::string& tape, int memory_bytes = 16384);

/// Bild 7 as tape text.
inline constexpr std::string_view kBild7 =
    "P0001N001G00X+50000Y+50000Z+50000N002G04H0010N003G01X+25000Y+10000Z+4000F1000M03"
    "N004G02X+10000Y+0I+5000J+0N005G20P0001N001%";

}  // namespace cnclab::panel
