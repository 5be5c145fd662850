// `cnclab-tool check`: nothing and 0, or every error.
#include <algorithm>
#include <set>
#include <tuple>

#include "program/check_programs.hpp"
#include "program/reachable.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

/// A dry run of a program that loops ends here; by then every block within reach has run.
constexpr std::uint64_t kDryRunBlocks = 200'000;

/// Nobody knows what a program begins with whose number cannot be read.
bool hides_a_program(const language::Error& error) { return error.program == 0 && !error.in_tool_table; }

/// The program at which a jump or call of the block aims.
std::uint16_t target_of(const Job& job, const language::Error& error) {
  const language::Program* program = job.programs.find(error.program);
  const auto index = program == nullptr ? std::nullopt : program->find(error.block);
  if (!index) return error.program;
  const language::Word* word = program->blocks[*index].find(language::Address::P);
  return word == nullptr ? error.program : static_cast<std::uint16_t>(word->number);
}

/// What is missing may be among what could not be read.
bool may_be_unread(const Job& job, const language::Error& error) {
  if (error.code == language::ErrorCode::program_missing) return std::ranges::any_of(job.tape_errors, hides_a_program);
  return error.code == language::ErrorCode::block_missing && job.partly_read.contains(target_of(job, error));
}

/// A program of which blocks are missing would show faults that it does not have.
bool is_executable(const Job& job, const program::Start& start) {
  if (job.partly_read.empty()) return true;
  bool is_whole = !job.partly_read.contains(start.program) && !job.partly_read.contains(language::kToolTable);
  program::walk_reachable(job.programs, start.program, start.block,
                          [&](geometry::SourceBlock source, const language::Block& block) {
                            const language::Word* target = block.find(language::Address::P);
                            const int number = target == nullptr ? source.program : static_cast<int>(target->number);
                            is_whole = is_whole && !job.partly_read.contains(static_cast<std::uint16_t>(number));
                            return is_whole;
                          });
  return is_whole;
}

/// Where somebody would press START.
std::vector<program::Start> starts_of(const Job& job, const Options& options) {
  if (options.program || options.block) return {job.start};
  std::vector<program::Start> starts;
  for (const std::uint16_t number : program::start_programs(job.programs))
    starts.push_back({.program = number, .block = job.programs.find(number)->blocks.front().number});
  return starts;
}

/// In the order of the file.
void sort(std::vector<language::Error>& errors, const Job& job) {
  const auto place = [&](const language::Error& error) {
    const int line = error.line != 0 ? error.line : job.line_of(error.program, error.block);
    return std::tuple(line, error.program, error.block);
  };
  std::ranges::stable_sort(errors, {}, place);
}

std::vector<language::Error> errors_of(const Job& job, const Options& options) {
  std::vector<language::Error> errors = program::check_blocks(job.programs, job.settings);
  std::erase_if(errors, [&](const language::Error& error) { return may_be_unread(job, error); });
  std::set<std::pair<std::uint16_t, std::uint16_t>> known;
  for (const language::Error& error : errors) known.emplace(error.program, error.block);
  for (const program::Start& start : starts_of(job, options)) {
    if (!is_executable(job, start)) continue;
    for (language::Error& error : program::dry_run(job.programs, job.settings, start, kDryRunBlocks))
      if (known.emplace(error.program, error.block).second) errors.push_back(std::move(error));
  }
  errors.insert(errors.begin(), job.tape_errors.begin(), job.tape_errors.end());
  sort(errors, job);
  return errors;
}

}  // namespace

int check(const Options& options) {
  const auto job = open_job(options);
  if (!job) return kExitError;
  const std::vector<language::Error> errors = errors_of(*job, options);
  for (const language::Error& error : errors) job->print(error);
  for (const std::string& notice : job->notices) print_problem(job->file, notice);
  return errors.empty() ? 0 : kExitError;
}

}  // namespace cnclab::tool
