// The media folder and its conversation: whole files or none, and nothing outside the folder whatever the server says
// (interface description sections 3 and 7).
#include <cnclab/v1/envelope.pb.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <functional>

#include "fake_server.hpp"
#include "shared/digest.hpp"
#include "shared/media_name.hpp"
#include "station/media_drive.hpp"

namespace cnclab::station {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What the server says that the receiver has of a file: `offset` bytes, and the SHA-256 of `proven`.
struct Known {
  std::uint64_t offset = 0;
  std::string proven{};
};

/// A drive over a folder of its own, spoken to as the server does.
class Media : public testing::Test {
 protected:
  using Answer = std::optional<v1::ClientMessage>;

  static Known known(const std::string& bytes) { return {bytes.size(), bytes}; }
  template <class Request>
  static void tell(Request& request, const Known& known) {
    request.set_offset(known.offset);
    if (!known.proven.empty()) request.set_digest(sha256(known.proven));
  }

  Answer put(const std::string& name, std::uint64_t size, const Known& known = {}) {
    v1::ServerMessage message;
    tell(*message.mutable_put_media(), known);
    message.mutable_put_media()->set_transfer(++transfer_);
    message.mutable_put_media()->set_name(name);
    message.mutable_put_media()->set_size(size);
    return drive_.take(message);
  }
  Answer chunk(std::uint64_t offset, const std::string& data, bool is_last) {
    v1::ServerMessage message;
    message.mutable_chunk()->set_transfer(transfer_);
    message.mutable_chunk()->set_offset(offset);
    message.mutable_chunk()->set_data(data);
    message.mutable_chunk()->set_is_last(is_last);
    return drive_.take(message);
  }
  Answer get(const std::vector<std::string>& names, const Known& known = {}) {
    v1::ServerMessage message;
    tell(*message.mutable_get_media(), known);
    message.mutable_get_media()->set_transfer(++transfer_);
    for (const std::string& name : names) message.mutable_get_media()->add_names(name);
    return drive_.take(message);
  }
  Answer acknowledge(std::uint64_t next_offset, bool is_abort = false) {
    v1::ServerMessage message;
    message.mutable_chunk_ack()->set_transfer(transfer_);
    message.mutable_chunk_ack()->set_next_offset(next_offset);
    message.mutable_chunk_ack()->set_abort(is_abort);
    return drive_.take(message);
  }

  /// The line was cut: the next connection counts its transfers from 1 again.
  void cut() {
    drive_.pause();
    transfer_ = 0;
  }

  /// What an answer comes to: "ack 4096", "fault NOT_FOUND", "chunk 0+4096", "chunk 4096+904 last", "none".
  static std::string told(const Answer& answer) {
    if (!answer) return "none";
    if (answer->has_chunk_ack()) return "ack " + std::to_string(answer->chunk_ack().next_offset());
    if (answer->has_media_failed())
      return "fault " +
             v1::MediaFault_Name(answer->media_failed().fault()).substr(std::string_view("MEDIA_FAULT_").size());
    const v1::Chunk& chunk = answer->chunk();
    return "chunk " + std::to_string(chunk.offset()) + "+" + std::to_string(chunk.data().size()) +
           (chunk.is_last() ? " last" : "");
  }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }

  TemporaryFolder folder_;
  MediaDrive drive_{MediaPlace{folder_.path(), false}, "anna"};
  std::uint32_t transfer_ = 0;
};

TEST_F(Media, EXT_030_AFileArrivesWholeAfterItsLastChunk) {
  const std::string first(4096, 'a'), second(904, 'b');
  EXPECT_EQ(told(put("P0001.nc", 5000)), "ack 0");
  EXPECT_EQ(told(chunk(0, first, false)), "ack 4096");
  EXPECT_FALSE(fs::exists(folder_.path() / "P0001.nc")) << "not under its name before it is whole";
  EXPECT_EQ(told(chunk(4096, second, true)), "ack 5000");
  EXPECT_EQ(content(folder_.path() / "P0001.nc"), first + second);
  EXPECT_THAT(files(), ElementsAre("P0001.nc"));
}

