// `cnclab-tool path`: what the program does, one element or event per line.
#include <fmt/format.h>

#include <cstdio>

#include "geometry/path_json.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

constexpr std::size_t kWriteAt_bytes = 65'536;

bool write_out(std::string& text) {
  const bool ok = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  text.clear();
  return ok;
}

int say_write_error(const Options& options) {
  print_problem("stdout", say(options.tongue, "Schreiben nicht möglich. Platz auf dem Datenträger prüfen.",
                              "cannot write. Check the space on the medium."));
  return kExitError;
}

}  // namespace

int path(const Options& options) {
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  auto interpreter = program::Interpreter::begin(job->programs, job->settings, job->start);
  if (!interpreter) {
    job->print(interpreter.error());
    return kExitError;
  }
  std::vector<geometry::PathItem> items;
  std::string text;
  for (std::uint64_t blocks = 0; blocks < options.most_blocks && !interpreter->ended(); ++blocks) {
    items.clear();
    const auto executed = interpreter->step(items);
    if (!executed) {
      if (!write_out(text)) return say_write_error(options);
      std::fflush(stdout);
      job->print(executed.error());
      return kExitError;
    }
    for (const geometry::PathItem& item : items)
      if (geometry::append_json(text, item)) text += '\n';
    if (text.size() >= kWriteAt_bytes && !write_out(text)) return say_write_error(options);
  }
  if (!write_out(text) || std::fflush(stdout) != 0) return say_write_error(options);
  if (!interpreter->ended())
    print_problem(job->file, fmt::format(fmt::runtime(say(options.tongue, "nach {} Sätzen abgebrochen (--max-blocks).",
                                                          "stopped after {} blocks (--max-blocks).")),
                                         options.most_blocks));
  return 0;
}

}  // namespace cnclab::tool
