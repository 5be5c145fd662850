// Feeds the lab what clients might send once they are logged in: any messages, in any order, as a student, another
// student, an instructor and an observer. Nothing but their own connections may end by it (SEC-004, SEC-006).
//
// Each input is a script of steps: who does what. The lab lives on from one input to the next, as a real one does; the
// people are put back on the roster in between.
#include <fuzzer/FuzzedDataProvider.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cstdlib>

#include "../lab/small_lab.hpp"
#include "random_message.hpp"

namespace lab = cnclab::lab;
namespace db = cnclab::db;
namespace v1 = cnclab::v1;

namespace {

struct Role {
  const char* name;
  const char* role;
  v1::ClientKind kind;
  std::uint32_t station;
};
constexpr std::array<Role, 4> kRoles{{{"eva", "student", v1::CLIENT_KIND_STATION, 1},
                                      {"udo", "student", v1::CLIENT_KIND_STATION, 2},
                                      {"lehrer", "instructor", v1::CLIENT_KIND_INSTRUCTOR, 0},
                                      {"gast", "observer", v1::CLIENT_KIND_OBSERVER, 1}}};

class Playground {
 public:
  Playground() {
    spdlog::set_level(spdlog::level::off);
    restore_people();
  }

  void play(FuzzedDataProvider& input) {
    constexpr std::int64_t kLongestDelay_ms = 31'000;  // wrong passwords of the input before are forgiven
    room_.advance_ms(kLongestDelay_ms);
    for (std::size_t i = 0; i < kRoles.size(); ++i) enter(i);
    constexpr int kMostSteps = 100;
    for (int step = 0; step < kMostSteps && input.remaining_bytes() > 0; ++step) do_step(input);
    for (auto& caller : callers_) leave(caller);
    room_.poll();
    restore_people();
  }

 private:
  static lab::Configuration configuration() {
    lab::Configuration configuration;
    configuration.keep_minutes = 0;
    return configuration;
  }

  void enter(std::size_t who) {
    const Role& role = kRoles[who];
    callers_[who] = room_.call(role.kind);
    room_.log_in(callers_[who], role.name, role.station);
  }
  void leave(const lab::Caller& caller) {
    if (caller.visit) room_.lab().lost(caller.visit);
  }

  void do_step(FuzzedDataProvider& input) {
    const auto who = input.ConsumeIntegralInRange<std::size_t>(0, kRoles.size() - 1);
    lab::Caller& caller = callers_[who];
    v1::ClientMessage message;
    switch (input.ConsumeIntegralInRange<int>(0, 9)) {
      case 0:
        if (message.ParseFromString(input.ConsumeRandomLengthString(400))) room_.lab().receive(caller.visit, message);
        break;
      case 1:
        if (message.mutable_request()->ParseFromString(input.ConsumeRandomLengthString(400)))
          room_.lab().receive(caller.visit, message);
        break;
      case 2:
      case 3:
        room_.strike(caller, static_cast<cnclab::Key>(input.ConsumeIntegralInRange(1, cnclab::kKeys)));
        break;
      case 4:
        message.mutable_potentiometer()->set_number(++caller.number);
        message.mutable_potentiometer()->set_percent(input.ConsumeIntegralInRange<std::uint32_t>(0, 100));
        room_.lab().receive(caller.visit, message);
        break;
      case 5:
        room_.advance_ms(input.ConsumeIntegralInRange(0, 2000));
        room_.poll();
        break;
      case 6:
        room_.look(caller);
        room_.with_database([](db::Database&) {});  // what was asked of the store is answered
        break;
      case 7:
        cnclab::fill(message, input);
        if (message.has_key()) message.mutable_key()->set_number(++caller.number);  // else it ends the connection
        room_.lab().receive(caller.visit, message);
        break;
      case 8:
        cnclab::fill(*message.mutable_request(), input);
        room_.lab().receive(caller.visit, message);
        break;
      case 9:
        leave(caller);
        room_.poll();
        enter(who);
        break;
    }
  }

  void restore_people() {
    room_.with_database([](db::Database& database) {
      for (const Role& role : kRoles) {
        if (const auto old = database.person(role.name); old && (old->role != role.role || old->archived_ms))
          database.erase(old->id);
        db::Person person;
        person.name = role.name;
        person.role = role.role;
        person.password_hash = lab::SmallLab::password_hash();
        if (const auto known = database.person(role.name))
          database.set_password(known->id, person.password_hash, false);
        else
          database.add_person(person, 1);
      }
    });
  }

  lab::SmallLab room_{configuration()};
  std::array<lab::Caller, kRoles.size()> callers_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static auto* const playground = new Playground;  // lives as long as the process: its threads are in use at the end
  FuzzedDataProvider input(data, size);
  playground->play(input);
  return 0;
}