TEST_F(Media, EXT_030_AFileThatIsBrokenOffLeavesTheFormerOne) {
  folder_.write("P0001.nc", "old");
  put("P0001.nc", 5000);
  chunk(0, std::string(4096, 'a'), false);
  EXPECT_EQ(told(acknowledge(0, true)), "none");
  EXPECT_EQ(told(chunk(4096, std::string(904, 'b'), true)), "none") << "of a transfer that is over";
  EXPECT_EQ(content(folder_.path() / "P0001.nc"), "old");
  EXPECT_THAT(files(), ElementsAre("P0001.nc"));
}

TEST_F(Media, EXT_030_AnotherTransferTakesThePlaceOfOneThatNeverEnded) {
  put("P0001.nc", 5000);
  EXPECT_EQ(told(put("P0002.nc", 1)), "ack 0");
  EXPECT_EQ(told(chunk(0, "x", true)), "ack 1");
  EXPECT_THAT(files(), ElementsAre("P0002.nc"));
}

TEST_F(Media, SEC_006_NamesFromTheServerAreNotTrusted) {
  for (const std::string& name :
       {std::string("../P0001.nc"), std::string("/etc/passwd"), std::string("a/b.nc"), std::string(".bashrc"),
        std::string("P0001.sh"), std::string("-rf.nc"), std::string("P0001"), std::string(), std::string("a..b.nc"),
        std::string("P\0.nc", 5), std::string(61, 'a') + ".nc.nc", std::string("CON.nc")}) {
    EXPECT_EQ(told(put(name, 5)), "fault REFUSED") << name;
    EXPECT_EQ(told(get({name})), "fault REFUSED") << name;
  }
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Media, SEC_006_LinksAreNotFollowedAndOnlyOrdinaryFilesAreTouched) {
  const TemporaryFolder outside;
  const fs::path secret = outside.write("secret.nc", "secret");
  fs::create_symlink(secret, folder_.path() / "P0001.nc");
  fs::create_directory(folder_.path() / "P0002.nc");
  ASSERT_EQ(::mkfifo((folder_.path() / "P0003.nc").c_str(), 0600), 0);
  for (const char* const name : {"P0001.nc", "P0002.nc", "P0003.nc"}) {
    EXPECT_EQ(told(get({name})), "fault NOT_READABLE") << name;
    EXPECT_EQ(told(put(name, 1)), "ack 0");
    EXPECT_EQ(told(chunk(0, "x", true)), "fault NOT_WRITABLE") << name;
  }
  EXPECT_EQ(content(secret), "secret");
  EXPECT_THAT(files(), ElementsAre("P0001.nc", "P0002.nc", "P0003.nc"));
}

TEST_F(Media, SEC_006_SizesAndOrderOfChunksAreHeldTo) {
  EXPECT_EQ(told(put("P0001.nc", 0)), "fault REFUSED");
  EXPECT_EQ(told(put("P0001.nc", kLargestMediaWritten + 1)), "fault REFUSED");
  const struct {
    std::uint64_t offset;
    std::string data;
    bool is_last;
  } wrong[] = {{1, "abc", true}, {0, "abcd", true}, {0, "abc", false},
               {0, "ab", true},  {0, "", false},    {0, std::string(4097, 'a'), false}};
  for (const auto& row : wrong) {
    EXPECT_EQ(told(put("P0001.nc", 3)), "ack 0");
    EXPECT_EQ(told(chunk(row.offset, row.data, row.is_last)), "fault REFUSED") << row.offset << " " << row.data.size();
  }
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Media, DEC_62_AFullDiskIsToldAndLeavesTheFormerFile) {
  folder_.write("P0001.nc", "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit former{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &former), 0);
  const rlimit full{5000, former.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  EXPECT_EQ(told(put("P0001.nc", 8192)), "ack 0");
  EXPECT_EQ(told(chunk(0, std::string(4096, 'a'), false)), "ack 4096");
  EXPECT_EQ(told(chunk(4096, std::string(4096, 'b'), true)), "fault NO_ROOM");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &former), 0);
  EXPECT_EQ(content(folder_.path() / "P0001.nc"), "old");
  EXPECT_THAT(files(), ElementsAre("P0001.nc"));
}

