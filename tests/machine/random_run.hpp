// Random programs, machines and operators for the properties of motion; everything is plain numbers, so that RapidCheck
// shrinks and prints it.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "geometry/path_item.hpp"
#include "machine/machine_data.hpp"

namespace cnclab::machine {

/// One or some blocks of a program. Every number may be 0.
struct Element {
  enum class Kind : std::uint8_t {
    line,
    rapid,
    arc,     ///< helix where `rise_um` is not 0; full circle where `turn_deg` is a multiple of 360
    spiral,  ///< an arc whose end lies up to 20 µm off its circle (D-55)
    chain,   ///< a tangential row of 40 short lines
    dust,    ///< lines far shorter than a step and the way of a tick
    fourth_axis,
    dwell,
    spindle,
    coolant,
    mark,
    output,
    rename,
    wait,
    halt,
    signal,
    reference,  ///< G69
  };
  Kind kind = Kind::line;
  int heading_deg = 0, turn_deg = 0;
  int way_um = 0;  ///< length, or radius
  int rise_um = 0;
  int plane = 0;
  int feed = 0;  ///< mm/min, may be above F MAX
  bool exact_stop = false, override_off = false, ends_block = true;
};

/// What happens `after` ticks behind the action before.
struct Action {
  enum class Kind : std::uint8_t {
    stop,
    go,
    potentiometer,
    single_block,
    power_off,
    power_on,
    fault,
    revoke,
    expire,
    grant,
    stale_go,
    halt,
    release_halt,
    abandon,
    jog,
    reference,
    input,
    begin_again,
    feed,
  };
  Kind kind = Kind::stop;
  int after = 0;
  int value = 0;
};

/// Machine data within what D-112 allows, and how the lab thread feeds the path.
struct Setup {
  int f_max = 3000, start_stop = 300, ramp = 100, stop_delay = 2, creep_um = 500;
  int travel_um = 500'000;
  std::array<int, 4> steps_per_mm{200, 200, 200, 200};
  int fed_at_once = 0;  ///< items per tick; 0: all before START
  int plan_every = 1;   ///< items
};

struct RandomRun {
  Setup setup;
  std::vector<Element> elements;
  std::vector<Action> actions;
};

[[nodiscard]] MachineData data_of(const Setup& setup);
/// The items in order; sequences count from 1, one each. Begins at the origin.
[[nodiscard]] std::vector<geometry::PathItem> items_of(const std::vector<Element>& elements);

std::ostream& operator<<(std::ostream& out, const Element& element);
std::ostream& operator<<(std::ostream& out, const Action& action);
std::ostream& operator<<(std::ostream& out, const Setup& setup);
std::ostream& operator<<(std::ostream& out, const RandomRun& run);

}  // namespace cnclab::machine
