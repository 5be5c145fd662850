// Which request is answered by which function.
#include <algorithm>
#include <iterator>

#include "lab/console/console.hpp"

namespace cnclab::lab {

using R = v1::InstructorRequest;

struct Console::Row {
  R::WhatCase what;
  void (*answer)(const Console& console, const Reply& reply, const R& request);

  /// A request that says no more than what it is.
  template <auto member>
  static void bare(const Console& console, const Reply& reply, const R& /*request*/) {
    (console.*member)(reply);
  }
  /// One with a message of its own, which `part` takes out.
  template <auto member, auto part>
  static void with(const Console& console, const Reply& reply, const R& request) {
    (console.*member)(reply, (request.*part)());
  }
};

// One request a line, in the order of instructor.proto.
const Console::Row Console::kRows[] = {
    {R::kStatus, Row::bare<&Console::status>},
    {R::kSelect, Row::with<&Console::select, &R::select>},
    {R::kRelease, [](auto& c, auto& reply, auto& r) { c.decided(reply, ReleaseIt{r.release().force(), reply.who()}); }},
    {R::kHalt, [](auto& c, auto& reply, auto&) { c.decided(reply, HaltPressed{reply.visit->person.id, reply.who()}); }},
    {R::kClearHalt, Row::bare<&Console::clear_halt>},
    {R::kPowerOff, [](auto& c, auto& reply, auto&) { c.decided(reply, PowerSwitched{false, reply.who()}); }},
    {R::kPowerOn, [](auto& c, auto& reply, auto&) { c.decided(reply, PowerSwitched{true, reply.who()}); }},
    {R::kInput, Row::with<&Console::input, &R::input>},
    {R::kRemote, Row::with<&Console::remote, &R::remote>},
    {R::kMachineData, Row::with<&Console::machine_data, &R::machine_data>},
    {R::kTools, Row::with<&Console::tools, &R::tools>},
    {R::kWorkpiece, Row::with<&Console::workpiece, &R::workpiece>},
    {R::kMessage, Row::with<&Console::message, &R::message>},
    {R::kShow, Row::with<&Console::show, &R::show>},
    {R::kWatch, Row::with<&Console::watch, &R::watch>},
    {R::kTake, Row::with<&Console::take, &R::take>},
    {R::kGive, Row::with<&Console::give, &R::give>},
    {R::kLock, [](auto& c, auto& reply, auto& r) { c.lock(reply, r.lock(), true); }},
    {R::kUnlock, [](auto& c, auto& reply, auto& r) { c.lock(reply, r.unlock(), false); }},
    {R::kExpel, Row::with<&Console::expel, &R::expel>},
    {R::kPasswd, Row::with<&Console::passwd, &R::passwd>},
    {R::kStudents, Row::bare<&Console::students>},
    {R::kStudentAdd, Row::with<&Console::student_add, &R::student_add>},
    {R::kStudentRemove, Row::with<&Console::student_remove, &R::student_remove>},
    {R::kStudentRestore, Row::with<&Console::student_restore, &R::student_restore>},
    {R::kStudentRename, Row::with<&Console::student_rename, &R::student_rename>},
    {R::kStudentSet, Row::with<&Console::student_set, &R::student_set>},
    {R::kStudentPassword, Row::with<&Console::student_password, &R::student_password>},
    {R::kImport, Row::with<&Console::import, &R::import>},
    {R::kExport, Row::bare<&Console::export_roster>},
    {R::kPrograms, Row::with<&Console::programs, &R::programs>},
    {R::kProgramShow, Row::with<&Console::program_show, &R::program_show>},
    {R::kProgramSend, Row::with<&Console::program_send, &R::program_send>},
    {R::kProgramCollect, Row::with<&Console::program_collect, &R::program_collect>},
    {R::kProgramVersions, Row::with<&Console::program_versions, &R::program_versions>},
    {R::kProgramRestore, Row::with<&Console::program_restore, &R::program_restore>},
    {R::kRuns, Row::with<&Console::runs, &R::runs>},
    {R::kRunTrace, Row::with<&Console::run_trace, &R::run_trace>},
    {R::kRunReplay, Row::with<&Console::run_replay, &R::run_replay>},
    {R::kJournal, Row::with<&Console::journal, &R::journal>},
    {R::kBackup, Row::bare<&Console::backup>},
    {R::kRamFault, Row::with<&Console::ram_fault, &R::ram_fault>},
};

const Console::Row* Console::row_of(const R& request) {
  const auto* const row = std::ranges::find(kRows, request.what_case(), &Row::what);
  return row == std::end(kRows) ? nullptr : row;
}

void Console::answer(const std::shared_ptr<Visit>& visit, const R& request) {
  const Reply reply{visit, request.number(), lab_.tongue_of(visit->person)};
  if (visit->stage != Stage::at_console || visit->person.role != "instructor") {
    lab_.journal_.write("refused", "instructor request without the role", 0, visit->person.name);
    return send_error(reply, say(reply.tongue, "Das darf nur die Lehrkraft.", "Only the instructor may do that."));
  }
  if (const Row* const row = row_of(request)) return row->answer(*this, reply, request);
  send_error(reply,
             say(reply.tongue, "Diesen Befehl kennt der Server nicht.", "This server does not know that command."));
}

}  // namespace cnclab::lab
