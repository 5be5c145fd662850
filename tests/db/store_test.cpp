// The writer thread: group commit, failing jobs, full disk, a lock from outside (STO-002, STO-009).
#include "db/store.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <future>
#include <latch>
#include <mutex>
#include <thread>

#include "full_disk.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

using ::testing::HasSubstr;

const Post kAtOnce = [](const std::function<void()>& answer) { answer(); };

// Stores and waits for the answer.
template <class Job>
auto stored(Store& store, Job job) {
  using Result = std::invoke_result_t<Job, Database&>;
  std::promise<std::expected<Result, StoreError>> promise;
  store.run(std::move(job), [&](std::expected<Result, StoreError> answer) { promise.set_value(std::move(answer)); });
  return promise.get_future().get();
}

// Keeps the writer busy, so that what is queued meanwhile is committed together.
class Held {
 public:
  explicit Held(Store& store) {
    store.run([this](Database&) { begun_.count_down(), go_.wait(); }, [](const auto&) {});
    begun_.wait();
  }
  void release() { go_.count_down(); }

 private:
  std::latch begun_{1};
  std::latch go_{1};
};

TEST(Store, AnswersWithTheResultAfterTheCommit) {  // STO-002
  const LabFolder folder;
  Store store(opened(folder.file()), kAtOnce);
  const auto id = stored(store, [](Database& database) { return add_student(database, "anna"); });
  ASSERT_TRUE(id);
  auto reader = Database::open_to_read(folder.file());  // another connection sees only what is committed
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->person("anna")->id, *id);
}

TEST(Store, AnswersComeThroughPost) {
  std::vector<std::function<void()>> posted;
  std::mutex mutex;
  std::thread::id answered_on;
  {
    Store store(opened(":memory:"), [&](std::function<void()> answer) {
      const std::lock_guard lock(mutex);
      posted.push_back(std::move(answer));
    });
    store.run([](Database& database) { database.put_value("epoch", "1"); },
              [&](const auto& answer) { answered_on = answer ? std::this_thread::get_id() : std::thread::id{}; });
  }
  ASSERT_EQ(posted.size(), 1U);
  EXPECT_EQ(answered_on, std::thread::id{});
  posted[0]();
  EXPECT_EQ(answered_on, std::this_thread::get_id());
}

TEST(Store, JobsThatWaitTogetherAreOneCommitInTheirOrder) {
  Store store(opened(":memory:"), kAtOnce);
  Held held(store);
  std::vector<int> answers;
  for (int i = 0; i < 15; ++i)
    store.run([i](Database& database) { database.put_value("last", std::to_string(i)); },
              [&answers, i](const auto& answer) {
                if (answer) answers.push_back(i);
              });
  EXPECT_EQ(store.counters().waiting, 16U);
  held.release();
  EXPECT_EQ(stored(store, [](Database& database) { return database.value("last"); }).value(), "14");
  EXPECT_THAT(answers, ::testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14));
  const auto counters = store.counters();
  EXPECT_EQ(counters.jobs, 17U);
  EXPECT_LE(counters.commits, 3U);  // the held one, the fifteen, the question (which may share theirs)
  EXPECT_EQ(counters.failures, 0U);
  EXPECT_EQ(counters.waiting, 0U);
}

TEST(Store, AJobThatFailsTakesNothingOfTheOthersWithIt) {
  Store store(opened(":memory:"), kAtOnce);
  Held held(store);
  std::vector<std::string> answers;
  const auto note = [&](const std::expected<void, StoreError>& answer) {
    answers.push_back(answer ? "ok" : answer.error().detail);
  };
  store.run([](Database& database) { database.put_value("one", "1"); }, note);
  store.run(
      [](Database& database) {
        database.put_value("half", "1");
        throw std::runtime_error("second thoughts");
      },
      note);
  store.run([](Database& database) { database.put_block(PersonId{77}, 1, block(1, "A"), kAuthor); }, note);
  store.run([](Database& database) { database.put_value("four", "1"); }, note);
  held.release();
  const auto values = stored(store, [](Database& database) {
    return std::vector{database.value("one").has_value(), database.value("half").has_value(),
                       database.value("four").has_value()};
  });
  EXPECT_THAT(values.value(), ::testing::ElementsAre(true, false, true));
  ASSERT_EQ(answers.size(), 4U);
  EXPECT_EQ(answers[0], "ok");
  EXPECT_EQ(answers[1], "second thoughts");
  EXPECT_THAT(answers[2], HasSubstr("FOREIGN KEY"));
  EXPECT_EQ(answers[3], "ok");
  EXPECT_EQ(store.counters().failures, 2U);
}