TEST_F(Media, EXT_030_AFileIsSentChunkByChunk) {
  folder_.write("P0001.nc", std::string(5000, 'x'));
  EXPECT_EQ(told(get({"P0001.nc"})), "chunk 0+4096");
  EXPECT_EQ(told(acknowledge(4096)), "chunk 4096+904 last");
  EXPECT_EQ(told(acknowledge(5000)), "none");
  EXPECT_EQ(told(acknowledge(5000)), "none") << "it is over";
}

TEST_F(Media, EXT_030_TheFirstThatIsThereIsSent) {
  folder_.write("SPEICHER.nc", "all");
  EXPECT_EQ(told(get({"P0001.nc", "SPEICHER.nc"})), "chunk 0+3 last");
  EXPECT_EQ(told(get({"P0001.nc", "P0002.nc"})), "fault NOT_FOUND");
  EXPECT_EQ(told(get({})), "fault REFUSED");
}

TEST_F(Media, EXT_030_WhatCannotBeReadIsTold) {
  folder_.write("P0001.nc", "");
  folder_.write("P0002.nc", std::string(kLargestMediaRead + 1, 'x'));
  EXPECT_EQ(told(get({"P0001.nc"})), "fault TOO_LARGE");
  EXPECT_EQ(told(get({"P0002.nc"})), "fault TOO_LARGE");
}

TEST_F(Media, EXT_030_AFileIsSentAsItStoodWhenItWasAskedFor) {
  folder_.write("P0003.nc", std::string(5000, 'x'));
  EXPECT_EQ(told(get({"P0003.nc"})), "chunk 0+4096");
  folder_.write("P0003.nc", std::string(4100, 'y'));
  const Answer rest = acknowledge(4096);
  EXPECT_EQ(told(rest), "chunk 4096+904 last");
  EXPECT_EQ(rest->chunk().data(), std::string(904, 'x')) << "no mixture of the two";
}

const std::string kThree = std::string(4096, 'a') + std::string(4096, 'b') + std::string(1808, 'c');  // 10000 bytes

