// `cnclab-tool check`: nothing and 0, or every error.
#include <algorithm>
#include <set>

#include "program/check_programs.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

/// A dry run of a program that loops ends here; by then every block within reach has run.
constexpr std::uint64_t kDryRunBlocks = 200'000;

bool names_missing_target(const language::Error& error) {
  return error.code == language::ErrorCode::program_missing || error.code == language::ErrorCode::block_missing;
}

/// Where somebody would press START.
std::vector<program::Start> starts_of(const Job& job, const Options& options) {
  if (options.program || options.block) return {job.start};
  std::vector<program::Start> starts;
  for (const std::uint16_t number : program::start_programs(job.programs))
    starts.push_back({.program = number, .block = job.programs.find(number)->blocks.front().number});
  return starts;
}

std::vector<language::Error> errors_of(const Job& job, const Options& options) {
  std::vector<language::Error> errors = program::check_blocks(job.programs, job.settings);
  if (!job.tape_errors.empty()) {
    // Programs that could not be read are not missing, and nothing can be executed without them.
    std::erase_if(errors, names_missing_target);
    errors.insert(errors.begin(), job.tape_errors.begin(), job.tape_errors.end());
    return errors;
  }
  std::set<std::pair<std::uint16_t, std::uint16_t>> known;
  for (const language::Error& error : errors) known.emplace(error.program, error.block);
  for (const program::Start& start : starts_of(job, options)) {
    for (language::Error& error : program::dry_run(job.programs, job.settings, start, kDryRunBlocks))
      if (known.emplace(error.program, error.block).second) errors.push_back(std::move(error));
  }
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
