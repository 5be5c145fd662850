// The instructor's requests and their answers (INS-005, interfaces.md section 4).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cnclab/v1/bulk.pb.h"
#include "cnclab/v1/instructor.pb.h"
#include "lab/lab.hpp"
#include "lab/refusal.hpp"
#include "language/error.hpp"

namespace cnclab::lab {

struct RecordedRun;
struct ReplayResult;

/// Works on the lab for the length of one message; answers that need the store come later, through the lab's thread.
class Console {
 public:
  explicit Console(Lab& lab) : lab_(lab) {}

  /// Only instructors are answered (SEC-004); everything else is an error in the answer.
  void answer(const std::shared_ptr<Visit>& visit, const v1::InstructorRequest& request);
  void continue_transfer(const std::shared_ptr<Visit>& visit, const v1::ChunkAck& ack);

 private:
  /// Where an answer goes: the visit and the request's number.
  struct Reply {
    std::shared_ptr<Visit> visit;
    std::uint64_t number = 0;
    language::Tongue tongue{};
    [[nodiscard]] const std::string& who() const { return visit->person.name; }
  };
  using Items = std::vector<v1::InstructorItem>;

  // console_requests.cpp
  struct Row;
  static const Row kRows[];
  /// Nothing for a request that this server does not know.
  [[nodiscard]] static const Row* row_of(const v1::InstructorRequest& request);

  void send(const Reply& reply, const Items& items) const;
  void send_error(const Reply& reply, const std::string& error) const;
  void send_done(const Reply& reply, const std::string& detail = {}) const;
  /// The content follows chunk by chunk; `size` bytes of it.
  void send_file(const Reply& reply, std::shared_ptr<std::istream> content, std::uint64_t size) const;
  void send_file(const Reply& reply, std::string content) const;
  /// Runs a job on the store; `then` gets its result on the lab thread, errors go to the console.
  template <class Job, class Then>
  void ask_store(const Reply& reply, Job job, Then then) const;

  // console_machine.cpp
  void status(const Reply& reply) const;
  void fill_station(v1::StationStatus& out, const std::shared_ptr<Desk>& desk) const;
  void decided(const Reply& reply, const Event& event) const;
  /// Says so where there was none.
  void clear_halt(const Reply& reply) const;
  void tools(const Reply& reply, const v1::SetTools& request) const;
  void workpiece(const Reply& reply, const v1::SetWorkpiece& request) const;
  void store_value(const Reply& reply, const std::string& key, const std::string& value,
                   std::function<void(Lab&, const std::string&)> then) const;
  void input(const Reply& reply, const v1::SetInput& request) const;
  void remote(const Reply& reply, const v1::SetRemote& request) const;
  void ram_fault(const Reply& reply, const v1::SetRamFault& request) const;
  void machine_data(const Reply& reply, const v1::ChangeMachineData& request) const;

  // console_classroom.cpp
  /// Who sits there; answers with an error where nobody does.
  [[nodiscard]] std::shared_ptr<Desk> desk_at(const Reply& reply, std::uint32_t station) const;
  void done_at(const Reply& reply, const std::shared_ptr<Desk>& desk, const std::string& what) const;
  void select(const Reply& reply, const v1::SelectStation& request) const;
  void message(const Reply& reply, const v1::SendMessage& request) const;
  void show(const Reply& reply, const v1::ShowStation& request) const;
  void watch(const Reply& reply, const v1::StationOnly& request) const;
  void take(const Reply& reply, const v1::StationOnly& request) const;
  void give(const Reply& reply, const v1::StationOnly& request) const;
  void lock(const Reply& reply, const v1::StationOnly& request, bool on) const;
  void expel(const Reply& reply, const v1::StationOnly& request) const;

  // console_records.cpp
  void runs(const Reply& reply, const v1::StudentName& request) const;
  void run_trace(const Reply& reply, const v1::RunName& request) const;
  void run_replay(const Reply& reply, const v1::RunName& request) const;
  /// Runs it again in the background; `then` gets the result on the lab's thread while the console is there.
  void replay_then(const Reply& reply, RecordedRun run, std::function<void(const ReplayResult&)> then) const;
  void journal(const Reply& reply, const v1::JournalQuery& request) const;
  void backup(const Reply& reply) const;

  // console_roster.cpp
  void passwd(const Reply& reply, const v1::NewPassword& request) const;
  void students(const Reply& reply) const;
  void student_add(const Reply& reply, const v1::StudentAdd& request) const;
  void student_remove(const Reply& reply, const v1::StudentName& request) const;
  void student_restore(const Reply& reply, const v1::StudentName& request) const;
  void student_rename(const Reply& reply, const v1::StudentRename& request) const;
  void student_set(const Reply& reply, const v1::StudentSettings& request) const;
  void student_password(const Reply& reply, const v1::StudentName& request) const;
  struct Import;
  void hash_next(const Reply& reply, const std::shared_ptr<Import>& import) const;
  void add_all(const Reply& reply, const std::shared_ptr<Import>& import) const;
  void import(const Reply& reply, const v1::RosterImport& request) const;
  void export_roster(const Reply& reply) const;
  void with_hash(const Reply& reply, const std::string& password, std::function<void(std::string)> then) const;

  // console_programs.cpp
  void programs(const Reply& reply, const v1::StudentName& request) const;
  void program_show(const Reply& reply, const v1::ProgramName& request) const;
  void program_versions(const Reply& reply, const v1::ProgramName& request) const;
  void program_send(const Reply& reply, const v1::ProgramSend& request) const;
  void program_collect(const Reply& reply, const v1::ProgramCollect& request) const;
  void program_restore(const Reply& reply, const v1::ProgramName& request) const;
  void machine_data_restore(const Reply& reply, const v1::ProgramName& request) const;

  Lab& lab_;
};

/// "3: P0001 N002: what is wrong": line of the file, place in the program where there is one
[[nodiscard]] std::string tape_error(const language::Error& error, language::Tongue tongue);
[[nodiscard]] v1::InstructorItem done_item(const std::string& detail);

}  // namespace cnclab::lab
