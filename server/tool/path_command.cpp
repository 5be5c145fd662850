// `cnclab-tool path`: what the program does, one element or event per line.
#include <fmt/format.h>

#include <cstdio>

#include "geometry/path_json.hpp"
#include "program/checked_path.hpp"
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

/// Prints what has a printed form, and empties `items`.
void append_items(std::string& text, std::vector<geometry::PathItem>& items) {
  for (const geometry::PathItem& item : items)
    if (geometry::append_json(text, item)) text += '\n';
  items.clear();
}

}  // namespace

int path(const Options& options) {
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  auto source = program::CheckedPath::begin(job->programs, job->settings, job->start);
  if (!source) {
    job->print(source.error());
    return kExitError;
  }
  std::vector<geometry::PathItem> items;
  std::string text;
  std::optional<language::Error> error;
  std::uint64_t blocks = 0;
  for (; blocks < options.most_blocks && !source->ended() && !source->waits_in_vain(); ++blocks) {
    const auto executed = source->step(items);
    append_items(text, items);
    if (!executed) error = executed.error();
    if (text.size() >= kWriteAt_bytes && !write_out(text)) return say_write_error(options);
  }
  const bool is_cut = !source->ended();
  if (is_cut && !error)
    if (const auto flushed = source->flush(items); !flushed) error = flushed.error();
  append_items(text, items);
  if (!write_out(text) || std::fflush(stdout) != 0) return say_write_error(options);
  if (error) {
    job->print(*error);
    return kExitError;
  }
  if (is_cut)
    print_problem(job->file, fmt::format(fmt::runtime(say(options.tongue, "nach {} Sätzen abgebrochen (--max-blocks).",
                                                          "stopped after {} blocks (--max-blocks).")),
                                         blocks));
  return 0;
}

}  // namespace cnclab::tool
