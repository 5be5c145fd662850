// The commands of cnclab-instructor as subcommands of its command line, each filling a request.
#include "instructor/commands.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>

#include "instructor/command_fault.hpp"
#include "station/utf8.hpp"

namespace cnclab::instructor {
namespace {

constexpr int kLastStation = 15;
constexpr const char* kStations = "1-15";

/// Fills the request of one command when the whole line has been understood.
using Fill = std::function<void(Command&)>;

/// A text that can be sent. throws UnfitFile
std::string content_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (const auto line = station::line_not_utf8(text))
    throw UnfitFile(file + ":" + std::to_string(*line), station::kNotUtf8);
  return text;
}

std::string first_line_of(const std::string& file) {
  const std::string text = content_of(file);
  std::string line = text.substr(0, text.find('\n'));
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

const CLI::Validator& program_name() {
  static const CLI::Validator kValidator(
      [](std::string& text) { return program_number(text) ? std::string() : text + ": a program is P0000 to P9999"; },
      "P0001");
  return kValidator;
}

constexpr std::uint32_t kMachineData = 10'000;  ///< machine data among the programs, as `MD` on a tape

/// As `program_number`, and MD.
std::optional<std::uint32_t> program_or_data(const std::string& text) {
  return text == "MD" ? kMachineData : program_number(text);
}

const CLI::Validator& program_or_data_name() {
  static const CLI::Validator validator(
      [](std::string& text) {
        return program_or_data(text) ? std::string() : text + ": P0000 to P9999, or MD for the machine data";
      },
      "P0001");
  return validator;
}

/// The subcommands below one app. An argument's value lives in the command's `Fill`, which shares it.
class Table {
 public:
  Table(CLI::App& app, std::optional<Command>& command) : app_(app), command_(command) {}

  CLI::App& add(const std::string& name, const std::string& description, Fill fill) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->fallthrough();
    sub->callback([&command = command_, fill = std::move(fill)] { fill(command.emplace()); });
    return *sub;
  }

  Table group(const std::string& name, const std::string& description) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->fallthrough();
    sub->require_subcommand(1);
    return {*sub, command_};
  }

 private:
  CLI::App& app_;
  std::optional<Command>& command_;
};

template <class T>
std::shared_ptr<T> value(T initial = {}) {
  return std::make_shared<T>(std::move(initial));
}

/// A word that the command needs. `kind` stands for it in the usage: a range, a choice, or an example.
template <class T>
CLI::Option* needed(CLI::App& sub, const std::string& name, const std::shared_ptr<T>& into, const std::string& what,
                    const std::string& kind) {
  return sub.add_option(name, *into, what)->required()->type_name(kind);
}

void add_station_command(Table& table, const std::string& name, const std::string& description,
                         const std::function<void(v1::InstructorRequest&, std::uint32_t)>& fill) {
  const auto station = value<std::uint32_t>();
  auto& sub = table.add(name, description, [=](Command& command) { fill(command.request, *station); });
  needed(sub, "station", station, "1 to 15", kStations)->check(CLI::Range(1, kLastStation));
}

