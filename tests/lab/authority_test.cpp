// Control authority: the table's rules one by one (AUTH-001 to AUTH-016); authority_walk_test.cpp goes through all
// states.
#include "lab/authority.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace cnclab::lab {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr LoginId kFirst{11}, kSecond{22};
constexpr db::PersonId kLehrer{1}, kEva{2}, kUdo{3};

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
  ASSERT_TRUE(find<Latch>(scene.apply(HaltPressed{kUdo, "udo", 2})));
  EXPECT_TRUE(scene.authority.is_halted());
  EXPECT_TRUE(find<Refuse>(scene.apply(HaltReleased{kEva})));
  EXPECT_TRUE(scene.authority.is_halted());
  const auto released = find<Latch>(scene.apply(HaltReleased{kUdo}));
  ASSERT_TRUE(released);
  EXPECT_FALSE(released->on);
  scene.apply(HaltPressed{kUdo, "udo", 2});
  EXPECT_TRUE(find<Latch>(scene.apply(HaltCleared{"lehrer"})));
  EXPECT_FALSE(scene.authority.is_halted());
  EXPECT_EQ(scene.authority.selected(), 1) << "a halt does not move the selector";
}

TEST(Authority, AUTH_006_EachOfThosePressingHoldsTheHaltUntilTheOwnRelease) {
  Scene scene;
  scene.apply(HaltPressed{kEva, "eva", 1});
  EXPECT_TRUE(find<Latch>(scene.apply(HaltPressed{kLehrer, "lehrer"}))) << "a halt stops every time";
  scene.apply(HaltPressed{kLehrer, "lehrer"});
  EXPECT_EQ(scene.authority.halted_by(language::Tongue::german), "Platz 1, eva; lehrer");
  EXPECT_FALSE(find<Latch>(scene.apply(HaltReleased{kEva}))) << "the instructor's press holds";
  EXPECT_EQ(scene.authority.halted_by(language::Tongue::english), "lehrer");
  const auto released = find<Latch>(scene.apply(HaltReleased{kLehrer}));
  ASSERT_TRUE(released);
  EXPECT_FALSE(released->on);
}

TEST(Authority, AUTH_006_TheInstructorsClearTakesEverybodysPress) {
  Scene scene;
  for (const HaltPressed& press : {HaltPressed{kEva, "eva", 1}, HaltPressed{kUdo, "udo", 2}}) scene.apply(press);
  const auto entry = find<Journal>(scene.apply(HaltCleared{"lehrer"}));
  EXPECT_FALSE(scene.authority.is_halted());
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->detail, "station 1, eva; station 2, udo (lehrer)");
}

TEST(Authority, AUTH_006_WhoMayNotReleaseIsToldWhoMay) {
  Scene scene;
  scene.apply(HaltPressed{kEva, "eva", 1});
  const auto refused = find<Refuse>(scene.apply(HaltReleased{kUdo}));
  ASSERT_TRUE(refused);
  EXPECT_TRUE(refused->german.contains("(Platz 1, eva)")) << refused->german;
  EXPECT_TRUE(refused->english.contains("by station 1, eva or")) << refused->english;
}

TEST(Authority, AUTH_015_GrantsRefusalsLossesStopsAndPowerAreJournalledWithWhomAndByWhom) {
  Scene scene;
  const auto line = [&](const Event& event) {
    const auto entry = find<Journal>(scene.apply(event));
    if (!entry) return std::string("nothing");
    return entry->kind + "|" + entry->detail + "|" + std::to_string(static_cast<std::uint64_t>(entry->login));
  };
  EXPECT_EQ(line(Select{1, false, "lehrer"}), "offer|lehrer|11");
  EXPECT_EQ(line(Accept{kFirst}), "grant||11");
  scene.machine.moving = true;
  EXPECT_EQ(line(Select{2, false, "lehrer"}), "refused|The axes are still moving. (lehrer)|22");
  EXPECT_EQ(line(ReleaseIt{false, "lehrer"}), "refused|The axes are still moving. (lehrer)|11");
  scene.machine.run_active = true;  // also where it dwells, and nothing moves
  EXPECT_EQ(line(Select{2, false, "lehrer"}), "refused|A program is still running. (lehrer)|22");
  scene.machine.manual_motion = true;
  EXPECT_EQ(line(Select{2, false, "lehrer"}), "refused|The axes are still moving. (lehrer)|22");
  scene.machine.run_active = scene.machine.manual_motion = false;
  EXPECT_EQ(line(Select{3, false, "lehrer"}), "refused|nobody logged in (lehrer)|0");
  EXPECT_EQ(line(HaltPressed{kUdo, "udo", 2}), "halt|station 2, udo|11");
  EXPECT_EQ(line(HaltPressed{kEva, "eva", 1}), "halt|station 1, eva|11");
  EXPECT_EQ(line(HaltReleased{kUdo}), "halt_cleared|station 2, udo; still halted by station 1, eva|11");
  EXPECT_EQ(line(HaltCleared{"lehrer"}), "halt_cleared|station 1, eva (lehrer)|11");
  EXPECT_EQ(line(PowerSwitched{false, "lehrer"}), "power_off|lehrer|11");
  EXPECT_EQ(line(PowerSwitched{true, "lehrer"}), "power_on|lehrer|11");
  EXPECT_EQ(line(LoggedOut{kFirst, "line lost"}), "lease_ended|line lost|11") << "also when that login ends with it";
}

