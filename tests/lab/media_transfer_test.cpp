// Files between control and station, the server's end (interfaces.md section 7): chunk by chunk, in order, bounded.
#include "lab/media/media_transfer.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <functional>

#include "shared/digest.hpp"
#include "shared/frame.hpp"
#include "shared/media_name.hpp"

namespace cnclab::lab {
namespace {

using panel::GetFile;
using panel::PutFiles;

/// " from 4096" where the request tells that these bytes are known, and proves that they are those of `content`.
template <class Request>
std::string from(const Request& request, const std::string& content) {
  if (request.offset() == 0) return request.digest().empty() ? "" : " with a digest of nothing";
  const bool is_proven = request.digest() == sha256(content.substr(0, request.offset()));
  return " from " + std::to_string(request.offset()) + (is_proven ? "" : " unproven");
}

/// What a step comes to: "put P0001.nc 5", "put P0001.nc 5000 from 4096", "chunk 0+4096", "ack 4096", "done", "read 5",
/// "fault 0", "breach", "none". content   of the file that was under way before
std::string told(const MediaTransfer::Step& step, const std::string& content = "") {
  if (step.is_breach) return "breach";
  std::string text;
  if (step.send && step.send->has_put_media())
    text = "put " + step.send->put_media().name() + " " + std::to_string(step.send->put_media().size()) +
           from(step.send->put_media(), content);
  if (step.send && step.send->has_get_media())
    text = "get " + step.send->get_media().names(0) + from(step.send->get_media(), content);
  if (step.send && step.send->has_chunk())
    text = "chunk " + std::to_string(step.send->chunk().offset()) + "+" +
           std::to_string(step.send->chunk().data().size()) + (step.send->chunk().is_last() ? " last" : "");
  if (step.send && step.send->has_chunk_ack()) text = "ack " + std::to_string(step.send->chunk_ack().next_offset());
  if (!step.result) return text.empty() ? "none" : text;
  if (!text.empty()) text += ", ";
  if (!*step.result) return text + "fault " + std::to_string(static_cast<int>(step.result->error()));
  return text + "done " + std::to_string((*step.result)->size());
}

v1::ChunkAck ack(std::uint32_t transfer, std::uint64_t next_offset) {
  v1::ChunkAck message;
  message.set_transfer(transfer);
  message.set_next_offset(next_offset);
  return message;
}

v1::Chunk chunk(std::uint32_t transfer, std::uint64_t offset, std::size_t size, bool is_last) {
  v1::Chunk message;
  message.set_transfer(transfer);
  message.set_offset(offset);
  message.set_data(std::string(size, 'x'));
  message.set_is_last(is_last);
  return message;
}

v1::MediaFailed failed(std::uint32_t transfer, v1::MediaFault fault) {
  v1::MediaFailed message;
  message.set_transfer(transfer);
  message.set_fault(fault);
  return message;
}

TEST(MediaTransfer, FilesGoOneAfterTheOtherEachChunkAfterItsAcknowledgement) {
  MediaTransfer transfer(PutFiles{{{"P0001.tap", std::string(5000, 'a')}, {"P0001.txt", "abc"}}});
  std::uint32_t numbers = 6;
  EXPECT_EQ(told(transfer.begin(numbers)), "put P0001.tap 5000");
  EXPECT_EQ(told(transfer.take(ack(7, 0), numbers)), "chunk 0+4096");
  EXPECT_EQ(told(transfer.take(ack(6, 4096), numbers)), "none") << "of another transfer";
  EXPECT_EQ(told(transfer.take(ack(7, 4096), numbers)), "chunk 4096+904 last");
  EXPECT_EQ(told(transfer.take(ack(7, 5000), numbers)), "put P0001.txt 3");
  EXPECT_EQ(told(transfer.take(ack(8, 0), numbers)), "chunk 0+3 last");
  EXPECT_EQ(told(transfer.take(ack(8, 3), numbers)), "done 0");
  EXPECT_FALSE(transfer.is_under_way());
  EXPECT_EQ(numbers, 8U);
}

TEST(MediaTransfer, AFileIsReceivedAndEveryChunkAcknowledged) {
  MediaTransfer transfer(GetFile{{"P0001.nc", "SPEICHER.nc"}});
  std::uint32_t numbers = 0;
  EXPECT_EQ(told(transfer.begin(numbers)), "get P0001.nc");
  EXPECT_EQ(told(transfer.take(chunk(1, 0, 4096, false))), "ack 4096");
  EXPECT_EQ(told(transfer.take(chunk(1, 4096, 904, true))), "ack 5000, done 5000");
  EXPECT_EQ(told(transfer.take(chunk(1, 5000, 1, true))), "none") << "it is over";
}

const std::string kThree = std::string(4096, 'a') + std::string(4096, 'b') + std::string(1808, 'c');  // 10000 bytes

/// Two files on their way, the line cut while the third chunk of the second one was not acknowledged.
MediaTransfer cut_off(std::uint32_t& numbers) {
  MediaTransfer transfer(PutFiles{{{"P0001.tap", "abc"}, {"P0001.txt", kThree}, {"P0002.txt", "abc"}}});
  static_cast<void>(transfer.begin(numbers));
  for (const std::uint64_t offset : {0U, 3U}) static_cast<void>(transfer.take(ack(1, offset), numbers));
  for (const std::uint64_t offset : {0U, 4096U, 8192U}) static_cast<void>(transfer.take(ack(2, offset), numbers));
  transfer.pause();
  numbers = 0;  // the next connection counts anew
  return transfer;
}

TEST(MediaTransfer, ACutLineGoesOnWhereTheStationWas) {  // SEAT-004
  const struct {
    const char* name;
    std::uint64_t answer;
    std::string next;
  } rows[] = {
      {"it has what it acknowledged", 8192, "chunk 8192+1808 last"},
      {"it has nothing, or knows no offsets", 0, "chunk 0+4096"},
      {"more than it acknowledged", 10'000, "breach"},
      {"less", 4096, "breach"},
      {"one byte", 1, "breach"},
      {"beyond all files", UINT64_MAX, "breach"},
  };
  for (const auto& row : rows) {
    std::uint32_t numbers = 0;
    MediaTransfer transfer = cut_off(numbers);
    EXPECT_EQ(told(transfer.begin(numbers), kThree), "put P0001.txt 10000 from 8192") << "the first one is there";
    EXPECT_EQ(told(transfer.take(ack(1, row.answer), numbers)), row.next) << row.name;
  }
}

TEST(MediaTransfer, AFileThatWentOnEndsAndTheNextBeginsAtZero) {  // SEAT-004
  std::uint32_t numbers = 0;
  MediaTransfer transfer = cut_off(numbers);
  static_cast<void>(transfer.begin(numbers));
  static_cast<void>(transfer.take(ack(1, 8192), numbers));
  EXPECT_EQ(told(transfer.take(ack(1, 10'000), numbers)), "put P0002.txt 3");
  transfer.pause();
  numbers = 0;
  EXPECT_EQ(told(transfer.begin(numbers)), "put P0002.txt 3") << "nothing of it was acknowledged";
  EXPECT_EQ(told(transfer.take(ack(1, 0), numbers)), "chunk 0+3 last");
  transfer.pause();
  numbers = 0;
  EXPECT_EQ(told(transfer.begin(numbers)), "put P0002.txt 3");
  static_cast<void>(transfer.take(ack(1, 0), numbers));
  EXPECT_EQ(told(transfer.take(ack(1, 3), numbers)), "done 0");
}

TEST(MediaTransfer, WhatBeganAnewCountsFromThere) {  // SEAT-004
  std::uint32_t numbers = 0;
  MediaTransfer transfer = cut_off(numbers);
  static_cast<void>(transfer.begin(numbers));
  static_cast<void>(transfer.take(ack(1, 0), numbers));
  EXPECT_EQ(told(transfer.take(ack(1, 4096), numbers)), "chunk 4096+4096");
  transfer.pause();
  numbers = 0;
  EXPECT_EQ(told(transfer.begin(numbers), kThree), "put P0001.txt 10000 from 4096");
  EXPECT_EQ(told(transfer.take(ack(1, 4096), numbers)), "chunk 4096+4096");
  EXPECT_EQ(told(transfer.take(ack(1, 0), numbers)), "breach") << "only the first answer says where";
}

TEST(MediaTransfer, AFileIsReadOnOrAnewAsTheStationFindsIt) {  // SEAT-004
  const struct {
    const char* name;
    std::uint64_t offset;
    std::size_t size;
    std::string next;
  } rows[] = {
      {"it is the same", 4096, 904, "ack 5000, done 5000"},
      {"it has changed, or the station knows no offsets", 0, 904, "ack 904, done 904"},
      {"a gap", 4097, 904, "breach"},
      {"a piece that is here", 1, 904, "breach"},
      {"beyond all files", UINT64_MAX, 904, "breach"},
  };
  for (const auto& row : rows) {
    MediaTransfer transfer(GetFile{{"P0001.nc", "SPEICHER.nc"}});
    std::uint32_t numbers = 0;
    static_cast<void>(transfer.begin(numbers));
    static_cast<void>(transfer.take(chunk(1, 0, 4096, false)));
    transfer.pause();
    numbers = 0;
    EXPECT_EQ(told(transfer.begin(numbers), std::string(4096, 'x')), "get P0001.nc from 4096");
    EXPECT_EQ(told(transfer.take(chunk(1, row.offset, row.size, true))), row.next) << row.name;
  }
}

TEST(MediaTransfer, OnlyTheFirstChunkSaysWhereTheFileGoesOn) {  // SEC-006
  MediaTransfer transfer(GetFile{{"P0001.nc"}});
  std::uint32_t numbers = 0;
  static_cast<void>(transfer.begin(numbers));
  static_cast<void>(transfer.take(chunk(1, 0, 4096, false)));
  EXPECT_EQ(told(transfer.take(chunk(1, 0, 4096, false))), "breach");
}

TEST(MediaTransfer, AStationThatDoesNotKeepToTheOrderIsABreach) {  // SEC-006
  const struct {
    const char* name;
    panel::MediaRequest request;
    std::function<MediaTransfer::Step(MediaTransfer&, std::uint32_t&)> act;
  } rows[] = {
      {"acknowledges ahead", PutFiles{{{"P0001.nc", "abc"}}}, [](auto& t, auto& n) { return t.take(ack(1, 1), n); }},
      {"sends unasked", PutFiles{{{"P0001.nc", "abc"}}}, [](auto& t, auto&) { return t.take(chunk(1, 0, 1, true)); }},
      {"acknowledges nothing", GetFile{{"P0001.nc"}}, [](auto& t, auto& n) { return t.take(ack(1, 0), n); }},
      {"leaves a gap", GetFile{{"P0001.nc"}}, [](auto& t, auto&) { return t.take(chunk(1, 1, 1, true)); }},
      {"sends nothing", GetFile{{"P0001.nc"}}, [](auto& t, auto&) { return t.take(chunk(1, 0, 0, true)); }},
      {"too large a chunk", GetFile{{"P0001.nc"}}, [](auto& t, auto&) { return t.take(chunk(1, 0, 4097, true)); }},
  };
  for (const auto& row : rows) {
    MediaTransfer transfer(row.request);
    std::uint32_t numbers = 0;
    static_cast<void>(transfer.begin(numbers));
    EXPECT_EQ(told(row.act(transfer, numbers)), "breach") << row.name;
  }
}

TEST(MediaTransfer, MoreThanAnnouncedIsABreach) {  // SEC-006
  MediaTransfer transfer(GetFile{{"P0001.nc"}});
  std::uint32_t numbers = 0;
  static_cast<void>(transfer.begin(numbers));
  for (std::uint64_t offset = 0; offset < kLargestMediaRead; offset += kLargestChunk)
    ASSERT_EQ(told(transfer.take(chunk(1, offset, kLargestChunk, false))),
              "ack " + std::to_string(offset + kLargestChunk));
  EXPECT_EQ(told(transfer.take(chunk(1, kLargestMediaRead, 1, true))), "breach");
}

TEST(MediaTransfer, WhatIsNoMediumNeverLeaves) {
  for (const panel::MediaFile& file : {panel::MediaFile{"../x.nc", "a"}, panel::MediaFile{"P0001.nc", ""},
                                       panel::MediaFile{"P0001.nc", std::string(kLargestMediaWritten + 1, 'a')}}) {
    MediaTransfer transfer(PutFiles{{file}});
    std::uint32_t numbers = 0;
    const auto step = transfer.begin(numbers);
    EXPECT_FALSE(step.send) << file.name;
    ASSERT_TRUE(step.result);
    EXPECT_EQ(step.result->error(), MediaProblem::refused);
  }
}

TEST(MediaTransfer, EveryFaultHasItsSentenceInBothLanguages) {
  const std::vector<std::pair<v1::MediaFault, std::string>> rows{
      {v1::MEDIA_FAULT_NOT_FOUND, "liegt nicht im Dateiordner"},
      {v1::MEDIA_FAULT_NO_ROOM, "ist voll"},
      {v1::MEDIA_FAULT_NOT_READABLE, "nicht lesbar"},
      {v1::MEDIA_FAULT_NOT_WRITABLE, "nicht beschreibbar"},
      {v1::MEDIA_FAULT_TOO_LARGE, "größer als 1 MiB"},
      {v1::MEDIA_FAULT_REFUSED, "abgelehnt"},
      {v1::MEDIA_FAULT_NO_FOLDER, "Dateiordner des Platzes fehlt"}};
  for (const auto& [fault, part] : rows) {
    MediaTransfer transfer(GetFile{{"P0001.nc"}});
    std::uint32_t numbers = 0;
    static_cast<void>(transfer.begin(numbers));
    const auto step = transfer.take(failed(1, fault));
    ASSERT_TRUE(step.result && !*step.result) << part;
    EXPECT_THAT(media_sentence(step.result->error(), transfer.file(), language::Tongue::german),
                testing::HasSubstr(part));
  }
  for (int problem = 0; problem <= static_cast<int>(MediaProblem::silent); ++problem)
    for (const auto tongue : {language::Tongue::german, language::Tongue::english}) {
      const std::string sentence = media_sentence(static_cast<MediaProblem>(problem), "DRUCK-P0001.txt", tongue);
      EXPECT_GT(sentence.size(), 20U) << problem;
      EXPECT_LE(sentence.size(), 110U) << sentence;
    }
}

}  // namespace
}  // namespace cnclab::lab
