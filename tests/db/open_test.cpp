// Opening a database: made, damaged, newer, foreign, locked, not writable; what is refused stays as it was (STO-008).
#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "db/migrate.hpp"
#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Kind = OpenError::Kind;

void make_lab(const std::filesystem::path& file) {
  auto database = opened(file);
  const PersonId anna = add_student(database, "anna");
  database.transaction([&] {
    for (int number = 1; number <= 300; ++number)
      database.put_block(anna, 1, block(number, "G01X+25000Y+1000"), kAuthor);
  });
}

void write(const std::filesystem::path& file, const std::string& bytes, std::size_t at) {
  std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
  out.seekp(static_cast<std::streamoff>(at));
  out << bytes;
}

TEST(Open, ANewFileIsPrivateAndMarkedAsOurs) {
  const LabFolder folder;
  {
    auto database = opened(folder.file());
    struct stat status{};
    ASSERT_EQ(::stat(folder.file().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
  }
  SQLite::Database raw(folder.file().string());
  EXPECT_EQ(raw.execAndGet("PRAGMA application_id").getInt(), 0x434E434C);
  EXPECT_EQ(raw.execAndGet("PRAGMA user_version").getInt(), migrations().back().number);
  EXPECT_EQ(raw.execAndGet("PRAGMA journal_mode").getString(), "wal");
}

TEST(Open, AnEmptyFileBecomesADatabase) {
  const LabFolder folder;
  {
    const std::ofstream empty(folder.file());
  }
  EXPECT_TRUE(Database::open(folder.file()));
}

struct Spoil {
  const char* name;
  void (*spoil)(const std::filesystem::path& file);
  Kind kind;
  const char* says;
  const char* advice;
};

const Spoil kSpoiled[] = {
    {"garbage", [](const auto& file) { write(file, std::string(100, 'x'), 0); }, Kind::damaged, "damaged", "--restore"},
    {"a page of zeros", [](const auto& file) { write(file, std::string(4096, '\0'), 4096); }, Kind::damaged, "damaged",
     "--restore"},
    {"random bytes inside",
     [](const auto& file) { write(file, std::string(9000, '\x5a'), std::filesystem::file_size(file) - 9500); },
     Kind::damaged, "damaged", "--restore"},
    {"cut in the middle",
     [](const auto& file) { std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2); }, Kind::damaged,
     "damaged", "--restore"},
    {"newer",
     [](const auto& file) { SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99"); },
     Kind::newer, "newer cnclab (database version 99", "Install the newer cnclab"},
    {"foreign",
     [](const auto& file) {
       SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA application_id = 7");
     },
     Kind::other, "another program", "Name another data folder"},
};

TEST(Open, ARefusedFileIsNamedAndStaysByteForByte) {  // STO-008
  for (const Spoil& row : kSpoiled) {
    SCOPED_TRACE(row.name);
    const LabFolder folder;
    make_lab(folder.file());
    row.spoil(folder.file());
    const std::string before = content(folder.file());
    for (const auto& open : {&Database::open, &Database::open_to_read}) {
      const auto database = open(folder.file());
      ASSERT_FALSE(database);
      EXPECT_EQ(database.error().kind, row.kind) << database.error().text;
      EXPECT_THAT(database.error().text,
                  AllOf(StartsWith(folder.file().string()), HasSubstr(row.says), HasSubstr(row.advice)));
      EXPECT_EQ(content(folder.file()), before);
      EXPECT_FALSE(std::filesystem::exists(folder.file().string() + "-wal"));
      EXPECT_FALSE(std::filesystem::exists(folder.file().string() + "-shm"));
    }
  }
}

TEST(Open, ANewerVersionThatStillLiesInTheWalIsSeenAndTheWalStays) {  // STO-008, after a crash of the newer program
  const LabFolder folder;
  const LabFolder crashed;
  make_lab(folder.file());
  {
    SQLite::Database newer(folder.file().string(), SQLite::OPEN_READWRITE);
    newer.exec("PRAGMA user_version = " + std::to_string(migrations().back().number + 1));
    std::filesystem::copy_file(folder.file(), crashed.file());
    std::filesystem::copy_file(folder.file().string() + "-wal", crashed.file().string() + "-wal");
  }
  const std::string file = content(crashed.file());
  const std::string wal = content(crashed.file().string() + "-wal");
  ASSERT_FALSE(wal.empty());
  const auto database = Database::open(crashed.file());
  ASSERT_FALSE(database);
  EXPECT_EQ(database.error().kind, Kind::newer);
  EXPECT_EQ(content(crashed.file()), file);
  EXPECT_EQ(content(crashed.file().string() + "-wal"), wal);
}

TEST(Open, ASecondServerOnTheSameFolderIsRefused) {
  const LabFolder folder;
  auto first = std::make_unique<Database>(opened(folder.file()));
  const auto second = Database::open(folder.file());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, Kind::locked);
  EXPECT_THAT(second.error().text, AllOf(StartsWith(folder.file().string()), HasSubstr("another cnclab-server")));
  first.reset();
  EXPECT_TRUE(Database::open(folder.file()));
}

TEST(Open, ReadingGoesOnWhileTheServerWrites) {
  const LabFolder folder;
  make_lab(folder.file());
  auto server = opened(folder.file());
  server.put_value("epoch", "5");
  auto reader = Database::open_to_read(folder.file());
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->value("epoch"), "5");
  EXPECT_THROW(reader->put_value("epoch", "6"), std::runtime_error);
  server.put_value("epoch", "7");
  EXPECT_EQ(server.value("epoch"), "7");
}