void add_selector(Table& table) {
  table.add("status", "everything at a glance", [](Command& c) { c.request.mutable_status(); });
  const auto station = value<std::uint32_t>();
  const auto force = value(false);
  auto& select = table.add("select", "offers the machine to a station", [=](Command& c) {
    c.request.mutable_select()->set_station(*station);
    c.request.mutable_select()->set_force(*force);
  });
  needed(select, "station", station, "1 to 15", kStations)->check(CLI::Range(1, kLastStation));
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

void add_switches(Table& table) {
  const CLI::IsMember on_or_off({"on", "off"});
  const auto number = value<std::uint32_t>();
  const auto state = value<std::string>();
  auto& input = table.add("input", "switches a simulated input", [=](Command& c) {
    c.request.mutable_input()->set_input(*number);
    c.request.mutable_input()->set_on(*state == "on");
  });
  needed(input, "number", number, "0 Input 1, 11 to 18 card 1, 21 to 28 card 2", "0|11-18|21-28")
      ->check(CLI::IsMember({0U, 11U, 12U, 13U, 14U, 15U, 16U, 17U, 18U, 21U, 22U, 23U, 24U, 25U, 26U, 27U, 28U}));
  needed(input, "state", state, "on or off", "on|off")->check(on_or_off);
  const auto station = value<std::uint32_t>();
  const auto remote_state = value<std::string>();
  auto& remote = table.add("remote", "REMOTE switch of a station", [=](Command& c) {
    c.request.mutable_remote()->set_station(*station);
    c.request.mutable_remote()->set_on(*remote_state == "on");
  });
  needed(remote, "station", station, "1 to 15", kStations)->check(CLI::Range(1, kLastStation));
  needed(remote, "state", remote_state, "on or off", "on|off")->check(on_or_off);
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

void add_machine(Table& table) {
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
    c.request.mutable_tools()->set_tape(file->empty() ? "" : content_of(*file));
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
  workpiece.add_option("size", *size, "X Y Z in mm")->type_name("X Y Z")->expected(3)->check(CLI::PositiveNumber);
}

void add_classroom(Table& table) {
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

void add_student_add(Table& student) {
  const auto name = value<std::string>();
  const auto file = value<std::string>();
  const auto must_change = value(false);
  const auto role = value<std::string>("student");
  const auto language = value<std::string>();
  auto& add = student.add("add", "adds somebody; without a file prints a one-time password", [=](Command& c) {
    auto* request = c.request.mutable_student_add();
    request->set_name(*name);
    if (!file->empty()) request->set_password(first_line_of(*file));
    request->set_must_change(*must_change);
    request->set_role(*role);
    request->set_language(*language);
  });
  needed(add, "name", name, "login name", "NAME");
  add.add_option("--password-file", *file, "password in the first line")->type_name("FILE")->check(CLI::ExistingFile);
  add.add_flag("--must-change", *must_change, "to be changed at the first login");
  add.add_option("--role", *role, "role")
      ->type_name("student|observer|instructor")
      ->check(CLI::IsMember({"student", "observer", "instructor"}));
  add.add_option("--language", *language, "language")->type_name("de|en")->check(CLI::IsMember({"de", "en"}));
}

void add_student_set(Table& student) {
  const auto name = value<std::string>();
  const auto model = value<std::string>();
  const auto language = value<std::string>();
  auto& set =
      student.add("set", "sets model and language from the next log-in on; lab: as the lab has them", [=](Command& c) {
        auto* request = c.request.mutable_student_set();
        request->set_name(*name);
        request->set_model(*model);
        request->set_language(*language);
      });
  needed(set, "name", name, "login name", "NAME");
  set.add_option("--model", *model, "model of the control")
      ->type_name("3300|3250|lab")
      ->check(CLI::IsMember({"3300", "3250", "lab"}));
  set.add_option("--language", *language, "language")
      ->type_name("de|en|lab")
      ->check(CLI::IsMember({"de", "en", "lab"}));
  set.require_option(2, 0);  // the name and at least one of them
}

void add_roster(Table& table) {
  table.add("passwd", "changes the own password; the new one from --new-password-file",
            [](Command& c) { c.changes_own_password = true; });
  table.add("students", "everybody on the roster", [](Command& c) { c.request.mutable_students(); });
  Table student = table.group("student", "changes the roster");
  add_student_add(student);
  add_student_set(student);
  const auto removed = value<std::string>();
  const auto erase = value(false);
  auto& remove = student.add("remove", "archives somebody for 30 days", [=](Command& c) {
    c.request.mutable_student_remove()->set_name(*removed);
    c.request.mutable_student_remove()->set_erase(*erase);
  });
  needed(remove, "name", removed, "login name", "NAME");
  remove.add_flag("--erase", *erase, "deletes for good, programs too");
  const auto restored = value<std::string>();
  auto& restore = student.add("restore", "brings an archived one back",
                              [=](Command& c) { c.request.mutable_student_restore()->set_name(*restored); });
  needed(restore, "name", restored, "login name", "NAME");
  const auto from = value<std::string>();
  const auto to = value<std::string>();
  auto& rename = student.add("rename", "gives another name", [=](Command& c) {
    c.request.mutable_student_rename()->set_name(*from);
    c.request.mutable_student_rename()->set_new_name(*to);
  });
  needed(rename, "name", from, "login name", "NAME");
  needed(rename, "new_name", to, "new login name", "NAME");
  const auto forgetful = value<std::string>();
  auto& password = student.add("password", "prints a new one-time password",
                               [=](Command& c) { c.request.mutable_student_password()->set_name(*forgetful); });
  needed(password, "name", forgetful, "login name", "NAME");
}

void add_roster_files(Table& table) {
  const auto roster = value<std::string>();
  auto& import = table.add("import", "adds everybody of a list, or nobody",
                           [=](Command& c) { c.request.mutable_import()->set_csv(content_of(*roster)); });
  needed(import, "file", roster, "CSV with name,password,language", "FILE")->check(CLI::ExistingFile);
  const auto target = value<std::string>();
  auto& exported = table.add("export", "writes the roster", [=](Command& c) {
    c.request.mutable_export_();
    c.content_file = *target;
  });
  needed(exported, "file", target, "CSV to write", "FILE");
  const auto copy = value<std::string>();
  auto& backup = table.add("backup", "a consistent copy of the database", [=](Command& c) {
    c.request.mutable_backup();
    c.content_file = *copy;
  });
  needed(backup, "file", copy, "file to write", "FILE");
}

void add_program_choice(CLI::App& sub, const std::shared_ptr<std::string>& student,
                        const std::shared_ptr<std::string>& program) {
  needed(sub, "name", student, "student", "NAME");
  needed(sub, "program", program, "P0001, or MD: the machine data", "P0001|MD")->check(program_or_data_name());
}

void add_program_copies(Table& program) {
  const auto tape = value<std::string>();
  const auto names = value<std::vector<std::string>>();
  const auto all = value(false);
  const auto replace = value(false);
  auto& send = program.add("send", "copies the programs of a tape file to students", [=](Command& c) {
    auto* request = c.request.mutable_program_send();
    request->set_tape(content_of(*tape));
    for (const auto& name : *names) request->add_students(name);
    request->set_all(*all);
    request->set_replace(*replace);
  });
  needed(send, "file", tape, "tape text", "FILE")->check(CLI::ExistingFile);
  auto* to_all = send.add_flag("--all", *all, "to every student");
  send.add_option("names", *names, "students")->type_name("NAME")->excludes(to_all);
  send.add_flag("--replace", *replace, "also where a program of that number exists");
  const auto folder = value<std::string>();
  const auto wanted = value<std::string>();
  auto& collect =
      program.add("collect", "collects everybody's programs into a folder, NAME.tape each", [=](Command& c) {
        c.request.mutable_program_collect()->set_program(program_number(*wanted).value_or(0));
        c.request.mutable_program_collect()->set_only_that(!wanted->empty());
        c.content_file = std::filesystem::path(*folder) / ".cnclab-collected";
        c.is_collection = true;
      });
  needed(collect, "folder", folder, "folder to write into", "FOLDER")->check(CLI::ExistingDirectory);
  collect.add_option("program", *wanted, "only this one")->type_name("P0001")->check(program_name());
}

void add_programs(Table& table) {
  const auto owner = value<std::string>();
  auto& programs = table.add("programs", "a student's programs",
                             [=](Command& c) { c.request.mutable_programs()->set_name(*owner); });
  needed(programs, "name", owner, "student", "NAME");
  Table program = table.group("program", "looks at and copies programs");
  add_program_copies(program);
  using Choose = std::function<v1::ProgramName*(v1::InstructorRequest&)>;
  const auto add = [&](const std::string& name, const std::string& description, const Choose& choose) {
    const auto student = value<std::string>();
    const auto number = value<std::string>();
    const auto version = value<std::uint32_t>();
    auto& sub = program.add(name, description, [=](Command& c) {
      auto* chosen = choose(c.request);
      chosen->set_student(*student);
      chosen->set_program(program_or_data(*number).value_or(0));
      chosen->set_version(*version);
    });
    add_program_choice(sub, student, number);
    return std::pair(&sub, version);
  };
  const auto [show, shown_version] = add("show", "the tape text", [](auto& r) { return r.mutable_program_show(); });
  show->add_option("--version", *shown_version, "an older version")->type_name("K");
  add("versions", "all versions", [](auto& r) { return r.mutable_program_versions(); });
  const auto [restore, restored_version] =
      add("restore", "makes an older version the newest", [](auto& r) { return r.mutable_program_restore(); });
  needed(*restore, "version", restored_version, "number of the version", "VERSION");
}

void add_records(Table& table) {
  const auto runner = value<std::string>();
  auto& runs =
      table.add("runs", "a student's recorded runs", [=](Command& c) { c.request.mutable_runs()->set_name(*runner); });
  needed(runs, "name", runner, "student", "NAME");
  Table run = table.group("run", "looks at a recorded run");
  const auto traced = value<std::uint32_t>();
  const auto file = value<std::string>();
  auto& trace = run.add("trace", "writes the path of a run as CSV, one row per tick", [=](Command& c) {
    c.request.mutable_run_trace()->set_run(*traced);
    c.content_file = *file;
  });
  needed(trace, "id", traced, "number of the run, see runs", "ID");
  needed(trace, "file", file, "CSV to write", "FILE");
  const auto replayed = value<std::uint32_t>();
  auto& replay = run.add("replay", "runs it again and compares",
                         [=](Command& c) { c.request.mutable_run_replay()->set_run(*replayed); });
  needed(replay, "id", replayed, "number of the run, see runs", "ID");
  const auto student = value<std::string>();
  const auto since = value<std::string>();
  auto& journal = table.add("journal", "what a student did and what happened", [=](Command& c) {
    c.request.mutable_journal()->set_student(*student);
    c.request.mutable_journal()->set_since(*since);
  });
  needed(journal, "name", student, "student", "NAME");
  journal.add_option("--since", *since, "local time, e.g. 2026-01-31T08:00")->type_name("TIME");
}

}  // namespace

void add_commands(CLI::App& app, std::optional<Command>& command) {
  app.require_subcommand(0, 1);
  Table table(app, command);
  add_selector(table);
  add_switches(table);
  add_machine(table);
  add_classroom(table);
  add_roster(table);
  add_roster_files(table);
  add_programs(table);
  add_records(table);
}

}  // namespace cnclab::instructor
