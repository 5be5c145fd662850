// The walk: a world around the authority, what may happen in it, and what must hold after each step.
#include "authority_walk.hpp"

#include <algorithm>
#include <deque>

namespace cnclab::lab {

namespace {

constexpr std::int64_t kAfterLease_ns = 1'001'000'000;   ///< AUTH-007: silence ends a lease
constexpr std::int64_t kAfterOffer_ns = 30'000'000'000;  ///< AUTH-005: an offer is over

/// The server ends at once and is started again; its database keeps the newest lease number.
struct Crashed {};
using Happening = std::variant<Event, Crashed>;

/// What the walk knows besides the authority: what channel, seats and screens would make of its actions.
struct World {
  Authority authority{{}, Epoch{0}};
  std::uint64_t newest_lease = 0;  ///< greatest that the channel was ever granted
  bool is_honoured = false;        ///< the channel honours that lease
  bool is_console_behind = false;  ///< the holder's console was heard of later than its station
  LoginId connected = kNoLogin;    ///< whose control is connected to the machine
  bool is_latched = false;
  bool has_power = true;
  std::set<db::PersonId> pressing;  ///< who has pressed MASCHINE HALT and not released it
  std::map<int, LoginId> seats;
  std::set<LoginId> locked;
};

/// One step and what it did.
struct Step {
  const World& before;
  World& after;
  const Event& event;
  bool was_moving;
  const Actions& actions;
};

template <class What>
const What* first_of(const Actions& actions) {
  for (const Action& action : actions)
    if (const auto* what = std::get_if<What>(&action)) return what;
  return nullptr;
}

bool is_seated(const World& world, LoginId login) {
  return std::ranges::any_of(world.seats, [&](const auto& seat) { return seat.second == login; });
}

/// What the world makes of the event itself.
void follow(World& world, const Event& event) {
  if (const auto* in = std::get_if<LoggedIn>(&event)) world.seats[in->station] = in->login;
  if (const auto* out = std::get_if<LoggedOut>(&event)) {
    std::erase_if(world.seats, [&](const auto& seat) { return seat.second == out->login; });
    world.locked.erase(out->login);
  }
  if (const auto* lock = std::get_if<Locked>(&event)) {
    if (lock->on)
      world.locked.insert(lock->login);
    else
      world.locked.erase(lock->login);
  }
  if (const auto* press = std::get_if<HaltPressed>(&event)) world.pressing.insert(press->person);
  if (const auto* release = std::get_if<HaltReleased>(&event)) world.pressing.erase(release->person);
  if (std::holds_alternative<HaltCleared>(event)) world.pressing.clear();
  if (const auto* sign = std::get_if<Heard>(&event); sign != nullptr && sign->login == world.authority.holder())
    world.is_console_behind = sign->is_console_behind;
}

/// What channel and controls make of the actions.
void carry_out(World& world, const Actions& actions) {
  for (const Action& action : actions) {
    if (const auto* grant = std::get_if<Grant>(&action)) {
      if (static_cast<std::uint64_t>(grant->epoch) > world.newest_lease) world.is_console_behind = false;
      world.newest_lease = std::max(world.newest_lease, static_cast<std::uint64_t>(grant->epoch));
      world.is_honoured = true;
    }
    if (std::holds_alternative<Revoke>(action)) world.is_honoured = false;
    if (const auto* connect = std::get_if<Connect>(&action))
      world.connected = connect->to_lab_machine ? connect->login : kNoLogin;
    if (const auto* latch = std::get_if<Latch>(&action)) world.is_latched = latch->on;
    if (const auto* power = std::get_if<SwitchPower>(&action)) world.has_power = power->on;
  }
}

/// Invariants of a step; the first one broken, empty if none.
std::string broken_by_step(const Step& step) {
  const Authority& was = step.before.authority;
  const Authority& is = step.after.authority;
  if (const auto* grant = first_of<Grant>(step.actions)) {
    const bool is_new =
        static_cast<std::uint64_t>(grant->epoch) != step.before.newest_lease || !step.before.is_honoured;
    if (is_new && static_cast<std::uint64_t>(grant->epoch) <= step.before.newest_lease)
      return "AUTH-002 a lease number that does not grow";
    if (is_new && step.was_moving) return "AUTH-004 a new lease while the machine moves";
    const auto* accept = std::get_if<Accept>(&step.event);
    if (is_new && (accept == nullptr || accept->login != was.asked()))
      return "AUTH-005 granted without START of the one who was asked";
  }
  const auto* select = std::get_if<Select>(&step.event);
  const auto* release = std::get_if<ReleaseIt>(&step.event);
  const bool forced = (select != nullptr && select->force) || (release != nullptr && release->force);
  if ((select != nullptr || release != nullptr) && step.was_moving && !forced && was.holder() != is.holder())
    return "AUTH-004 the selector moved while the machine moves";
  if (std::holds_alternative<HaltPressed>(step.event) && first_of<Latch>(step.actions) == nullptr)
    return "AUTH-006 a halt that does not reach the channel";
  if (const auto* decline = std::get_if<Decline>(&step.event);
      decline != nullptr && decline->login == was.asked() && was.asked() != kNoLogin && is.asked() == decline->login)
    return "AUTH-005 STOP did not decline";
  if (const auto* power = std::get_if<PowerSwitched>(&step.event);
      power != nullptr && step.after.has_power != power->on)
    return "AUTH-010 the power switch did nothing";
  if (const auto* loss = std::get_if<Deprived>(&step.event);
      loss != nullptr && loss->login != kNoLogin && loss->login == is.holder())
    return "AUTH-016 the typing console is lost and the lease lives on";
  if (was.phase() != is.phase() && was.phase() != Phase::stopping && first_of<Journal>(step.actions) == nullptr)
    return "AUTH-015 a change that is not in the journal";
  return {};
}

/// Invariants of a state.
std::string broken_in(const World& world) {
  const Authority& is = world.authority;
  if ((is.selected() != 0) != (is.phase() == Phase::granted)) return "AUTH-001 selected without a lease";
  if (is.phase() == Phase::granted && !world.is_honoured) return "AUTH-001 a lease that the channel does not honour";
  if (is.phase() != Phase::granted && world.is_honoured) return "AUTH-002 the channel honours a lease that has ended";
  if (is.phase() == Phase::granted && world.connected != is.holder())
    return "AUTH-003 the holder's control is not connected";
  const bool is_free = is.phase() == Phase::nobody || is.phase() == Phase::offered;
  if (is_free && world.connected != kNoLogin) return "AUTH-003 a control without a lease is connected";
  if (is.holder() != kNoLogin && !is_seated(world, is.holder())) return "AUTH-002 somebody who left holds the lease";
  if (is.asked() != kNoLogin && !is_seated(world, is.asked())) return "AUTH-002 somebody who left is asked";
  if (world.is_latched != is.is_halted()) return "AUTH-006 the latch and the halt differ";
  if (!world.is_latched && !world.pressing.empty()) return "AUTH-006 a halt released by somebody else";
  if (world.is_latched && world.pressing.empty()) return "AUTH-006 a halt that nobody presses any more";
  if (!std::ranges::all_of(world.pressing, [&](db::PersonId person) { return is.holds_halt(person); }))
    return "AUTH-006 somebody who presses is not named";
  if (world.locked.contains(is.holder()) || world.locked.contains(is.asked()))
    return "AUTH-016 a locked keyboard has the machine or is asked";
  return {};
}

constexpr db::PersonId kInstructor{1};

/// Everything that three stations, each with two logins one after the other, and an instructor can do. Locks, losses
/// of consoles and the power switch are one station's: the others' would only repeat it. MASCHINE HALT belongs to
/// people, not to logins: two students press it, from wherever, and the instructor.
std::vector<Happening> all_happenings() {
  std::vector<Happening> all{Event{Polled{}},
                             Event{ReleaseIt{}},
                             Event{ReleaseIt{true}},
                             Event{HaltCleared{"i"}},
                             Event{PowerSwitched{false}},
                             Event{PowerSwitched{true}},
                             Crashed{}};
  for (int station = 1; station <= 3; ++station) {
    all.insert(all.end(), {Event{Select{station}}, Event{Select{station, true}}});
    for (const int generation : {1, 2}) {
      const LoginId login{static_cast<std::uint64_t>(generation * 10 + station)};
      for (const Event& event :
           std::initializer_list<Event>{LoggedIn{station, login}, LoggedOut{login, "cut"}, Accept{login},
                                        Decline{login}, Heard{login, 1}, Heard{login, 1, true}})
        all.emplace_back(event);
    }
  }
  for (const db::PersonId person : {kInstructor, db::PersonId{2}, db::PersonId{3}})
    all.insert(all.end(), {Event{HaltPressed{person, "p"}}, Event{HaltReleased{person}}});
  for (const std::uint64_t login : {11U, 21U})
    for (const Event& event : std::initializer_list<Event>{Locked{LoginId{login}, true}, Locked{LoginId{login}, false},
                                                           Deprived{LoginId{login}, "console lost"}})
      all.emplace_back(event);
  return all;
}

/// A login that has ended never begins again, and there is one at a time at each seat.
bool can_happen(const World& world, const Event& event) {
  const auto* in = std::get_if<LoggedIn>(&event);
  if (in == nullptr) return true;
  const auto seat = world.seats.find(in->station);
  return seat == world.seats.end() || seat->second <= in->login;
}

/// What decides the future of a state, but for lease numbers, which only grow; whether the authority has forgotten any
/// of them is part of it.
std::string name_of_world(const World& world) {
  const Authority& is = world.authority;
  std::string key;
  const auto number = [](auto value) { return std::to_string(static_cast<std::uint64_t>(value)) + ","; };
  for (const auto& [station, login] : world.seats) key += number(login);
  key += "l";
  for (const LoginId login : world.locked) key += number(login);
  key += "h";
  for (const db::PersonId person : world.pressing) key += number(person);
  return key + "p" + number(is.phase()) + number(is.holder()) + number(is.asked()) + number(is.next_station()) +
         number(world.connected) + number(world.is_honoured) + number(world.is_console_behind) +
         number(is.is_halted()) + number(is.is_powered()) +
         number(static_cast<std::uint64_t>(is.newest()) < world.newest_lease);
}

struct Walk {
  const Mutation& mutation;
  WalkResult result;