TEST(Store, AFullDiskIsSaidToEveryJobAndStoringGoesOnWhenThereIsRoom) {  // STO-009
  FullDisk::prepare();
  const LabFolder folder;
  Store store(opened(folder.file()), kAtOnce);
  {
    const FullDisk full;
    Held held(store);
    std::vector<std::future<std::expected<void, StoreError>>> answers;
    for (int i = 0; i < 3; ++i) {
      auto promise = std::make_shared<std::promise<std::expected<void, StoreError>>>();
      answers.push_back(promise->get_future());
      store.run([i](Database& database) { database.put_value("full " + std::to_string(i), std::string(5000000, 'x')); },
                [promise](std::expected<void, StoreError> answer) { promise->set_value(std::move(answer)); });
    }
    held.release();
    for (auto& future : answers) {
      const auto answer = future.get();
      ASSERT_FALSE(answer);
      EXPECT_EQ(answer.error().kind, FailureKind::full) << answer.error().detail;
      EXPECT_THAT(answer.error().text, HasSubstr("Platte des Servers voll"));
    }
  }
  EXPECT_TRUE(stored(store, [](Database& database) { database.put_value("later", "1"); }));
  const auto left = stored(store, [](Database& database) { return database.value("full 0"); });
  EXPECT_EQ(left.value(), std::nullopt);
  EXPECT_EQ(stored(store, [](Database& database) { return database.value("later"); }).value(), "1");
}

TEST(Store, ASmallJobOnAFullDiskFailsAtTheCommit) {  // STO-009
  FullDisk::prepare();
  const LabFolder folder;
  Store store(opened(folder.file()), kAtOnce);
  {
    const FullDisk full;
    const auto answer = stored(store, [](Database& database) { database.put_value("small", "1"); });
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().kind, FailureKind::full) << answer.error().detail;
  }
  EXPECT_EQ(stored(store, [](Database& database) { return database.value("small"); }).value(), std::nullopt);
}

TEST(Store, WaitsForALockFromOutside) {  // STO-009: retried where it helps
  const LabFolder folder;
  Store store(opened(folder.file()), kAtOnce);
  SQLite::Database other(folder.file().string(), SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");
  std::promise<bool> answered;
  store.run([](Database& database) { database.put_value("epoch", "1"); },
            [&](const auto& answer) { answered.set_value(answer.has_value()); });
  auto future = answered.get_future();
  EXPECT_EQ(future.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);
  other.exec("COMMIT");
  EXPECT_TRUE(future.get());
}

TEST(Store, AJobThatHasWaitedIsPatientOnlyForWhatIsLeft) {  // STO-009: told after 5 s, whoever waited in vain before
  using std::chrono::milliseconds;
  EXPECT_EQ(patience_left(milliseconds(0)), milliseconds(5000));
  EXPECT_EQ(patience_left(milliseconds(1)), milliseconds(4999));
  EXPECT_EQ(patience_left(milliseconds(4800)), milliseconds(200));
  EXPECT_EQ(patience_left(milliseconds(4999)), milliseconds(100)) << "what is busy for a moment is no lock";
  EXPECT_EQ(patience_left(milliseconds(60'000)), milliseconds(100));
}

TEST(Store, FinishesWhatWaitsBeforeItEnds) {
  const LabFolder folder;
  int answers = 0;
  {
    Store store(opened(folder.file()), kAtOnce);
    for (int i = 0; i < 100; ++i)
      store.run([i](Database& database) { database.put_value(std::to_string(i), "x"); },
                [&](const auto& answer) { answers += answer ? 1 : 0; });
  }
  EXPECT_EQ(answers, 100);
  EXPECT_TRUE(opened(folder.file()).value("99"));
}

}  // namespace
}  // namespace cnclab::db
