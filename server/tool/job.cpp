// Puts together what a command works on.
#include "tool/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "language/program_text.hpp"
#include "program/rebuild_modal.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

program::Settings settings_of(const machine::MachineData& data) {
  program::Settings settings;
  settings.f_max_mm_per_min = static_cast<double>(data.get(6));
  settings.s_max_rpm = static_cast<double>(data.get(7));
  for (std::size_t axis = 0; axis < settings.travel_mm.size(); ++axis)
    settings.travel_mm[axis] = static_cast<double>(data.get(static_cast<int>(axis) + 3)) / 1000;
  for (std::size_t axis = 0; axis < settings.steps_per_mm.size(); ++axis)
    settings.steps_per_mm[axis] = static_cast<double>(data.get(static_cast<int>(axis) + 14));
  return settings;
}

language::Reading reading_of(const Options& options) {
  return options.is_strict ? language::Reading::strict : language::Reading::file;
}

bool read_programs(const Options& options, Job& job) {
  if (!options.dialect.empty() && options.dialect != "cnc3300") {
    print_problem(options.file,
                  say(options.tongue, "diese Version liest nur den Dialekt cnc3300, nicht " + options.dialect + ".",
                      "this version reads the dialect cnc3300 only, not " + options.dialect + "."));
    return false;
  }
  const auto text =
      options.is_strict ? read_file(options.file, options.tongue) : read_text_file(options.file, options.tongue);
  if (!text) {
    print_problem(options.file, text.error());
    return false;
  }
  language::Tape tape = language::read_programs_text(*text, reading_of(options), options.tongue);
  if (tape.programs.empty() && tape.machine_data.empty() && tape.errors.empty() && tape.notices.empty()) {
    print_problem(options.file, say(options.tongue, "enthält kein Programm. Erwartet wird z. B. P0001N001G00X+1000%.",
                                    "holds no program. Expected is e.g. P0001N001G00X+1000%."));
    return false;
  }
  job.tape_errors = std::move(tape.errors);
  job.notices = std::move(tape.notices);
  job.recorded_data = std::move(tape.machine_data);
  for (language::ReadProgram& read : tape.programs) {
    const std::uint16_t number = read.program.number;
    job.in_file_order.push_back(number);
    job.lines[number] = std::move(read.lines);
    job.programs.put(std::move(read.program));
  }
  for (language::ReadProgram& read : tape.faulty_programs) {
    const std::uint16_t number = read.program.number;
    job.partly_read.insert(number);
    if (job.programs.find(number) != nullptr) continue;  // the file has another one of that number, which counts
    job.lines[number] = std::move(read.lines);
    job.programs.put(std::move(read.program));
  }
  return true;
}

bool read_tools(const Options& options, Job& job) {
  if (options.tools_file.empty()) return true;
  const auto text = read_text_file(options.tools_file, options.tongue);
  if (!text) {
    print_problem(options.tools_file, text.error());
    return false;
  }
  language::Tape tape = language::read_programs_text(*text, reading_of(options), options.tongue);
  Job tools_job;
  tools_job.file = options.tools_file;
  tools_job.tongue = options.tongue;
  for (const language::Error& error : tape.errors) tools_job.print(error);
  if (!tape.errors.empty()) return false;
  for (language::ReadProgram& read : tape.programs) {
    if (read.program.number != language::kToolTable) continue;
    job.tools_file = options.tools_file;
    job.lines[language::kToolTable] = std::move(read.lines);  // the table of FILE counts no more, nor do its lines
    job.programs.put(std::move(read.program));
    return true;
  }
  print_problem(options.tools_file,
                say(options.tongue, "enthält keine Werkzeugtabelle P0000, z. B. P0000T001R+5000L+0.",
                    "holds no tool table P0000, e.g. P0000T001R+5000L+0."));
  return false;
}

/// Every fault of a machine-data file: each is told, and the rest read as if its line were empty.
void print_data_faults(const Options& options, std::string text) {
  std::set<int> told;
  for (auto data = machine::read_machine_data(text); !data; data = machine::read_machine_data(text)) {
    const auto& [line, reason] = data.error();
    if (!told.insert(line).second) return;
    print_problem(fmt::format("{}:{}", options.machine_data_file, line), reason);
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i) begin = text.find('\n', begin) + 1;
    text.erase(begin, std::min(text.find('\n', begin), text.size()) - begin);
  }
}

bool read_data(const Options& options, Job& job) {
  if (!options.machine_data_file.empty()) {
    const auto text = read_file(options.machine_data_file, options.tongue);
    if (!text) {
      print_problem(options.machine_data_file, text.error());
      return false;
    }
    const auto data = machine::read_machine_data(*text);
    if (!data) {
      print_data_faults(options, *text);
      return false;
    }
    job.data = *data;
  }
  job.settings = settings_of(job.data);
  return true;
}

/// A start in the middle finds the modal state that the blocks before it leave, as in AUTOMAT (DEC-26).
void choose_start(const Options& options, Job& job) {
  const auto first = std::ranges::find_if(job.in_file_order, [](int number) { return number != language::kToolTable; });
  if (first != job.in_file_order.end()) job.start.program = *first;
  if (options.program) job.start.program = *options.program;
  const language::Program* program = job.programs.find(job.start.program);
  if (program != nullptr && !program->blocks.empty()) job.start.block = program->blocks.front().number;
  if (!options.block) return;
  job.start.block = *options.block;
  if (program == nullptr) return;
  const auto modal = program::rebuild_modal(job.programs, *program, *options.block, {});
  if (modal)
    job.start.modal = *modal;
  else
    job.tape_errors.push_back(modal.error());
}

}  // namespace

/// 0 where the block does not stand in the file.
int Job::line_of(std::uint16_t number, std::uint16_t block) const {
  const auto found = lines.find(number);
  const language::Program* program = programs.find(number);
  const auto index = program == nullptr ? std::nullopt : program->find(block);
  return found != lines.end() && index && *index < found->second.size() ? found->second[*index] : 0;
}

void Job::print(language::Error error) const {
  const bool is_of_tools_file = error.line == 0 && error.in_tool_table && !tools_file.empty();
  if (error.line == 0) error.line = line_of(error.program, error.block);
  std::string text = (is_of_tools_file ? tools_file : file) + ":";
  if (error.line > 0) text += fmt::format("{}:", error.line);
  if (const std::string place = language::place_of(error); !place.empty()) text += fmt::format(" {}:", place);
  fmt::print(stderr, "{} {}\n", text, language::message_of(error, tongue));
}

std::optional<Job> open_job(const Options& options) {
  Job job;
  job.file = options.file;
  job.tongue = options.tongue;
  if (!read_programs(options, job) || !read_tools(options, job) || !read_data(options, job)) return std::nullopt;
  choose_start(options, job);
  return job;
}

std::optional<Job> open_sound_job(const Options& options) {
  auto job = open_job(options);
  if (!job) return job;
  for (const language::Error& error : job->tape_errors) job->print(error);
  for (const std::string& notice : job->notices) print_problem(job->file, notice);
  if (!job->tape_errors.empty()) return std::nullopt;
  return job;
}

}  // namespace cnclab::tool
