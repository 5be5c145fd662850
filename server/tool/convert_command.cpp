// `cnclab-tool convert`: the programs of a file in another form.
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <optional>
#include <string>

#include "language/listing.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

/// "09:00:00 16/06/83": the time of printing (D-108).
std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return fmt::format("{:02}:{:02}:{:02} {:02}/{:02}/{:02}", local.tm_hour, local.tm_min, local.tm_sec, local.tm_mday,
                     local.tm_mon + 1, local.tm_year % 100);
}

/// A listing may show damaged blocks; a tape has no mark for them. Prints each.
bool has_damaged_block(const Job& job) {
  bool is_found = false;
  for (const std::uint16_t number : job.in_file_order) {
    for (const language::Block& block : job.programs.find(number)->blocks) {
      if (!block.is_damaged) continue;
      is_found = true;
      job.print({.code = language::ErrorCode::checksum_wrong,
                 .program = number,
                 .block = block.number,
                 .in_tool_table = number == language::kToolTable});
    }
  }
  return is_found;
}

/// The tape, or nothing after what it cannot hold was printed.
std::optional<std::string> tape_of(const Job& job) {
  if (has_damaged_block(job)) return std::nullopt;
  std::string text;
  for (const std::uint16_t number : job.in_file_order) text += language::write_program(*job.programs.find(number));
  return text + language::write_machine_data(job.recorded_data) + "%\n";
}

/// The printed form (EXT-005), or nothing after what it cannot hold was printed.
std::optional<std::string> listing_of(const Job& job, language::Tongue tongue) {
  if (!job.recorded_data.empty()) {
    print_problem(
        fmt::format("{}:{}", job.file, job.recorded_data.front().line),
        say(job.tongue, "Maschinendaten stehen in keiner Liste. Abschnitt MD entfernen oder --to cnc3300 nehmen.",
            "a listing holds no machine data. Remove the section MD or use --to cnc3300."));
    return std::nullopt;
  }
  const std::string time = time_stamp();
  std::string text;
  for (const std::uint16_t number : job.in_file_order)
    text += language::write_listing(*job.programs.find(number), time, tongue);
  return text;
}

}  // namespace

int convert(const Options& options) {
  if (options.target == "din66025") {
    print_problem(
        options.file,
        say(options.tongue, "DIN 66025 kann diese Version noch nicht schreiben. --to cnc3300 oder listing nehmen.",
            "this version cannot write DIN 66025 yet. Use --to cnc3300 or listing."));
    return kExitError;
  }
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  const auto text = options.target == "listing" ? listing_of(*job, options.listing_tongue) : tape_of(*job);
  if (!text) return kExitError;
  const bool written = std::fwrite(text->data(), 1, text->size(), stdout) == text->size() && std::fflush(stdout) == 0;
  if (!written) print_problem("stdout", say(options.tongue, "Schreiben nicht möglich.", "cannot write."));
  return written ? 0 : kExitError;
}

}  // namespace cnclab::tool
