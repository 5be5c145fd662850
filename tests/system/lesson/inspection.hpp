// Fetching what the lab machine did and looking at the part.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/instructor.hpp"
#include "parts.hpp"
#include "report.hpp"

namespace cnclab::lesson {

/// The newest run of a student on the lab machine, waited for until it is stored completely.
struct LabRun {
  std::uint64_t id = 0;
  double seconds = 0;
  std::string ended;
};
[[nodiscard]] LabRun newest_lab_run(const harness::Instructor& instructor, const std::string& student);

/// Fetches the trace of a run to `file` and reads it.
[[nodiscard]] std::vector<TraceRow> fetch_trace(const harness::Instructor& instructor, const LabRun& run,
                                                const std::filesystem::path& file);

/// The trace against the part's drawing: path, dwells, and the rest at the end, for every part ends where it began.
[[nodiscard]] Comparison inspect(const Part& part, const std::vector<TraceRow>& trace);
/// The trace of a run that was broken off, as far as it came. `start`: the Istwert at START.
[[nodiscard]] Comparison inspect_part(const Part& part, const std::vector<TraceRow>& trace, const Point& start);

/// Whether the speed fell to rest along the ramp: never by more in a tick than RAMPE allows, but for the last
/// F START/STOP (DEC-20). Empty, or what was seen.
[[nodiscard]] std::string fault_of_ramp(const std::vector<TraceRow>& trace);

/// A program of a student as the server has it now, as bare tape text.
[[nodiscard]] std::string stored_tape(const harness::Instructor& instructor, const std::string& student, int program);

/// Draws the part from a tape file with `cnclab-tool plot`; throws harness::Failure where no picture comes out.
void draw_picture(const std::filesystem::path& tape, const std::filesystem::path& picture, const std::string& view);

}  // namespace cnclab::lesson
