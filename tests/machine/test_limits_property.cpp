// Limits as invariants: any program under any operator, every tick checked.
//
// CNCLAB_SOAK=1 asks for 100 000 random runs; without it the same few hundred are run each time.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "run_player.hpp"

namespace cnclab::machine {
namespace {

/// How many runs; a failing one is repeated with the RC_PARAMS that RapidCheck prints (reproduce=…).
const bool kIsAsked = [] {
  const char* given = std::getenv("RC_PARAMS");
  if (given != nullptr && std::string(given).find("reproduce") != std::string::npos) return true;
  const bool soak = std::getenv("CNCLAB_SOAK") != nullptr;
  return setenv("RC_PARAMS", soak ? "max_success=100000" : "seed=3300 max_success=500", 1) == 0;
}();

/// Whole numbers spread evenly over the decades between both, shrinking to the least.
rc::Gen<int> decades(int least, int most) {
  return rc::gen::map(rc::gen::resize(100, rc::gen::inRange(0, 1001)), [least, most](int n) {
    return static_cast<int>(std::lround(least * std::pow(static_cast<double>(most) / least, n / 1000.0)));
  });
}

rc::Gen<int> number(int least, int most) { return rc::gen::resize(100, rc::gen::inRange(least, most + 1)); }

rc::Gen<bool> rarely() {
  return rc::gen::map(number(0, 7), [](int n) { return n == 7; });
}

rc::Gen<Element> an_element() {
  using Kind = Element::Kind;
  const auto kind = rc::gen::weightedElement<Kind>({{6, Kind::line},
                                                    {2, Kind::rapid},
                                                    {5, Kind::arc},
                                                    {2, Kind::spiral},
                                                    {3, Kind::chain},
                                                    {2, Kind::dust},
                                                    {1, Kind::fourth_axis},
                                                    {1, Kind::dwell},
                                                    {1, Kind::spindle},
                                                    {1, Kind::coolant},
                                                    {1, Kind::mark},
                                                    {1, Kind::output},
                                                    {1, Kind::rename},
                                                    {1, Kind::wait},
                                                    {1, Kind::halt},
                                                    {1, Kind::signal},
                                                    {3, Kind::reference}});
  const auto rise = rc::gen::map(rc::gen::pair(number(0, 3), decades(1, 4000)),
                                 [](const auto& pair) { return pair.first == 3 ? pair.second : 0; });
  return rc::gen::build<Element>(
      rc::gen::set(&Element::kind, kind), rc::gen::set(&Element::heading_deg, number(0, 359)),
      rc::gen::set(&Element::turn_deg, number(-360, 360)), rc::gen::set(&Element::way_um, decades(1, 20'000)),
      rc::gen::set(&Element::rise_um, rise), rc::gen::set(&Element::plane, number(0, 2)),
      rc::gen::set(&Element::feed, decades(60, 9999)), rc::gen::set(&Element::exact_stop, rarely()),
      rc::gen::set(&Element::override_off, rarely()),
      rc::gen::set(&Element::ends_block, rc::gen::map(rarely(), [](bool b) { return !b; })));
}

rc::Gen<Action> an_action() {
  using Kind = Action::Kind;
  const auto kind = rc::gen::weightedElement<Kind>({{6, Kind::stop},
                                                    {9, Kind::go},
                                                    {8, Kind::potentiometer},
                                                    {3, Kind::single_block},
                                                    {1, Kind::power_off},
                                                    {2, Kind::power_on},
                                                    {1, Kind::fault},
                                                    {1, Kind::revoke},
                                                    {1, Kind::expire},
                                                    {2, Kind::grant},
                                                    {1, Kind::stale_go},
                                                    {1, Kind::halt},
                                                    {2, Kind::release_halt},
                                                    {1, Kind::abandon},
                                                    {2, Kind::jog},
                                                    {1, Kind::reference},
                                                    {1, Kind::input},
                                                    {4, Kind::begin_again},
                                                    {1, Kind::feed}});
  return rc::gen::build<Action>(
      rc::gen::set(&Action::kind, kind),
      rc::gen::set(&Action::after, rc::gen::map(decades(1, 700), [](int n) { return n - 1; })),
      rc::gen::set(&Action::value, number(0, 10'000)));
}

rc::Gen<Setup> a_setup() {
  const auto per_mm = rc::gen::container<std::array<int, 4>>(decades(1, 2000));
  const auto travel = rc::gen::map(rc::gen::pair(number(0, 2), decades(1, 20'000)),
                                   [](const auto& pair) { return pair.first == 2 ? 1000 + pair.second : 500'000; });
  return rc::gen::build<Setup>(
      rc::gen::set(&Setup::f_max, number(100, 9999)), rc::gen::set(&Setup::start_stop, decades(1, 1500)),
      rc::gen::set(&Setup::ramp, rc::gen::map(decades(1, 400), [](int n) { return 4 + n; })),
      rc::gen::set(&Setup::stop_delay, number(1, 20)), rc::gen::set(&Setup::creep_um, number(0, 800)),
      rc::gen::set(&Setup::travel_um, travel), rc::gen::set(&Setup::steps_per_mm, per_mm),
      rc::gen::set(&Setup::fed_at_once, number(0, 3)), rc::gen::set(&Setup::plan_every, number(1, 9)));
}

rc::Gen<RandomRun> a_run() {
  return rc::gen::build<RandomRun>(
      rc::gen::set(&RandomRun::setup, a_setup()),
      rc::gen::set(&RandomRun::elements, rc::gen::resize(10, rc::gen::container<std::vector<Element>>(an_element()))),
      rc::gen::set(&RandomRun::actions, rc::gen::resize(14, rc::gen::container<std::vector<Action>>(an_action()))));
}

TEST(Limits, HoldInEveryTickOfAnyProgramUnderAnyOperator) {
  ASSERT_TRUE(kIsAsked);
  std::int64_t runs = 0, ends = 0, moving = 0, stops = 0, switches = 0, references = 0;
  const bool held = rc::check("every rule of motion holds in every tick", [&] {
    const RandomRun run = *a_run().as("run");
    const Played played = RunPlayer(run).play();
    ++runs;
    ends += played.reached_end ? 1 : 0;
    moving += played.moving_ticks;
    stops += played.rests_after_stop;
    switches += played.limit_stops;
    references += played.program_references;
    if (!played.broken.empty()) RC_FAIL(played.broken);
  });
  EXPECT_TRUE(held);
  // The property must not hold because nothing happens.
  EXPECT_GT(ends * 3, runs) << "runs that reach their end";
  EXPECT_GT(moving, runs * 500) << "ticks in motion";
  EXPECT_GT(stops * 3, runs) << "stops in motion";
  EXPECT_GT(switches * 20, runs) << "limit switches";
  EXPECT_GT(references * 40, runs) << "G69 that found its switches";
}

}  // namespace
}  // namespace cnclab::machine
