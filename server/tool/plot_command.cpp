// `cnclab-tool plot`: a drawing of tool path and workpiece, from the same test run and picture as GRAFIK.
#include <algorithm>
#include <fstream>

#include "drawing/pdf.hpp"
#include "drawing/svg.hpp"
#include "program/checked_path.hpp"
#include "testrun/test_picture.hpp"
#include "tool/job.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

using testrun::Finding;

/// A program that loops without end is followed so far.
constexpr std::uint64_t kMostBlocks = 1'000'000;
/// More points than this cannot be told apart on paper, and the file would choke its readers.
constexpr std::size_t kMostSpots = 1'000'000;
constexpr std::uint64_t kPortion = 1'000'000;
/// As long as a contour that a run holds back until it is checked: 40 MB.
constexpr std::size_t kLongestContour = program::CheckedPath::kMostHeld;

drawing::View view_of(const std::string& name) {
  if (name == "xz") return drawing::View::xz;
  if (name == "yz") return drawing::View::yz;
  if (name == "iso") return drawing::View::iso;
  return drawing::View::xy;
}

const Finding* find(const testrun::TestRun& test, Finding::Kind kind) {
  const auto found = std::ranges::find(test.findings(), kind, &Finding::kind);
  return found == test.findings().end() ? nullptr : &*found;
}

bool is_endless(const testrun::TestRun& test) {
  return find(test, Finding::Kind::endless_loop) != nullptr || find(test, Finding::Kind::too_long) != nullptr;
}

std::expected<testrun::TestRun, language::Error> tested(const Job& job, const Options& options, bool ends_at_travel) {
  auto test = testrun::TestRun::begin({.programs = job.programs,
                                       .settings = job.settings,
                                       .start = job.start,
                                       .data = job.data,
                                       .workpiece = drawing::standard_workpiece(job.start.position),
                                       .travel = testrun::travel_about(job.start.position, job.data),
                                       .ends_at_travel = ends_at_travel,
                                       .most_blocks = std::min(options.most_blocks, kMostBlocks),
                                       .most_spots = kMostSpots,
                                       .longest_contour = kLongestContour});
  if (!test) return test;
  while (!test->has_ended()) test->advance(kPortion);
  if (const Finding* finding = find(*test, Finding::Kind::error)) return std::unexpected(*finding->error);
  return test;
}

/// A loop that walks away would shrink its first pass to a dot: it is drawn up to the limit switches, which stand half
/// the travel away from the start (DEC-23). What ends is drawn as a whole.
std::expected<testrun::TestRun, language::Error> drawable(const Job& job, const Options& options) {
  auto test = tested(job, options, false);
  if (!test || !is_endless(*test)) return test;
  print_problem(job.file, say(options.tongue, "Programm endet nicht: gezeichnet ist es bis zu den Endschaltern.",
                              "program does not end: it is drawn up to the limit switches."));
  return tested(job, options, true);
}

/// SVG, or PDF where the file is called so.
std::expected<std::string, std::string> file_of(const drawing::Picture& picture, const std::string& name) {
  if (name.ends_with(".pdf")) return drawing::pdf_of({&picture, 1});
  return drawing::svg_of(picture);
}

}  // namespace

int plot(const Options& options) {
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  const auto test = drawable(*job, options);
  if (!test) {
    job->print(test.error());
    return kExitError;
  }
  if (const Finding* finding = find(*test, Finding::Kind::contour_in_parts))
    print_problem(job->file, testrun::explain(*finding, options.tongue));
  const auto bytes = file_of(testrun::picture_of(*test, view_of(options.view), options.tongue), options.out_file);
  if (!bytes) {
    print_problem(options.out_file, bytes.error());
    return kExitError;
  }
  std::ofstream out(options.out_file, std::ios::binary | std::ios::trunc);
  out << *bytes;
  out.flush();
  if (out) return 0;
  print_problem(options.out_file, say(options.tongue, "nicht beschreibbar. Verzeichnis, Rechte und Platz prüfen.",
                                      "cannot be written. Check folder, permissions and space."));
  return kExitError;
}

}  // namespace cnclab::tool
