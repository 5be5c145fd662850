// Feeds a station's media drive what a server might send that keeps to the rules only now and then: any requests,
// chunks and acknowledgements, the line cut in between. Whatever comes, nothing but whole files of a medium's name
// stands in the folder, and nothing outside is touched (SEC-006, SEAT-004).
#include <cnclab/v1/envelope.pb.h>
#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "shared/digest.hpp"
#include "shared/frame.hpp"
#include "shared/media_name.hpp"
#include "station/media_drive.hpp"

namespace fs = std::filesystem;
namespace station = cnclab::station;
namespace v1 = cnclab::v1;

namespace {

void require(bool is_right) {
  if (!is_right) std::abort();
}

/// What the server would like to have written; its pieces differ.
const std::string kContent = [] {
  std::string content(3 * cnclab::kLargestChunk, '\0');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>('a' + i * i / 3 % 26);
  return content;
}();

/// A folder of media beside a file that is nobody's business.
class Place {
 public:
  Place() {
    std::string name = (fs::temp_directory_path() / "cnclab-fuzz-XXXXXX").string();
    require(::mkdtemp(name.data()) != nullptr);
    parent_ = name;
    std::ofstream(parent_ / "secret.nc") << "secret";
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() { fs::remove_all(parent_); }

  [[nodiscard]] fs::path folder() const { return parent_ / "media"; }
  void lay_anew() const {
    fs::remove_all(folder());
    fs::create_directory(folder());
    std::ofstream(folder() / "SPEICHER.nc") << kContent;
    fs::create_symlink(parent_ / "secret.nc", folder() / "P0003.nc");
  }
  void judge() const {
    for (const auto& entry : fs::directory_iterator(folder()))
      require(cnclab::is_media_name(entry.path().filename().string()));
    require(fs::is_symlink(folder() / "P0003.nc") && fs::file_size(parent_ / "secret.nc") == 6);
    require(std::distance(fs::directory_iterator(parent_), fs::directory_iterator()) == 2);
  }

 private:
  fs::path parent_;
};

std::string any_name(FuzzedDataProvider& input) {
  static constexpr std::array<const char*, 6> kNames{"P0001.nc",    "P0002.tap",    "P0003.nc",
                                                     "SPEICHER.nc", "../secret.nc", "secret.nc"};
  return input.ConsumeProbability<float>() < 0.9F ? input.PickValueInArray(kNames)
                                                  : input.ConsumeRandomLengthString(70);
}

/// An offset, mostly one that a transfer could have reached, and mostly what proves it.
template <class Request>
void tell_known(Request& request, FuzzedDataProvider& input) {
  if (input.ConsumeBool()) return;
  request.set_offset(input.ConsumeBool() ? input.ConsumeIntegralInRange<std::uint64_t>(0, 3) * cnclab::kLargestChunk
                                         : input.ConsumeIntegral<std::uint64_t>());
  request.set_digest(input.ConsumeProbability<float>() < 0.8F
                         ? cnclab::sha256(kContent.substr(0, request.offset() % kContent.size()))
                         : input.ConsumeRandomLengthString(40));
}

v1::ServerMessage chunk_at(std::uint32_t transfer, std::uint64_t offset) {
  v1::ServerMessage message;
  v1::Chunk& chunk = *message.mutable_chunk();
  chunk.set_transfer(transfer);
  chunk.set_offset(offset);
  chunk.set_data(kContent.substr(offset, cnclab::kLargestChunk));
  chunk.set_is_last(offset + chunk.data().size() == kContent.size());
  return message;
}

/// What a server that keeps to the rules sends next; nothing where the transfer is over.
std::optional<v1::ServerMessage> proper_reply(const v1::ClientMessage& answer) {
  if (answer.has_chunk_ack() && answer.chunk_ack().next_offset() < kContent.size())
    return chunk_at(answer.chunk_ack().transfer(), answer.chunk_ack().next_offset());
  if (!answer.has_chunk()) return std::nullopt;
  v1::ServerMessage message;
  message.mutable_chunk_ack()->set_transfer(answer.chunk().transfer());
  message.mutable_chunk_ack()->set_next_offset(answer.chunk().offset() + answer.chunk().data().size());
  return message;
}

v1::ServerMessage any_message(FuzzedDataProvider& input) {
  v1::ServerMessage message;
  const auto transfer = input.ConsumeIntegralInRange<std::uint32_t>(0, 2);
  switch (input.ConsumeIntegralInRange(0, 3)) {
    case 0: {
      auto& put = *message.mutable_put_media();
      put.set_transfer(transfer);
      put.set_name(any_name(input));
      put.set_size(input.ConsumeProbability<float>() < 0.8F ? kContent.size() : input.ConsumeIntegral<std::uint64_t>());
      tell_known(put, input);
      break;
    }
    case 1: {
      auto& get = *message.mutable_get_media();
      get.set_transfer(transfer);
      for (int names = input.ConsumeIntegralInRange(0, 5); names > 0; --names) get.add_names(any_name(input));
      tell_known(get, input);
      break;
    }
    case 2: {
      auto& chunk = *message.mutable_chunk();
      chunk.set_transfer(transfer);
      chunk.set_offset(input.ConsumeIntegral<std::uint64_t>());
      chunk.set_data(input.ConsumeRandomLengthString(5000));
      chunk.set_is_last(input.ConsumeBool());
      break;
    }
    default:
      message.mutable_chunk_ack()->set_transfer(transfer);
      message.mutable_chunk_ack()->set_next_offset(input.ConsumeIntegralInRange<std::uint64_t>(0, 3) *
                                                   cnclab::kLargestChunk);
      message.mutable_chunk_ack()->set_abort(input.ConsumeProbability<float>() < 0.1F);
  }
  return message;
}

/// An answer keeps to the bounds, whatever was asked.
void judge(const v1::ServerMessage& message, const std::optional<v1::ClientMessage>& answer) {
  if (!answer) return;
  if (answer->has_chunk_ack() && message.has_put_media() && answer->chunk_ack().next_offset() != 0)
    require(answer->chunk_ack().next_offset() == message.put_media().offset() &&
            answer->chunk_ack().next_offset() < message.put_media().size());
  if (answer->has_chunk()) {
    const v1::Chunk& chunk = answer->chunk();
    require(!chunk.data().empty() && chunk.data().size() <= cnclab::kLargestChunk);
    require(chunk.offset() + chunk.data().size() <= cnclab::kLargestMediaRead);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Place place;
  FuzzedDataProvider input(data, size);
  place.lay_anew();
  station::MediaDrive drive({place.folder(), false}, "anna");
  std::optional<v1::ServerMessage> proper;
  constexpr int kMostMessages = 60;
  for (int i = 0; i < kMostMessages && input.remaining_bytes() > 0; ++i) {
    if (input.ConsumeProbability<float>() < 0.1F) drive.pause();
    const bool is_proper = proper && input.ConsumeProbability<float>() < 0.8F;
    const v1::ServerMessage message = is_proper ? *proper : any_message(input);
    const auto answer = drive.take(message);
    judge(message, answer);
    place.judge();
    if (answer) proper = proper_reply(*answer);
  }
  return 0;
}
