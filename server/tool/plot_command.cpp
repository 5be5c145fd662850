// `cnclab-tool plot`: a drawing of tool path and workpiece.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "drawing/path_svg.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

/// More elements than this cannot be told apart on paper, and the file would choke its readers.
constexpr std::size_t kMostElements = 200'000;

drawing::View view_of(const std::string& name) {
  if (name == "xz") return drawing::View::xz;
  if (name == "yz") return drawing::View::yz;
  if (name == "iso") return drawing::View::iso;
  return drawing::View::xy;
}

/// A program that loops without end is followed so far.
constexpr std::uint64_t kMostBlocks = 1'000'000;

bool is_way(const geometry::PathItem& item) {
  return std::holds_alternative<geometry::Line>(item.what) || std::holds_alternative<geometry::Arc>(item.what);
}

geometry::Point end_of(const geometry::PathItem& item) {
  if (const auto* arc = std::get_if<geometry::Arc>(&item.what)) return arc->to;
  return std::get<geometry::Line>(item.what).to;
}

/// A loop that walks away would shrink its first pass to a dot: it is drawn up to the limit switches, which stand half
/// the travel away from the start (DEC-23).
void cut_at_switches(std::vector<geometry::PathItem>& path, const program::Settings& settings) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const geometry::Point end = end_of(path[i]);
    const bool is_out = std::abs(end.x) > settings.travel_mm[0] / 2 || std::abs(end.y) > settings.travel_mm[1] / 2 ||
                        std::abs(end.z) > settings.travel_mm[2] / 2;
    if (is_out) return path.resize(i + 1);
  }
}

/// The elements of the program, or nothing after its error was printed.
std::optional<std::vector<geometry::PathItem>> path_of(const Job& job, const Options& options) {
  auto interpreter = program::Interpreter::begin(job.programs, job.settings, job.start);
  if (!interpreter) {
    job.print(interpreter.error());
    return std::nullopt;
  }
  std::vector<geometry::PathItem> path, items;
  const std::uint64_t most_blocks = std::min(options.most_blocks, kMostBlocks);
  std::uint64_t blocks = 0;
  for (; blocks < most_blocks && path.size() < kMostElements && !interpreter->ended(); ++blocks) {
    items.clear();
    const auto executed = interpreter->step(items);
    if (!executed) {
      job.print(executed.error());
      return std::nullopt;
    }
    std::ranges::copy_if(items, std::back_inserter(path), is_way);
  }
  if (interpreter->ended()) return path;
  cut_at_switches(path, job.settings);
  print_problem(job.file,
                fmt::format(fmt::runtime(say(options.tongue, "Programm endet nicht: gezeichnet sind {} Elemente.",
                                             "program does not end: {} elements are drawn.")),
                            path.size()));
  return path;
}

drawing::Captions captions_of(language::Tongue tongue) {
  if (tongue == language::Tongue::german) return {};
  return {.start = "start", .end = "end", .feed = "feed", .rapid = "rapid", .workpiece = "workpiece"};
}

}  // namespace

int plot(const Options& options) {
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  const auto path = path_of(*job, options);
  if (!path) return kExitError;
  const std::string title = fmt::format("P{:04}", job->start.program);
  const std::string svg = drawing::path_svg(*path, {.title = title,
                                                    .view = view_of(options.view),
                                                    .workpiece = drawing::standard_workpiece(job->start.position),
                                                    .captions = captions_of(options.tongue)});
  std::ofstream out(options.out_file, std::ios::binary | std::ios::trunc);
  out << svg;
  out.flush();
  if (out) return 0;
  print_problem(options.out_file, say(options.tongue, "nicht beschreibbar. Verzeichnis, Rechte und Platz prüfen.",
                                      "cannot be written. Check folder, permissions and space."));
  return kExitError;
}

}  // namespace cnclab::tool