  Actions apply(World& world, Event event, MachineView machine, std::int64_t now_ns) const {
    if (mutation.event && !mutation.event(event, world.authority)) return {};
    if (mutation.machine) mutation.machine(machine);
    Actions actions = world.authority.apply(event, machine, now_ns);
    if (mutation.drops) std::erase_if(actions, mutation.drops);
    return actions;
  }

  /// After a long silence nothing is left of an offer or a lease (the state itself is thrown away).
  [[nodiscard]] std::string broken_after_silence(World world) const {
    const auto poll = [&](std::int64_t now_ns) {
      Actions actions = apply(world, Polled{}, {.moving = true}, now_ns);
      carry_out(world, actions);
      return actions;
    };
    const LoginId holder = world.authority.holder();
    const Actions silence = poll(kAfterLease_ns);
    if (world.authority.phase() == Phase::granted) return "AUTH-007 a lease outlives silence";
    const auto* back = first_of<GiveKeysBack>(silence);
    const bool is_owed = holder != kNoLogin && world.is_console_behind;
    if (is_owed != (back != nullptr) || (is_owed && back->login != holder))
      return "AUTH-016 the keys are where a silent console, or nobody, has them";
    poll(kAfterOffer_ns);
    if (world.authority.phase() == Phase::offered) return "AUTH-005 an offer outlives its 30 s";
    return {};
  }

