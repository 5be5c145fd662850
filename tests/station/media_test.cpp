// The media folder and its conversation: whole files or none, and nothing outside the folder whatever the server says
// (interface description sections 3 and 7).
#include <cnclab/v1/envelope.pb.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>

#include "fake_server.hpp"
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

/// A drive over a folder of its own, spoken to as the server does.
class Media : public testing::Test {
 protected:
  using Answer = std::optional<v1::ClientMessage>;

  Answer put(const std::string& name, std::uint64_t size) {
    v1::ServerMessage message;
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
  Answer get(const std::vector<std::string>& names) {
    v1::ServerMessage message;
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
  } kWrong[] = {{1, "abc", true}, {0, "abcd", true}, {0, "abc", false},
                {0, "ab", true},  {0, "", false},    {0, std::string(4097, 'a'), false}};
  for (const auto& row : kWrong) {
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
  folder_.write("P0003.nc", std::string(6000, 'x'));
  EXPECT_EQ(told(get({"P0001.nc"})), "fault TOO_LARGE");
  EXPECT_EQ(told(get({"P0002.nc"})), "fault TOO_LARGE");
  EXPECT_EQ(told(get({"P0003.nc"})), "chunk 0+4096");
  fs::resize_file(folder_.path() / "P0003.nc", 4100);
  EXPECT_EQ(told(acknowledge(4096)), "fault NOT_READABLE") << "it has become shorter meanwhile";
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