// Every way in which a lease or an offer ends names the login that had it, and the instructor where one ordered it.
TEST(Authority, AUTH_015_TheEndOfALeaseNamesWhoHadIt) {
  struct Row {
    Event event;
    std::string detail;
  };
  const std::vector<Row> rows{
      {LoggedOut{kFirst, "taken over"}, "taken over"},
      {LoggedIn{1, LoginId{33}}, "another login"},
      {ReleaseIt{true, "lehrer"}, "released (lehrer)"},
      {Select{2, false, "lehrer"}, "selected (lehrer)"},
      {Select{2, true, "lehrer"}, "selected by force (lehrer)"},
      {Locked{kFirst, true}, "locked"},
      {Deprived{kFirst, "RESET"}, "RESET"},
  };
  for (const Row& row : rows) {
    Scene scene;
    scene.grant_to(1, kFirst);
    const auto entry = find<Journal>(scene.apply(row.event));
    ASSERT_TRUE(entry) << row.detail;
    EXPECT_EQ(entry->kind + "|" + entry->detail, "lease_ended|" + row.detail);
    EXPECT_EQ(entry->login, kFirst) << row.detail;
  }
}

TEST(Authority, AUTH_016_LockingEndsWhatTheLoginHasOfTheMachineAndBarsTheSelector) {
  Scene granted;
  granted.grant_to(1, kFirst);
  granted.machine.moving = true;
  EXPECT_TRUE(find<Revoke>(granted.apply(Locked{kFirst, true})));
  EXPECT_EQ(granted.authority.selected(), 0);

  Scene offered;
  offered.apply(Select{1});
  offered.apply(Locked{kFirst, true});
  EXPECT_EQ(offered.authority.offered(), 0);
  EXPECT_TRUE(find<Refuse>(offered.apply(Select{1})));
  offered.apply(Locked{kFirst, false});
  EXPECT_FALSE(find<Refuse>(offered.apply(Select{1})));

  Scene waiting;
  waiting.grant_to(1, kFirst);
  waiting.machine.moving = true;
  waiting.apply(Select{2, true});
  waiting.apply(Locked{kSecond, true});
  waiting.machine.moving = false;
  waiting.apply(Polled{});
  EXPECT_EQ(waiting.authority.offered(), 0) << "the next one was locked while the machine came to rest";
}

TEST(Authority, AUTH_016_TheLossOfTheTypingConsoleEndsTheLeaseOfThatStationAlone) {
  Scene scene;
  scene.grant_to(1, kFirst);
  EXPECT_FALSE(find<Revoke>(scene.apply(Deprived{kSecond, "console lost"})));
  EXPECT_EQ(scene.authority.selected(), 1);
  EXPECT_TRUE(find<Revoke>(scene.apply(Deprived{kFirst, "console lost"})));
  EXPECT_EQ(scene.authority.selected(), 0);
}

TEST(Authority, AUTH_016_AConsoleThatFallsSilentIsNamedAndTheStationHasItsKeysBack) {
  for (const bool is_console : {true, false}) {
    Scene scene;
    scene.grant_to(1, kFirst);
    scene.now_ns += 500 * kMs;
    scene.apply(Heard{kFirst, scene.now_ns - 400 * kMs, is_console});
    scene.now_ns += 1000 * kMs;
    const Actions actions = scene.apply(Polled{});
    ASSERT_TRUE(find<Journal>(actions));
    EXPECT_EQ(find<Journal>(actions)->detail, is_console ? "console silent" : "station silent");
    EXPECT_EQ(find<GiveKeysBack>(actions).has_value(), is_console);
  }
}

TEST(Authority, AUTH_016_AConsoleThatIsSilentFromTheFirstMomentOfALeaseIsNamedToo) {
  Scene scene;
  scene.grant_to(1, kFirst);
  scene.apply(Heard{kFirst, scene.now_ns - 100 * kMs, true});  // no renewal: older than the grant
  scene.now_ns += 1100 * kMs;
  EXPECT_EQ(find<Journal>(scene.apply(Polled{}))->detail, "console silent");
}

}  // namespace
}  // namespace cnclab::lab