TEST_F(Media, SEAT_004_AFileGoesOnWhereTheServerProvesThatItIsTheSame) {
  const struct {
    const char* name;
    std::string file = "P0001.nc";
    std::uint64_t size = 10'000;
    Known known{};
    std::uint64_t goes_on_at = 0;
  } rows[] = {
      {.name = "all that came", .known = known(kThree.substr(0, 8192)), .goes_on_at = 8192},
      {.name = "an acknowledgement was lost", .known = known(kThree.substr(0, 4096)), .goes_on_at = 4096},
      {.name = "in the midst of a chunk", .known = known(kThree.substr(0, 5000)), .goes_on_at = 5000},
      {.name = "more than came", .known = known(kThree.substr(0, 8193))},
      {.name = "all of it, which never came", .known = known(kThree)},
      {.name = "beyond all files", .known = {UINT64_MAX, kThree.substr(0, 8192)}},
      {.name = "other bytes", .known = {8192, std::string(8192, 'x')}},
      {.name = "no proof", .known = {8192, ""}},
      {.name = "a server that knows no offsets"},
      {.name = "another size", .size = 10'001, .known = known(kThree.substr(0, 8192))},
      {.name = "another name", .file = "P0002.nc", .known = known(kThree.substr(0, 8192))},
  };
  for (const auto& row : rows) {
    drive_ = MediaDrive(MediaPlace{folder_.path(), false}, "anna");
    put("P0001.nc", kThree.size());
    chunk(0, kThree.substr(0, 4096), false);
    chunk(4096, kThree.substr(4096, 4096), false);
    cut();
    EXPECT_EQ(told(put(row.file, row.size, row.known)), "ack " + std::to_string(row.goes_on_at)) << row.name;
    EXPECT_THAT(files(), IsEmpty()) << "of half a file nothing is to be seen";
  }
}

TEST_F(Media, SEAT_004_WhatWentOnIsWhole) {
  folder_.write("P0001.nc", "old");
  put("P0001.nc", kThree.size());
  chunk(0, kThree.substr(0, 4096), false);
  cut();
  EXPECT_EQ(told(chunk(4096, "x", false)), "none") << "nobody has asked on this connection";
  EXPECT_EQ(told(put("P0001.nc", kThree.size(), known(kThree.substr(0, 4096)))), "ack 4096");
  EXPECT_EQ(told(chunk(4096, kThree.substr(4096, 4096), false)), "ack 8192");
  EXPECT_EQ(content(folder_.path() / "P0001.nc"), "old");
  EXPECT_EQ(told(chunk(8192, kThree.substr(8192), true)), "ack 10000");
  EXPECT_EQ(content(folder_.path() / "P0001.nc"), kThree);
  cut();  // and the last acknowledgement never arrived
  EXPECT_EQ(told(put("P0001.nc", kThree.size(), known(kThree.substr(0, 8192)))), "ack 8192");
  EXPECT_EQ(told(chunk(8192, kThree.substr(8192), true)), "ack 10000");
  EXPECT_EQ(content(folder_.path() / "P0001.nc"), kThree);
  EXPECT_THAT(files(), ElementsAre("P0001.nc"));
}

TEST_F(Media, SEAT_004_OnlyOneFileIsKeptAndNotForLong) {
  const struct {
    const char* name;
    std::function<void()> meanwhile;
  } rows[] = {
      {"another file", [this] { put("P0002.nc", 5); }},
      {"a file that is refused", [this] { put("../P0002.nc", 5); }},
      {"a file to be read", [this] { get({"P0003.nc"}); }},
      {"the server breaks it off", [this] { acknowledge(0, true); }},
      {"a chunk out of order", [this] { chunk(1, "x", false); }},
      {"another session", [this] { drive_ = MediaDrive(MediaPlace{folder_.path(), false}, "anna"); }},
  };
  for (const auto& row : rows) {
    put("P0001.nc", kThree.size());
    chunk(0, kThree.substr(0, 4096), false);
    row.meanwhile();
    cut();
    EXPECT_EQ(told(put("P0001.nc", kThree.size(), known(kThree.substr(0, 4096)))), "ack 0") << row.name;
  }
}

TEST_F(Media, SEAT_004_AFileIsReadOnWhereItBeginsAsBefore) {
  const std::string first = kThree.substr(0, 4096);
  const struct {
    const char* name;
    std::vector<std::pair<std::string, std::string>> lie;  ///< when the line is back
    std::string told, data{};
    Known known{4096, kThree.substr(0, 4096)};
  } rows[] = {
      {"as it was", {{"P0001.nc", kThree}}, "chunk 4096+4096", kThree.substr(4096, 4096)},
      {"new behind what has arrived", {{"P0001.nc", first + "new"}}, "chunk 4096+3 last", "new"},
      {"new at its beginning", {{"P0001.nc", "N" + kThree.substr(1)}}, "chunk 0+4096", "N" + first.substr(1)},
      {"shorter", {{"P0001.nc", first}}, "chunk 0+4096 last", first},
      {"much shorter", {{"P0001.nc", "a"}}, "chunk 0+1 last", "a"},
      {"another one of the names", {{"SPEICHER.nc", "all"}}, "chunk 0+3 last", "all"},
      {"away", {}, "fault NOT_FOUND"},
      {"a server that knows no offsets", {{"P0001.nc", kThree}}, "chunk 0+4096", first, {}},
      {"no proof", {{"P0001.nc", kThree}}, "chunk 0+4096", first, {4096, ""}},
      {"beyond all files", {{"P0001.nc", kThree}}, "chunk 0+4096", first, {UINT64_MAX, first}},
  };
  for (const auto& row : rows) {
    folder_.write("P0001.nc", kThree);
    EXPECT_EQ(told(get({"P0001.nc", "SPEICHER.nc"})), "chunk 0+4096");
    EXPECT_EQ(told(acknowledge(4096)), "chunk 4096+4096");  // which is lost
    cut();
    for (const std::string& name : files()) fs::remove(folder_.path() / name);
    for (const auto& [name, content] : row.lie) folder_.write(name, content);
    const Answer answer = get({"P0001.nc", "SPEICHER.nc"}, row.known);
    EXPECT_EQ(told(answer), row.told) << row.name;
    EXPECT_EQ(answer->chunk().data(), row.data) << row.name;
  }
}

TEST_F(Media, EXT_030_WhatAKilledStationHasLeftIsTakenAway) {
  using namespace std::chrono_literals;
  const fs::path old = folder_.write(".cnclab-4711.part", "half"), other = folder_.write(".profile", "mine");
  folder_.write(".cnclab-4712.part", "half");
  for (const fs::path& file : {old, other}) fs::last_write_time(file, fs::file_time_type::clock::now() - 11min);
  fs::create_directory(folder_.path() / ".cnclab-1.part");
  EXPECT_EQ(told(get({".cnclab-4711.part"})), "fault REFUSED") << "it is no file of the folder";
  put("P0001.nc", 1);
  EXPECT_EQ(told(chunk(0, "x", true)), "ack 1");
  EXPECT_THAT(files(), ElementsAre(".cnclab-1.part", ".cnclab-4712.part", ".profile", "P0001.nc"))
      << "another station may be writing the young one this moment";
}

TEST_F(Media, DEC_62_AFolderThatCannotBeWrittenIsToldBeforeAnythingTravels) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(told(put("P0001.nc", 1)), "fault NOT_WRITABLE");
  fs::permissions(folder_.path(), fs::perms::owner_all);
}

