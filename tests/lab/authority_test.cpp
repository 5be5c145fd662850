// Control authority: the table's rules, and an exhaustive walk through its states (AUTH-001 to AUTH-016).
#include "lab/authority.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace cnclab::lab {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr LoginId kFirst{11}, kSecond{22};

template <class What>
std::optional<What> find(const Actions& actions) {
  for (const Action& action : actions)
    if (const auto* what = std::get_if<What>(&action)) return *what;
  return std::nullopt;
}

/// An authority with two stations, and the machine and the time that it is told.
struct Scene {
  explicit Scene(AuthorityRules rules = {}, Epoch newest = Epoch{40}) : authority(rules, newest) {
    apply(LoggedIn{1, kFirst});
    apply(LoggedIn{2, kSecond});
  }
  Actions apply(const Event& event) { return authority.apply(event, machine, now_ns); }
  Actions grant_to(int station, LoginId login) {
    apply(Select{station});
    return apply(Accept{login});
  }

  Authority authority;
  MachineView machine;
  std::int64_t now_ns = 1000 * kMs;
};

TEST(Authority, AUTH_002_SelectIsRefusedWhenNobodyIsLoggedInThere) {
  Scene scene;
  EXPECT_TRUE(find<Refuse>(scene.apply(Select{3})));
  EXPECT_EQ(scene.authority.phase(), Phase::nobody);
}

TEST(Authority, AUTH_005_SelectionOffersAndOnlyStartOfTheAskedGrants) {
  Scene scene;
  EXPECT_FALSE(find<Grant>(scene.apply(Select{1})));
  EXPECT_EQ(scene.authority.offered(), 1);
  EXPECT_EQ(scene.authority.selected(), 0);
  EXPECT_FALSE(find<Grant>(scene.apply(Accept{kSecond})));
  const Actions actions = scene.apply(Accept{kFirst});
  ASSERT_TRUE(find<Grant>(actions));
  EXPECT_EQ(find<Grant>(actions)->epoch, Epoch{41});
  ASSERT_TRUE(find<Connect>(actions));
  EXPECT_TRUE(find<Connect>(actions)->to_lab_machine);
  EXPECT_EQ(scene.authority.selected(), 1);
}

TEST(Authority, AUTH_005_TheOfferEndsAfterThirtySecondsAndByStop) {
  Scene scene;
  scene.apply(Select{1});
  scene.now_ns += 29'999 * kMs;
  scene.apply(Polled{});
  EXPECT_EQ(scene.authority.offered(), 1);
  scene.now_ns += 1 * kMs;
  scene.apply(Polled{});
  EXPECT_EQ(scene.authority.phase(), Phase::nobody);
  scene.apply(Select{1});
  scene.apply(Decline{kSecond});
  EXPECT_EQ(scene.authority.offered(), 1);
  scene.apply(Decline{kFirst});
  EXPECT_EQ(scene.authority.phase(), Phase::nobody);
}

TEST(Authority, AUTH_005_WithoutTheQuestionSelectionGrantsAtOnce) {
  AuthorityRules rules;
  rules.accept_needed = false;
  Scene scene(rules);
  EXPECT_TRUE(find<Grant>(scene.apply(Select{2})));
  EXPECT_EQ(scene.authority.selected(), 2);
}

TEST(Authority, AUTH_004_BusyMachineRefusesSelectAndReleaseWithTheReason) {
  struct Row {
    const char* name;
    MachineView machine;
    const char* word;
  };
  const Row rows[] = {{"axes move", {.moving = true}, "axes"},
                      {"program runs", {.run_active = true}, "program"},
                      {"spindle turns", {.spindle_on = true}, "spindle"}};
  for (const Row& row : rows) {
    Scene scene;
    scene.grant_to(1, kFirst);
    scene.machine = row.machine;
    for (const Event& event : {Event{Select{2}}, Event{ReleaseIt{}}}) {
      const auto refusal = find<Refuse>(scene.apply(event));
      ASSERT_TRUE(refusal) << row.name;
      EXPECT_NE(refusal->english.find(row.word), std::string::npos) << row.name;
      EXPECT_EQ(scene.authority.selected(), 1) << row.name;
    }
  }
}

TEST(Authority, AUTH_004_ForceEndsTheLeaseAtOnceAndTheNextWaitsForStandstill) {
  Scene scene;
  scene.grant_to(1, kFirst);
  scene.machine.moving = true;
  EXPECT_TRUE(find<Revoke>(scene.apply(Select{2, true})));
  EXPECT_EQ(scene.authority.selected(), 0);
  scene.apply(Polled{});
  EXPECT_EQ(scene.authority.offered(), 0);
  scene.machine.moving = false;
  const Actions actions = scene.apply(Polled{});
  ASSERT_TRUE(find<Connect>(actions));
  EXPECT_FALSE(find<Connect>(actions)->to_lab_machine);
  EXPECT_EQ(scene.authority.offered(), 2);
}

