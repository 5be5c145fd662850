// What storing a block costs, beside the floor: the same bytes committed by bare SQLite in the same run.
#include <sqlite3.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <future>
#include <mutex>

#include "db/store.hpp"
#include "figure.hpp"

namespace cnclab {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); }

/// A folder beside the working directory, so that both sides use the same disk; removed at the end.
struct Folder {
  Folder() : path(fs::current_path() / "bench-store") { fs::remove_all(path), fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  fs::path path;
};

db::StoredBlock block(int number) {
  return {number, fmt::format("N{:03}G01X+25000Y+10000Z+4000F1000M03", number), 0x12345678U};
}

/// The floor: one prepared INSERT in its own transaction, WAL and synchronous FULL as ours.
std::vector<double> bare_commits(const fs::path& file, int count) {
  sqlite3* handle = nullptr;
  sqlite3_open(file.c_str(), &handle);
  sqlite3_exec(handle,
               "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; CREATE TABLE b(n INTEGER PRIMARY KEY, t TEXT);",
               nullptr, nullptr, nullptr);
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(handle, "INSERT INTO b(t) VALUES (?1)", -1, &insert, nullptr);
  std::vector<double> times;
  for (int i = 0; i < count; ++i) {
    const std::string text = block(i % 999 + 1).text;
    const auto start = Clock::now();
    sqlite3_bind_text(insert, 1, text.c_str(), -1, SQLITE_TRANSIENT);
    sqlite3_step(insert);
    sqlite3_reset(insert);
    times.push_back(microseconds(Clock::now() - start));
  }
  sqlite3_finalize(insert);
  sqlite3_close(handle);
  return times;
}

db::PersonId person(db::Database& database, int number) {
  db::Person who;
  who.name = fmt::format("schueler{:02}", number);
  who.role = "student";
  return *database.add_person(who, 1);
}

/// One student after the other, waiting for each answer.
std::vector<double> single_stores(db::Store& store, db::PersonId who, int count) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) {
    std::promise<void> stored;
    const auto start = Clock::now();
    store.run(
        [&](db::Database& database) { database.put_block(who, 1 + i / 999, block(i % 999 + 1), {"bench", 1, 1}); },
        [&](const std::expected<void, db::StoreError>&) { stored.set_value(); });
    stored.get_future().wait();
    times.push_back(microseconds(Clock::now() - start));
  }
  return times;
}

/// Fifteen students, each storing the next block as soon as the last is acknowledged.
double stores_per_second(db::Store& store, const std::vector<db::PersonId>& people, int each) {
  std::mutex mutex;
  std::condition_variable all_done;
  std::size_t finished = 0;
  std::function<void(std::size_t, int)> next = [&](std::size_t student, int i) {
    if (i == each) {
      const std::lock_guard lock(mutex);
      ++finished;
      all_done.notify_one();
      return;
    }
    store.run(
        [&, student, i](db::Database& database) {
          database.put_block(people[student], 2, block(i % 999 + 1), {"bench", 1, 1});
        },
        [&, student, i](const std::expected<void, db::StoreError>&) { next(student, i + 1); });
  };
  const auto start = Clock::now();
  for (std::size_t student = 0; student < people.size(); ++student) next(student, 0);
  std::unique_lock lock(mutex);
  all_done.wait(lock, [&] { return finished == people.size(); });
  const std::chrono::duration<double> time = Clock::now() - start;
  return static_cast<double>(people.size()) * each / time.count();
}

}  // namespace
}  // namespace cnclab

int main() {
  using namespace cnclab;
  const Folder folder;
  auto database = db::Database::open(folder.path / "cnclab.db");
  if (!database) return fmt::print(stderr, "{}\n", database.error().text), 1;
  std::vector<db::PersonId> people;
  for (int i = 1; i <= 15; ++i) people.push_back(person(*database, i));
  db::Store store(std::move(*database), [](const std::function<void()>& job) { job(); });
  auto floor = bare_commits(folder.path / "floor.db", 500);
  auto stores = single_stores(store, people.front(), 500);
  bench::print_percentiles("sqlite_commit_us", floor, "us");
  bench::print_percentiles("store_us", stores, "us");
  bench::print_figure("stores_per_second_15_students", stores_per_second(store, people, 100), "1/s");
}
