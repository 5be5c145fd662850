// `cnclab-tool plot`: a drawing of tool path and workpiece.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "drawing/path_svg.hpp"
#include "program/path_source.hpp"
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

/// What is drawn: the tool's path, and the programmed contour where the tool keeps beside it (G41 to G44).
struct Drawn {
  std::vector<geometry::PathItem> path, contour;
};

bool is_beside(program::RadiusCompensation side) { return side != program::RadiusCompensation::off; }

void append_ways(const std::vector<geometry::PathItem>& items, std::vector<geometry::PathItem>& ways) {
  std::ranges::copy_if(items, std::back_inserter(ways), is_way);
}

void say_that_it_loops(const Job& job, const Options& options, std::size_t elements) {
  print_problem(job.file,
                fmt::format(fmt::runtime(say(options.tongue, "Programm endet nicht: gezeichnet sind {} Elemente.",
                                             "program does not end: {} elements are drawn.")),
                            elements));
}

/// The elements of the program, or nothing after its error was printed.
std::optional<Drawn> drawn_of(const Job& job, const Options& options) {
  auto source = program::PathSource::begin(job.programs, job.settings, job.start);
  if (!source) {
    job.print(source.error());
    return std::nullopt;
  }
  Drawn drawn;
  std::vector<geometry::PathItem> items;
  const std::uint64_t most_blocks = std::min(options.most_blocks, kMostBlocks);
  for (std::uint64_t blocks = 0; blocks < most_blocks && drawn.path.size() < kMostElements && !source->ended();
       ++blocks) {
    items.clear();
    const auto executed = source->step(items);
    if (!executed) {
      job.print(executed.error());
      return std::nullopt;
    }
    append_ways(items, drawn.path);
    if (is_beside(source->interpreter().modal().radius)) append_ways(source->programmed(), drawn.contour);
  }
  if (source->ended()) return drawn;
  cut_at_switches(drawn.path, job.settings);
  cut_at_switches(drawn.contour, job.settings);
  say_that_it_loops(job, options, drawn.path.size());
  return drawn;
}

drawing::Captions captions_of(language::Tongue tongue) {
  if (tongue == language::Tongue::german) return {};
  return {
      .start = "start", .end = "end", .feed = "feed", .rapid = "rapid", .workpiece = "workpiece", .contour = "contour"};
}

}  // namespace

int plot(const Options& options) {
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  const auto drawn = drawn_of(*job, options);
  if (!drawn) return kExitError;
  const std::string title = fmt::format("P{:04}", job->start.program);
  const std::string svg = drawing::path_svg(drawn->path, {.title = title,
                                                          .view = view_of(options.view),
                                                          .workpiece = drawing::standard_workpiece(job->start.position),
                                                          .contour = drawn->contour,
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