TEST(Authority, AUTH_007_SilenceEndsTheLeaseAfterOneSecondAndEarlierInManualMotion) {
  for (const bool manual : {false, true}) {
    Scene scene;
    scene.grant_to(1, kFirst);
    scene.machine.manual_motion = manual;
    const std::int64_t limit_ms = manual ? 300 : 1000;
    scene.now_ns += limit_ms * kMs;
    EXPECT_FALSE(find<Revoke>(scene.apply(Polled{})));
    scene.now_ns += 1 * kMs;
    const auto revoke = find<Revoke>(scene.apply(Polled{}));
    ASSERT_TRUE(revoke);
    EXPECT_EQ(revoke->cause, machine::StopCause::lease_expired);
    EXPECT_EQ(scene.authority.selected(), 0);
  }
}

TEST(Authority, AUTH_007_OnlyNewerBeatsOfTheHolderRenewAndNeverIntoTheFuture) {
  Scene scene;
  const std::int64_t granted = scene.now_ns;
  scene.grant_to(1, kFirst);
  scene.now_ns += 500 * kMs;
  EXPECT_FALSE(find<Grant>(scene.apply(Heard{kSecond, granted + 400 * kMs})));
  EXPECT_FALSE(find<Grant>(scene.apply(Heard{kFirst, granted - 1})));
  const auto renewed = find<Grant>(scene.apply(Heard{kFirst, granted + 400 * kMs}));
  ASSERT_TRUE(renewed);
  EXPECT_EQ(renewed->expiry_ns, granted + 1400 * kMs);
  const auto future = find<Grant>(scene.apply(Heard{kFirst, granted + 9000 * kMs}));
  ASSERT_TRUE(future);
  EXPECT_EQ(future->expiry_ns, scene.now_ns + 1000 * kMs);
}

TEST(Authority, AUTH_007_ALeaseThatTheTickSawExpireIsNotRenewedByALateSignOfLife) {
  Scene scene;
  scene.grant_to(1, kFirst);
  scene.machine.lease_dead = true;
  EXPECT_FALSE(find<Grant>(scene.apply(Heard{kFirst, scene.now_ns + 1})));
  EXPECT_TRUE(find<Revoke>(scene.apply(Polled{})));
  EXPECT_EQ(scene.authority.selected(), 0);
}

TEST(Authority, AUTH_002_EveryWayOfLeavingEndsTheLease) {
  Scene scene;
  scene.grant_to(1, kFirst);
  const auto revoke = find<Revoke>(scene.apply(LoggedOut{kFirst, "line lost"}));
  ASSERT_TRUE(revoke);
  EXPECT_EQ(scene.authority.phase(), Phase::stopping);
  // The same seat comes back with a new login: it finds no lease.
  scene.apply(LoggedIn{1, LoginId{33}});
  scene.apply(Polled{});
  EXPECT_EQ(scene.authority.selected(), 0);
  EXPECT_EQ(scene.authority.offered(), 0);
}

TEST(Authority, AUTH_006_HaltLatchesUntilWhoPressedOrTheInstructorReleases) {
  Scene scene;
  scene.grant_to(1, kFirst);
  ASSERT_TRUE(find<Latch>(scene.apply(HaltPressed{kSecond, "Platz 2"})));
  EXPECT_TRUE(scene.authority.is_halted());
  EXPECT_TRUE(find<Refuse>(scene.apply(HaltCleared{kFirst})));
  EXPECT_TRUE(scene.authority.is_halted());
  const auto released = find<Latch>(scene.apply(HaltCleared{kSecond}));
  ASSERT_TRUE(released);
  EXPECT_FALSE(released->on);
  scene.apply(HaltPressed{kSecond, "Platz 2"});
  EXPECT_TRUE(find<Latch>(scene.apply(HaltCleared{kNoLogin})));
  EXPECT_FALSE(scene.authority.is_halted());
  EXPECT_EQ(scene.authority.selected(), 1) << "a halt does not move the selector";
}

TEST(Authority, AUTH_006_AHaltStopsEveryTimeAndKeepsItsFirstCause) {
  Scene scene;
  scene.apply(HaltPressed{kFirst, "Platz 1"});
  EXPECT_TRUE(find<Latch>(scene.apply(HaltPressed{kSecond, "Platz 2"})));
  EXPECT_EQ(scene.authority.halted_by(), "Platz 1");
}

TEST(Authority, AUTH_015_GrantsRefusalsLossesStopsAndPowerAreJournalled) {
  Scene scene;
  const auto kinds = [](const Actions& actions) {
    std::set<std::string> found;
    for (const Action& action : actions)
      if (const auto* entry = std::get_if<Journal>(&action)) found.insert(entry->kind);
    return found;
  };
  EXPECT_TRUE(kinds(scene.apply(Select{1})).contains("offer"));
  EXPECT_TRUE(kinds(scene.apply(Accept{kFirst})).contains("grant"));
  scene.machine.moving = true;
  EXPECT_TRUE(kinds(scene.apply(Select{2})).contains("refused"));
  EXPECT_TRUE(kinds(scene.apply(HaltPressed{kSecond, "Platz 2"})).contains("halt"));
  EXPECT_TRUE(kinds(scene.apply(HaltCleared{kNoLogin})).contains("halt_cleared"));
  EXPECT_TRUE(kinds(scene.apply(PowerSwitched{false})).contains("power_off"));
  EXPECT_TRUE(kinds(scene.apply(LoggedOut{kFirst, "line lost"})).contains("lease_ended"));
}