TEST(Open, AMissingFolderAndAMissingFileSayWhatToDo) {
  const LabFolder folder;
  const auto database = Database::open(folder.path() / "no" / "lab.db");
  ASSERT_FALSE(database);
  EXPECT_EQ(database.error().kind, Kind::not_writable);
  EXPECT_THAT(database.error().text, AllOf(HasSubstr((folder.path() / "no").string()), HasSubstr("--data")));
  const auto reader = Database::open_to_read(folder.file());
  ASSERT_FALSE(reader);
  EXPECT_THAT(reader.error().text, AllOf(StartsWith(folder.file().string()), HasSubstr("no such file")));
}

// Rights mean nothing to root, so as root these rows run as "nobody".
struct AsOrdinaryUser {
  bool is_root = ::geteuid() == 0;
  AsOrdinaryUser() {
    if (is_root && ::seteuid(65534) != 0) throw std::runtime_error("seteuid");
  }
  ~AsOrdinaryUser() {
    if (is_root && ::seteuid(0) != 0) std::abort();
  }
};

TEST(Open, AFolderOrFileThatCannotBeWrittenSaysWhatToDo) {
  const LabFolder folder;
  make_lab(folder.file());
  const std::string before = content(folder.file());
  ::chmod(folder.path().c_str(), 0555);
  {
    const AsOrdinaryUser user;
    const auto database = Database::open(folder.file());
    ASSERT_FALSE(database);
    EXPECT_EQ(database.error().kind, Kind::not_writable);
    EXPECT_THAT(database.error().text, AllOf(HasSubstr(folder.path().string()), HasSubstr("cannot be written")));
  }
  ::chmod(folder.path().c_str(), 0777);
  ::chmod((folder.file().string() + "-lock").c_str(), 0666);
  ::chmod(folder.file().c_str(), 0444);
  {
    const AsOrdinaryUser user;
    const auto database = Database::open(folder.file());
    ASSERT_FALSE(database);
    EXPECT_EQ(database.error().kind, Kind::not_writable);
  }
  EXPECT_EQ(content(folder.file()), before);
}

TEST(Open, NamesWithCharactersThatMeanSomethingInAUriWork) {
  const LabFolder folder;
  const auto file = folder.path() / "lab #1 50% ?.db";
  {
    opened(file).put_value("epoch", "1");
  }
  EXPECT_EQ(opened(file).value("epoch"), "1");
}

}  // namespace
}  // namespace cnclab::db
