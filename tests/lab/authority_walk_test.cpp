// AUTH-014: the rules keep every invariant in every state, and every invariant is alive: a mutant breaks it.
#include "authority_walk.hpp"

#include <gtest/gtest.h>

#include <iostream>

namespace cnclab::lab {

void PrintTo(const Mutation& mutation, std::ostream* out) { *out << mutation.name; }

namespace {

template <class What>
std::function<bool(Event&, const Authority&)> swallows() {
  return [](Event& event, const Authority&) { return !std::holds_alternative<What>(event); };
}

template <class What>
std::function<bool(const Action&)> drops() {
  return [](const Action& action) { return std::holds_alternative<What>(action); };
}

std::vector<Mutation> mutants() {
  std::vector<Mutation> all;
  const auto with = [&](const char* name, const char* breaks) -> Mutation& {
    all.push_back({name, breaks, {}, {}, {}, {}});
    return all.back();
  };
  with("end_of_lease_not_told_to_the_channel", "AUTH-002").drops = drops<Revoke>();
  with("leaving_is_not_noticed", "AUTH-002").event = swallows<LoggedOut>();
  with("lease_numbers_begin_anew_after_a_crash", "AUTH-002").crash = [](const Authority&) {
    return Authority{{}, Epoch{0}};
  };
  with("grant_does_not_reach_the_channel", "AUTH-001").drops = drops<Grant>();
  with("control_is_not_connected", "AUTH-003").drops = drops<Connect>();
  with("control_stays_connected_after_its_lease", "AUTH-003").drops = [](const Action& action) {
    const auto* connect = std::get_if<Connect>(&action);
    return connect != nullptr && !connect->to_lab_machine;
  };
  with("blind_to_motion", "AUTH-004").machine = [](MachineView& machine) { machine.moving = false; };
  with("every_selection_by_force", "AUTH-004").event = [](Event& event, const Authority&) {
    if (auto* select = std::get_if<Select>(&event)) select->force = true;
    return true;
  };
  with("anybodys_START_accepts", "AUTH-005").event = [](Event& event, const Authority& authority) {
    if (auto* accept = std::get_if<Accept>(&event)) accept->login = authority.asked();
    return true;
  };
  with("STOP_does_not_decline", "AUTH-005").event = swallows<Decline>();
  with("time_does_not_pass_for_offers", "AUTH-005").event = [](Event& event, const Authority& authority) {
    return !(std::holds_alternative<Polled>(event) && authority.phase() == Phase::offered);
  };
  with("time_does_not_pass_for_leases", "AUTH-007").event = [](Event& event, const Authority& authority) {
    return !(std::holds_alternative<Polled>(event) && authority.phase() == Phase::granted);
  };
  with("halt_is_lost", "AUTH-006").event = swallows<HaltPressed>();
  with("anybody_releases_a_halt", "AUTH-006").event = [](Event& event, const Authority&) {
    if (std::holds_alternative<HaltReleased>(event)) event = HaltCleared{};
    return true;
  };
  with("only_who_pressed_first_holds_a_halt", "AUTH-006").event = [](Event& event, const Authority& authority) {
    auto* press = std::get_if<HaltPressed>(&event);
    if (press != nullptr && authority.is_halted()) *press = authority.halts().front();
    return true;
  };
  with("a_press_is_never_released", "AUTH-006").event = swallows<HaltReleased>();
  with("the_latch_stays_when_the_last_has_released", "AUTH-006").drops = [](const Action& action) {
    const auto* latch = std::get_if<Latch>(&action);
    return latch != nullptr && !latch->on;
  };
  with("power_switch_is_lost", "AUTH-010").event = swallows<PowerSwitched>();
  with("lease_survives_a_crash", "AUTH-012").crash = [](const Authority& before) { return before; };
  with("nothing_is_journalled", "AUTH-015").drops = drops<Journal>();
  with("lock_is_lost", "AUTH-016").event = swallows<Locked>();
  with("loss_of_the_console_is_not_noticed", "AUTH-016").event = swallows<Deprived>();
  with("a_silent_console_keeps_the_keys", "AUTH-016").drops = drops<GiveKeysBack>();
  with("a_silent_console_passes_for_the_station", "AUTH-016").event = [](Event& event, const Authority&) {
    if (auto* sign = std::get_if<Heard>(&event)) sign->is_console_behind = false;
    return true;
  };
  return all;
}

TEST(AuthorityWalk, AUTH_014_EveryReachableStateKeepsTheInvariants) {
  const WalkResult result = walk({});
  EXPECT_EQ(result.broken, "") << result.how;
  EXPECT_GT(result.states, 10'000U) << "the walk must not end early";
  std::cout << "AUTH-014: " << result.states << " states, " << result.steps << " steps, "
            << (result.broken.empty() ? 0 : 1) << " violations\n";
}

class AuthorityMutants : public testing::TestWithParam<Mutation> {};

TEST_P(AuthorityMutants, AUTH_014_BreakTheInvariantThatGuardsAgainstThem) {
  const WalkResult result = walk(GetParam());
  EXPECT_EQ(result.broken.substr(0, result.broken.find(' ')), GetParam().breaks) << result.broken << ", " << result.how;
}

INSTANTIATE_TEST_SUITE_P(All, AuthorityMutants, testing::ValuesIn(mutants()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace cnclab::lab