// --- every state that three stations and an instructor can lead to ------------------------------------------------

/// What the walk knows of the world besides the authority: the lease that the channel would honour.
struct World {
  Authority authority{{}, Epoch{0}};
  std::uint64_t channel_epoch = 0;  ///< 0: none is honoured
  bool latched = false;
  bool moving = false;
  std::map<int, std::uint64_t> seats;  ///< who is logged in where
  bool ok = true;
  std::string broken;
};

/// Invariants that must hold after every event, and what the channel makes of the actions.
void carry_out(World& world, const Actions& actions, bool was_moving) {
  const Phase after = world.authority.phase();
  const auto demand = [&](bool holds, const char* what) {
    if (!holds && world.ok) world.ok = false, world.broken = what;
  };
  for (const Action& action : actions) {
    if (const auto* grant = std::get_if<Grant>(&action)) {
      const auto number = static_cast<std::uint64_t>(grant->epoch);
      const bool is_new = number != world.channel_epoch;
      demand(after == Phase::granted, "a grant outside the phase granted");
      demand(!is_new || !was_moving, "a new lease while the machine moves (AUTH-004)");
      demand(!is_new || number > world.channel_epoch, "a lease number that does not grow (AUTH-002)");
      world.channel_epoch = number;
    }
    if (std::holds_alternative<Revoke>(action)) demand(after != Phase::granted, "revoked, yet granted");
    if (const auto* latch = std::get_if<Latch>(&action)) world.latched = latch->on;
  }
  demand(world.latched == world.authority.is_halted(), "the latch and the halt differ (AUTH-006)");
  demand((world.authority.selected() != 0) == (after == Phase::granted), "selected without a lease (AUTH-001)");
}

/// Everything that three stations, each with two logins one after the other, and an instructor can do.
std::vector<Event> all_events() {
  std::vector<Event> events{Polled{}, ReleaseIt{}, ReleaseIt{true}, HaltPressed{kNoLogin, "i"}, HaltCleared{kNoLogin}};
  for (int station = 1; station <= 3; ++station) {
    events.insert(events.end(), {Select{station}, Select{station, true}});
    for (const int generation : {1, 2}) {
      const LoginId login{static_cast<std::uint64_t>(generation * 10 + station)};
      events.insert(events.end(), {LoggedIn{station, login}, LoggedOut{login, "cut"}, Accept{login}, Decline{login},
                                   HaltPressed{login, "s"}, HaltCleared{login}, Heard{login, 1}});
    }
  }
  return events;
}

void follow_seats(World& world, const Event& event) {
  if (const auto* in = std::get_if<LoggedIn>(&event)) world.seats[in->station] = static_cast<std::uint64_t>(in->login);
  if (const auto* out = std::get_if<LoggedOut>(&event))
    std::erase_if(world.seats, [&](const auto& seat) { return seat.second == static_cast<std::uint64_t>(out->login); });
}

/// What decides the future of a state, but for lease numbers, which only grow.
std::string key_of(const World& world) {
  const Authority& a = world.authority;
  std::string key;
  for (const auto& [station, login] : world.seats) key += std::to_string(station) + ":" + std::to_string(login) + " ";
  const auto number = [](auto login) { return std::to_string(static_cast<std::uint64_t>(login)) + ","; };
  return key + number(a.phase()) + number(a.holder()) + number(a.asked()) + number(a.halted_by_login()) +
         number(a.next_station()) + std::to_string(a.is_halted());
}

TEST(Authority, AUTH_014_EveryReachableStateKeepsTheInvariants) {
  const std::vector<Event> events = all_events();
  std::deque<World> open{World{}};
  std::set<std::string> seen{key_of(World{})};
  std::size_t steps = 0;
  while (!open.empty()) {
    const World world = std::move(open.front());
    open.pop_front();
    for (const bool moving : {false, true}) {
      // A machine moves only under a lease that the channel honours, or while it comes to rest.
      if (moving && world.authority.phase() != Phase::granted && world.authority.phase() != Phase::stopping) continue;
      for (const Event& event : events) {
        World next = world;
        const MachineView machine{.moving = moving};
        carry_out(next, next.authority.apply(event, machine, 0), moving);
        follow_seats(next, event);
        ++steps;
        ASSERT_TRUE(next.ok) << next.broken << " after event " << event.index() << " at " << key_of(world);
        if (seen.insert(key_of(next)).second) open.push_back(std::move(next));
      }
    }
  }
  RecordProperty("states", static_cast<int>(seen.size()));
  EXPECT_GT(seen.size(), 1000U) << "the walk must not end early";
  EXPECT_GT(steps, 10'000U);
}

}  // namespace
}  // namespace cnclab::lab
