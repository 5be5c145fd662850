// kill -9 while fifteen students store: every acknowledged block is there, none is half, the file is whole (STO-002).
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <random>

#include "db/store.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

constexpr int kStudents = 15;
constexpr int kBlocks = 40;
constexpr int kPipelined = 20;  // stores under way at once, so that commits hold several

/// What the child says when a block is acknowledged; small enough for a pipe to deliver it whole.
struct Acknowledged {
  int student;
  int number;
  int serial;
};

std::string student_name(int student) { return "schueler" + std::to_string(student + 1); }

StoredBlock numbered_block(int student, int number, int serial) {
  return block(number, "G01X+" + std::to_string(serial) + "Y+" + std::to_string(student) + std::string(200, '0'));
}

int serial_of(const std::string& text) { return std::stoi(text.substr(text.find("X+") + 2)); }

// Stores for ever; ends by being killed.
[[noreturn]] void store_until_killed(const std::filesystem::path& file, int pipe, int first_serial) {
  auto database = opened(file);
  std::map<int, PersonId> ids;
  for (int student = 0; student < kStudents; ++student) ids[student] = database.person(student_name(student))->id;
  std::mutex mutex;
  std::condition_variable changed;
  int under_way = 0;
  Store store(std::move(database), [](const std::function<void()>& answer) { answer(); });
  for (int serial = first_serial;; ++serial) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return under_way < kPipelined; });
    ++under_way;
    lock.unlock();
    const Acknowledged said{serial % kStudents, 1 + serial / kStudents % kBlocks, serial};
    store.run(
        [&ids, said](Database& db) {
          db.put_block(ids[said.student], 1, numbered_block(said.student, said.number, said.serial), kAuthor);
        },
        [&, said](const auto& answer) {
          if (answer && ::write(pipe, &said, sizeof said) != sizeof said) std::abort();
          const std::lock_guard guard(mutex);
          --under_way;
          changed.notify_one();
        });
  }
}

struct Crash : ::testing::Test {
  LabFolder folder;
  std::map<std::pair<int, int>, int> acknowledged;  // {student, block} -> serial
  int last_serial = 0;

  // Starts a child, reads acknowledgements until there are `enough`, kills it, reads the rest.
  void kill_after(int enough) {
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(ends[0]);
      store_until_killed(folder.file(), ends[1], last_serial + 1);
    }
    ::close(ends[1]);
    Acknowledged said{};
    for (int count = 0; ::read(ends[0], &said, sizeof said) == sizeof said; ++count) {
      acknowledged[{said.student, said.number}] = said.serial;
      last_serial = std::max(last_serial, said.serial);
      if (count == enough) ::kill(child, SIGKILL);
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    last_serial += kPipelined;  // those of the child that may have been committed without an answer
  }

  void check_every_block() {
    auto database = opened(folder.file());  // checks the file's integrity
    std::map<std::pair<int, int>, int> found;
    for (int student = 0; student < kStudents; ++student)
      for (const StoredProgram& program : database.programs(database.person(student_name(student))->id))
        for (const StoredBlock& stored : program.blocks) {
          const int serial = serial_of(stored.text);
          EXPECT_EQ(stored, numbered_block(student, stored.number, serial)) << "half a block, or another student's";
          found[{student, stored.number}] = serial;
        }
    for (const auto& [key, serial] : acknowledged)
      EXPECT_GE(found[key], serial) << "lost: " << student_name(key.first) << " block " << key.second;
  }
};

TEST_F(Crash, STO_002_EveryAcknowledgedBlockSurvivesKill9) {
  {
    auto database = opened(folder.file());
    for (int student = 0; student < kStudents; ++student) add_student(database, student_name(student));
  }
  const int kills = std::getenv("CNCLAB_SOAK") == nullptr ? 20 : 500;
  std::mt19937 random(3300);
  std::uniform_int_distribution<int> enough(0, 150);
  for (int i = 0; i < kills && !HasFailure(); ++i) {
    SCOPED_TRACE("kill " + std::to_string(i + 1));
    kill_after(enough(random));
    check_every_block();
  }
  EXPECT_GT(acknowledged.size(), 100U);
}

}  // namespace
}  // namespace cnclab::db
