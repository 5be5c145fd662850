// From a run's number to a judgement.
#include "inspection.hpp"

#include <fmt/format.h>

#include "harness/child_process.hpp"
#include "harness/failure.hpp"
#include "harness/temporary_folder.hpp"

namespace cnclab::lesson {

using namespace std::chrono_literals;

namespace {

constexpr auto kStoreLimit = 10s;
constexpr auto kToolLimit = 20s;

/// JSON made from 64-bit numbers may carry them as strings.
std::uint64_t number_of(const nlohmann::json& value) {
  return value.is_string() ? std::stoull(value.get<std::string>()) : value.get<std::uint64_t>();
}

}  // namespace

LabRun newest_lab_run(const harness::Instructor& instructor, const std::string& student) {
  LabRun newest;
  const auto is_stored = [&] {
    newest = {};
    for (const auto& run : instructor.must({"runs", student}).objects) {
      const std::uint64_t id = number_of(run.at("id"));
      if (run.at("machine") != "lab" || id < newest.id) continue;
      newest = {id, run.at("seconds").get<double>(), run.at("ended").get<std::string>()};
    }
    return newest.id != 0 && !newest.ended.empty();
  };
  if (!harness::eventually(kStoreLimit, is_stored)) {
    throw harness::Failure("the run of " + student + " on the lab machine is not among `runs " + student + "`");
  }
  return newest;
}

std::vector<TraceRow> fetch_trace(const harness::Instructor& instructor, const LabRun& run,
                                  const std::filesystem::path& file) {
  instructor.must({"run", "trace", std::to_string(run.id), file.string()});
  const auto trace = read_trace(harness::read_file(file));
  if (!trace) throw harness::Failure(file.string() + ": " + trace.error());
  return *trace;
}

Comparison inspect_part(const Part& part, const std::vector<TraceRow>& trace, const Point& start) {
  return compare(Drawing(part.curves), seen_from(trace, start), Tolerance{}, Expect::part);
}

Comparison inspect(const Part& part, const std::vector<TraceRow>& trace) {
  const Tolerance tolerance;
  // The first row is the end of the first tick: where that moved already, the end of the run tells where it began.
  const bool moved_at_once = trace.front().feed_mm_per_min > 0;
  const std::vector<TraceRow> seen = seen_from(trace, (moved_at_once ? trace.back() : trace.front()).position);
  Comparison result = compare(Drawing(part.curves), seen, tolerance, Expect::whole);
  if (!result.is_as_drawn()) return result;
  for (const Rest& rest : part.rests) {
    const double rested = rested_s(seen, rest.at, tolerance);
    constexpr double kTick_s = 0.001;
    if (rested < rest.seconds - kTick_s) {
      result.fault = fmt::format("rested {:.3f} s instead of {:.1f} s", rested, rest.seconds);
    }
  }
  return result;
}

std::string fault_of_ramp(const std::vector<TraceRow>& trace) {
  constexpr double kFallPerTick = 10.0 + 0.01;  // RAMPE 100 mm/min in 10 ms, and the digits of the trace
  constexpr double kStartStop = 300;            // MD 10
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const double before = trace[i - 1].feed_mm_per_min, now = trace[i].feed_mm_per_min;
    if (before > kStartStop + kFallPerTick && before - now > kFallPerTick) {
      return fmt::format("the feed fell from {:.1f} to {:.1f} mm/min in one tick", before, now);
    }
  }
  if (const double last = trace.back().feed_mm_per_min; last > kStartStop + kFallPerTick) {
    return fmt::format("the trace ends at {:.1f} mm/min, not at rest", last);
  }
  return {};
}

std::string stored_tape(const harness::Instructor& instructor, const std::string& student, int program) {
  const auto answer = instructor.must({"program", "show", student, fmt::format("P{:04}", program)});
  const bool is_object = answer.objects.size() == 1 && answer.objects.front().contains("text");
  return bare_tape(is_object ? answer.objects.front().at("text").get<std::string>() : answer.output);
}

void draw_picture(const std::filesystem::path& tape, const std::filesystem::path& picture, const std::string& view) {
  const harness::TemporaryFolder folder;
  const auto errors = folder.path() / "errors";
  harness::ChildProcess tool(
      {.program = harness::programs_folder() / "cnclab-tool",
       .arguments = {"plot", tape.string(), "--out", picture.string(), "--view", view, "--program", "P0001"},
       .environment = {},
       .stderr_file = errors});
  tool.close_input();
  const auto code = tool.wait(kToolLimit);
  if (code != 0 || harness::read_file(picture).find("<svg") == std::string::npos) {
    throw harness::Failure("cnclab-tool plot " + tape.string() + " made no picture: " + harness::read_file(errors));
  }
}

}  // namespace cnclab::lesson