TEST_F(Media, DEC_62_AFolderThatIsGoneIsTold) {
  fs::remove_all(folder_.path());
  EXPECT_EQ(told(put("P0001.nc", 1)), "fault NO_FOLDER");
  EXPECT_EQ(told(get({"P0001.nc"})), "fault NO_FOLDER");
}

TEST_F(Media, DEC_62_TheDefaultPlaceIsMadeForEachStudent) {
  const fs::path place = folder_.path() / "share" / "cnclab" / "media";
  const std::vector<std::pair<std::string, std::string>> rows{
      {"anna", "anna"}, {"..", "%2E."}, {"a/b", "a%2Fb"}, {"Jörg", "J%C3%B6rg"}};
  for (const auto& [user, name] : rows) {
    drive_ = MediaDrive(MediaPlace{place, true}, user);
    EXPECT_EQ(told(put("P0001.nc", 1)), "ack 0") << user;
    EXPECT_EQ(told(chunk(0, "x", true)), "ack 1");
    EXPECT_TRUE(fs::exists(place / name / "P0001.nc")) << name;
    EXPECT_EQ(fs::status(place / name).permissions(), fs::perms::owner_all);
  }
}

TEST(MediaLogin, TheServerIsToldWhetherThereIsAFolder) {
  for (const bool has_media : {false, true}) {
    asio::io_context context;
    bool told_at_login = !has_media, told_at_resume = !has_media;
    FakeServer server(
        context, {[&](FakeLine& line) -> asio::awaitable<void> { told_at_login = (co_await line.admit()).has_media(); },
                  [&](FakeLine& line) -> asio::awaitable<void> {
                    co_await line.greet();
                    const auto resume = co_await line.read(v1::ClientMessage::kResume);
                    told_at_resume = resume.resume().has_media();
                  }});
    Door door = server.door();
    if (has_media) door.media = MediaPlace{"/nowhere", false};
    EXPECT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
      const Credentials credentials{"anna", "geheim", 7, v1::ELSEWHERE_UNSPECIFIED, std::nullopt};
      const auto login = co_await attempt_login(door, credentials);
      EXPECT_TRUE(login);
      const auto resumed = co_await attempt_resume(door, "ticket-1");
      EXPECT_FALSE(resumed);
    }()));
    EXPECT_EQ(told_at_login, has_media);
    EXPECT_EQ(told_at_resume, has_media);
  }
}

}  // namespace
}  // namespace cnclab::station