  std::string crash(World& world) const {
    const Authority& before = world.authority;
    const std::uint64_t newest_lease = world.newest_lease;
    Authority after = mutation.crash ? mutation.crash(before) : Authority{{}, before.newest()};
    world = World{};
    world.authority = std::move(after);
    world.newest_lease = newest_lease;  // what was granted before must never be granted again
    const bool is_free = world.authority.phase() == Phase::nobody && world.authority.selected() == 0;
    return is_free ? std::string() : "AUTH-012 somebody has control after a restart";
  }

  std::string happen(const World& before, World& after, const Happening& happening, bool moving) const {
    if (std::holds_alternative<Crashed>(happening)) return crash(after);
    const Event& event = std::get<Event>(happening);
    const Actions actions = apply(after, event, MachineView{.moving = moving}, 0);
    follow(after, event);
    carry_out(after, actions);
    if (std::string broken = broken_by_step({before, after, event, moving, actions}); !broken.empty()) return broken;
    if (std::string broken = broken_in(after); !broken.empty()) return broken;
    return broken_after_silence(after);
  }
};

}  // namespace

WalkResult walk(const Mutation& mutation) {
  const std::vector<Happening> all = all_happenings();
  Walk walk{mutation, {}};
  std::deque<World> open{World{}};
  std::set<std::string> seen{name_of_world(World{})};
  while (!open.empty()) {
    const World world = std::move(open.front());
    open.pop_front();
    const Phase phase = world.authority.phase();
    for (const bool moving : {false, true}) {
      // A machine moves only under a lease that the channel honours, or while it comes to rest.
      if (moving && phase != Phase::granted && phase != Phase::stopping) continue;
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (const auto* event = std::get_if<Event>(&all[i]); event != nullptr && !can_happen(world, *event)) continue;
        World next = world;
        ++walk.result.steps;
        walk.result.broken = walk.happen(world, next, all[i], moving);
        if (!walk.result.broken.empty()) {
          walk.result.how = "happening " + std::to_string(i) + " at " + name_of_world(world);
          walk.result.states = seen.size();
          return walk.result;
        }
        if (seen.insert(name_of_world(next)).second) open.push_back(std::move(next));
      }
    }
  }
  walk.result.states = seen.size();
  return walk.result;
}

}  // namespace cnclab::lab
