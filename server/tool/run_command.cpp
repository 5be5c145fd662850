// `cnclab-tool run`: executes in virtual time and prints one JSON summary.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <memory>

#include "geometry/path_json.hpp"
#include "tool/simulation.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

constexpr std::string_view kTraceHeader = "t_s,x_mm,y_mm,z_mm,u_mm,feed_mm_min,spindle_rpm,program,block\n";

void append_field(std::string& text, std::string_view name, double value) {
  text += fmt::format("\"{}\":", name);
  geometry::append_number(text, value);
}

/// The event's own object with its time as last field; nothing for events without a printed form.
void append_event(std::string& text, const TimedItem& event) {
  std::string object;
  if (!geometry::append_json(object, event.item)) return;
  object.pop_back();
  if (text.back() != '[') text += ',';
  text += object + ',';
  append_field(text, "t_s", event.time_s);
  text += '}';
}

std::string summary_text(const RunSummary& summary) {
  std::string text = fmt::format("{{\"blocks\":{},", summary.blocks);
  append_field(text, "machine_time_s", summary.machine_time_s);
  text += ',';
  append_field(text, "path_mm", summary.path_mm);
  text += fmt::format(",\"ended\":\"{}\",\"position\":{{", name_of(summary.ended));
  constexpr std::array<std::string_view, 4> kAxes{"x", "y", "z", "u"};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (axis > 0) text += ',';
    append_field(text, kAxes[axis], summary.istwert_mm[axis]);
  }
  text += "},\"events\":[";
  for (const TimedItem& event : summary.events) append_event(text, event);
  text += ']';
  if (summary.events_left_off > 0) text += fmt::format(",\"events_left_off\":{}", summary.events_left_off);
  if (summary.limit_axis && *summary.limit_axis < kAxes.size())
    text += fmt::format(",\"limit_axis\":\"{}\"", kAxes[*summary.limit_axis]);
  return text + "}\n";
}

/// A file that the user asked for, or nothing for an empty name. Closes with a check.
class Recorder {
 public:
  explicit Recorder(const std::string& name) : name_(name) {
    if (!name.empty()) file_ = std::make_unique<std::ofstream>(name, std::ios::binary | std::ios::trunc);
  }
  [[nodiscard]] std::ostream* stream() { return file_.get(); }
  /// False after the problem was printed.
  [[nodiscard]] bool is_sound(language::Tongue tongue) {
    if (file_ == nullptr) return true;
    file_->flush();
    if (*file_) return true;
    print_problem(name_, say(tongue, "nicht beschreibbar. Verzeichnis, Rechte und Platz prüfen.",
                             "cannot be written. Check folder, permissions and space."));
    return false;
  }

 private:
  std::string name_;
  std::unique_ptr<std::ofstream> file_;
};

}  // namespace

int run(const Options& options) {
  const auto job = open_sound_job(options);
  if (!job) return kExitError;
  Recorder trace(options.trace_file), steps(options.steps_file);
  if (!trace.is_sound(options.tongue) || !steps.is_sound(options.tongue)) return kExitError;
  if (trace.stream() != nullptr) *trace.stream() << kTraceHeader;
  const auto simulation =
      std::make_unique<Simulation>(*job, options, Recording{.trace = trace.stream(), .steps = steps.stream()});
  const auto summary = simulation->run();
  if (!summary) {
    job->print(summary.error());
    return kExitError;
  }
  const std::string text = summary_text(*summary);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
  if (summary->error) job->print(*summary->error);
  if (!trace.is_sound(options.tongue) || !steps.is_sound(options.tongue)) return kExitError;
  return summary->ended == RunEnd::error ? kExitError : 0;
}

}  // namespace cnclab::tool
