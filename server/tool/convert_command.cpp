// `cnclab-tool convert`: the programs of a file in another form.
#include <fmt/format.h>

#include <cstdio>
#include <ctime>

#include "language/screen_form.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

std::string tape_of(const Job& job) {
  std::string text;
  for (const std::uint16_t number : job.in_file_order) {
    const language::Program& program = *job.programs.find(number);
    text += language::write_program(program);
    if (!text.ends_with('\n')) text += '\n';
  }
  return text + "%\n";
}

/// The plane whose words the listing shows where a block could be of several (D-54).
language::Plane plane_behind(const language::Block& block, language::Plane plane) {
  if (block.function.kind != language::Function::Kind::g) return plane;
  if (block.function.code == 17) return language::Plane::xy;
  if (block.function.code == 18) return language::Plane::xz;
  if (block.function.code == 19) return language::Plane::yz;
  return plane;
}

/// The printed form: number, date line with the time of printing, one line per block, "%" (EXT-005, D-108).
std::string listing_of(const Job& job) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  const std::string date = fmt::format("({:02}:{:02}:{:02} {:02}/{:02}/{:02})", local.tm_hour, local.tm_min,
                                       local.tm_sec, local.tm_mday, local.tm_mon + 1, local.tm_year % 100);
  std::string text;
  for (const std::uint16_t number : job.in_file_order) {
    const language::Program& program = *job.programs.find(number);
    text += fmt::format("P{:04}\n\n{}\n\n", program.number, date);
    language::Plane plane = language::Plane::xy;
    for (const language::Block& block : program.blocks) {
      text += language::block_line(block, language::plane_of_words(block, plane), job.tongue) + '\n';
      plane = plane_behind(block, plane);
    }
    text += "%\n";
  }
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
  const std::string text = options.target == "listing" ? listing_of(*job) : tape_of(*job);
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) print_problem("stdout", say(options.tongue, "Schreiben nicht möglich.", "cannot write."));
  return written ? 0 : kExitError;
}

}  // namespace cnclab::tool
