// The selector, the machine, the stations.
#include "instructor/command_table.hpp"

namespace cnclab::instructor {
namespace {

constexpr int kLastStation = 15;

void add_station_command(CommandTable& table, const std::string& name, const std::string& description,
                         const std::function<void(v1::InstructorRequest&, std::uint32_t)>& fill) {
  const auto station = value<std::uint32_t>();
  auto& sub = table.add(name, description, [=](Command& command) { fill(command.request, *station); });
  needed(sub, "station", station, "1 to 15", "1-15")->check(CLI::Range(1, kLastStation));
}

/// NAME N on|off
void add_station_switch(CommandTable& table, const std::string& name, const std::string& description,
                        const std::function<void(v1::InstructorRequest&, std::uint32_t, bool)>& fill) {
  const auto station = value<std::uint32_t>();
  const auto state = value<std::string>();
  auto& sub = table.add(name, description, [=](Command& command) { fill(command.request, *station, *state == "on"); });
  needed(sub, "station", station, "1 to 15", "1-15")->check(CLI::Range(1, kLastStation));
  needed(sub, "state", state, "on or off", "on|off")->check(CLI::IsMember({"on", "off"}));
}

void add_selector(CommandTable& table) {
  table.add("status", "everything at a glance", [](Command& c) { c.request.mutable_status(); });
  const auto station = value<std::uint32_t>();
  const auto force = value(false);
  auto& select = table.add("select", "offers the machine to a station", [=](Command& c) {
    c.request.mutable_select()->set_station(*station);
    c.request.mutable_select()->set_force(*force);
  });
  needed(select, "station", station, "1 to 15", "1-15")->check(CLI::Range(1, kLastStation));
  select.add_flag("--force", *force, "also while the machine moves: stops it on the ramp first");
  const auto force_release = value(false);
  auto& release = table.add("release", "takes the machine back",
                            [=](Command& c) { c.request.mutable_release()->set_force(*force_release); });
  release.add_flag("--force", *force_release, "also while the machine moves: stops it on the ramp first");
  table.add("halt", "stops the machine on the ramp; latches", [](Command& c) { c.request.mutable_halt(); });
  table.add("clear-halt", "releases the latch", [](Command& c) { c.request.mutable_clear_halt(); });
  table.add("power-off", "stops at once, drives without current", [](Command& c) { c.request.mutable_power_off(); });
  table.add("power-on", "allows motion again", [](Command& c) { c.request.mutable_power_on(); });
}

void add_switches(CommandTable& table) {
  const auto number = value<std::uint32_t>();
  const auto state = value<std::string>();
  auto& input = table.add("input", "switches a simulated input", [=](Command& c) {
    c.request.mutable_input()->set_input(*number);
    c.request.mutable_input()->set_on(*state == "on");
  });
  needed(input, "number", number, "0 Input 1, 11 to 18 card 1, 21 to 28 card 2", "0|11-18|21-28")
      ->check(CLI::IsMember({0U, 11U, 12U, 13U, 14U, 15U, 16U, 17U, 18U, 21U, 22U, 23U, 24U, 25U, 26U, 27U, 28U}));
  needed(input, "state", state, "on or off", "on|off")->check(CLI::IsMember({"on", "off"}));
  add_station_switch(table, "remote", "REMOTE switch of a station", [](auto& request, auto station, bool on) {
    request.mutable_remote()->set_station(station);
    request.mutable_remote()->set_on(on);
  });
  add_station_switch(table, "ram-fault", "a fault in the memory of the control there, for the memory test to find",
                     [](auto& request, auto station, bool on) {
                       request.mutable_ram_fault()->set_station(station);
                       request.mutable_ram_fault()->set_on(on);
                     });
}

const CLI::Validator& machine_datum() {
  static const CLI::Validator kValidator(
      [](std::string& text) {
        const auto equals = text.find('=');
        const bool is_pair = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
        const auto is_number = [](const std::string& part) {
          return part.find_first_not_of("0123456789") == std::string::npos && part.size() <= 9;
        };
        if (is_pair && is_number(text.substr(0, equals)) && is_number(text.substr(equals + 1))) return std::string();
        return text + ": NN=VALUE is needed, e.g. 06=3000";
      },
      "NN=VALUE");
  return kValidator;
}

void add_machine(CommandTable& table) {
  const auto data = value<std::vector<std::string>>();
  auto& machine_data = table.add("machine-data", "prints or changes the lab machine's data", [=](Command& c) {
    auto* change = c.request.mutable_machine_data();
    for (const auto& pair : *data) {
      auto* datum = change->add_data();
      datum->set_number(static_cast<std::uint32_t>(std::stoul(pair)));
      datum->set_value(std::stoi(pair.substr(pair.find('=') + 1)));
    }
  });
  machine_data.add_option("data", *data, "e.g. 06=3000")->type_name("06=3000")->check(machine_datum());
  const auto file = value<std::string>();
  auto& tools = table.add("tools", "prints or replaces the lab machine's tool list", [=](Command& c) {
    const std::string tape = file->empty() ? "" : content_of(*file);
    if (!file->empty() && tape.empty())
      throw CLI::ValidationError("FILE", *file + " is empty");  // would print the list
    c.request.mutable_tools()->set_tape(tape);
    c.sent_file = *file;
  });
  tools.add_option("file", *file, "a tape with program P0000")->type_name("FILE")->check(CLI::ExistingFile);
  const auto size = value<std::vector<double>>();
  auto& workpiece = table.add("workpiece", "prints or sets the workpiece's size", [=](Command& c) {
    auto* set = c.request.mutable_workpiece();
    set->set_print_only(size->empty());
    if (size->empty()) return;
    set->set_x(size->at(0));
    set->set_y(size->at(1));
    set->set_z(size->at(2));
  });
  workpiece.add_option("size", *size, "X Y Z in mm")->type_name("X Y Z")->expected(3);
}

void add_classroom(CommandTable& table) {
  const auto station = value<std::string>();
  const auto words = value<std::vector<std::string>>();
  auto& message = table.add("message", "one line on the stations' message line", [=](Command& c) {
    std::string text;
    for (const auto& word : *words) text += (text.empty() ? "" : " ") + word;
    c.request.mutable_message()->set_station(*station == "all" ? 0 : static_cast<std::uint32_t>(std::stoul(*station)));
    c.request.mutable_message()->set_text(text);
  });
  needed(message, "station", station, "1 to 15, or all", "1-15|all")
      ->check(CLI::IsMember({"all"}) | CLI::Range(1, kLastStation));
  needed(message, "text", words, "the message", "TEXT");
  const auto shown = value<std::string>();
  auto& show = table.add("show", "a station's screen on all stations", [=](Command& c) {
    c.request.mutable_show()->set_station(*shown == "off" ? 0 : static_cast<std::uint32_t>(std::stoul(*shown)));
  });
  needed(show, "station", shown, "1 to 15, or off", "1-15|off")
      ->check(CLI::IsMember({"off"}) | CLI::Range(1, kLastStation));
  using Request = v1::InstructorRequest;
  add_station_command(table, "watch", "prints a station's screen whenever it changes",
                      [](Request& r, std::uint32_t n) { r.mutable_watch()->set_station(n); });
  add_station_command(table, "take", "takes a station's keyboard over",
                      [](Request& r, std::uint32_t n) { r.mutable_take()->set_station(n); });
  add_station_command(table, "give", "gives the keyboard back",
                      [](Request& r, std::uint32_t n) { r.mutable_give()->set_station(n); });
  add_station_command(table, "lock", "locks a station's keyboard",
                      [](Request& r, std::uint32_t n) { r.mutable_lock()->set_station(n); });
  add_station_command(table, "unlock", "unlocks it",
                      [](Request& r, std::uint32_t n) { r.mutable_unlock()->set_station(n); });
  add_station_command(table, "expel", "ends a station's connection",
                      [](Request& r, std::uint32_t n) { r.mutable_expel()->set_station(n); });
}

}  // namespace

void add_machine_commands(CommandTable& table) {
  add_selector(table);
  add_switches(table);
  add_machine(table);
  add_classroom(table);
}

}  // namespace cnclab::instructor
