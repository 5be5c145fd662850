// Students' programs, runs and journal.
#include "instructor/command_table.hpp"

namespace cnclab::instructor {
namespace {

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
  static const CLI::Validator kValidator(
      [](std::string& text) {
        return program_or_data(text) ? std::string() : text + ": P0000 to P9999, or MD for the machine data";
      },
      "P0001");
  return kValidator;
}

void add_program_choice(CLI::App& sub, const std::shared_ptr<std::string>& student,
                        const std::shared_ptr<std::string>& program) {
  needed(sub, "name", student, "student", "NAME");
  needed(sub, "program", program, "P0001, or MD: the machine data", "P0001|MD")->check(program_or_data_name());
}

void add_program_copies(CommandTable& program) {
  const auto tape = value<std::string>();
  const auto names = value<std::vector<std::string>>();
  const auto all = value(false);
  const auto replace = value(false);
  auto& send = program.add("send", "copies the programs of a tape file to students", [=](Command& c) {
    auto* request = c.request.mutable_program_send();
    request->set_tape(content_of(*tape));
    c.sent_file = *tape;
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

void add_programs(CommandTable& table) {
  const auto owner = value<std::string>();
  auto& programs = table.add("programs", "a student's programs",
                             [=](Command& c) { c.request.mutable_programs()->set_name(*owner); });
  needed(programs, "name", owner, "student", "NAME");
  CommandTable program = table.group("program", "looks at and copies programs");
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

void add_records(CommandTable& table) {
  const auto runner = value<std::string>();
  auto& runs =
      table.add("runs", "a student's recorded runs", [=](Command& c) { c.request.mutable_runs()->set_name(*runner); });
  needed(runs, "name", runner, "student", "NAME");
  CommandTable run = table.group("run", "looks at a recorded run");
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

void add_program_commands(CommandTable& table) {
  add_programs(table);
  add_records(table);
}

}  // namespace cnclab::instructor
