// Files on their way between a control and its station, one after the other, chunk by chunk (proto/README.md, "Files at
// the station"). A value without I/O: messages in, messages out.
//
//   PutFiles   PutMedia ──▶ ack 0 ──▶ chunk, ack, … last chunk, ack ──▶ the next file
//   GetFile    GetMedia ──▶ chunk, ack, … last chunk, ack
//
// A line that breaks does no harm: `begin` may be called again for another connection. The file that was under way goes
// on behind the bytes that the receiver has, if the station finds that they are the same; else, or at another station,
// from 0. A station writes whole files or none.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "cnclab/v1/envelope.pb.h"
#include "language/units.hpp"
#include "panel/media.hpp"

namespace cnclab::lab {

/// Why files did not travel: what the station says, and the last three what the lab itself finds.
enum class MediaProblem : std::uint8_t {
  not_found,
  no_room,
  not_readable,
  not_writable,
  too_large,
  refused,
  no_folder,
  no_place,     ///< the station has no folder for files
  controlling,  ///< no files while this station has the machine (interfaces.md section 7)
  silent,       ///< the station has not answered
};

/// A sentence for row 18: what happened, to which file, what to do.
[[nodiscard]] std::string media_sentence(MediaProblem problem, const std::string& file, language::Tongue tongue);

class MediaTransfer {
 public:
  /// What a message led to.
  struct Step {
    std::optional<v1::ServerMessage> send{};
    /// Everything is over: the bytes that were read (none where files were written), or why not.
    std::optional<std::expected<std::string, MediaProblem>> result{};
    bool is_breach = false;  ///< the station does not keep to the protocol: its connection ends
  };

  /// request   PutFiles with at least one file, or GetFile with at least one name
  explicit MediaTransfer(panel::MediaRequest request) : request_(std::move(request)) {}

  /// Begins, or goes on with the file that was under way.
  /// numbers   of the connection's transfers; each file counts it up
  [[nodiscard]] Step begin(std::uint32_t& numbers);
  /// Messages of a transfer that is over are passed over.
  [[nodiscard]] Step take(const v1::ChunkAck& ack, std::uint32_t& numbers);
  [[nodiscard]] Step take(const v1::Chunk& chunk);
  [[nodiscard]] Step take(const v1::MediaFailed& failed);
  /// For the station: what is under way is broken off.
  [[nodiscard]] v1::ServerMessage cancel();
  /// The connection is gone: `begin` at the next one.
  void pause() { transfer_ = 0; }

  [[nodiscard]] bool is_under_way() const { return transfer_ != 0; }
  /// The file that is under way, or is to be first.
  [[nodiscard]] const std::string& file() const;

 private:
  [[nodiscard]] Step ask_to_write(const panel::MediaFile& file);
  [[nodiscard]] Step ask_to_send(const panel::GetFile& get) const;
  [[nodiscard]] Step send_chunk(const panel::MediaFile& file);
  [[nodiscard]] Step finish(std::expected<std::string, MediaProblem> result);

  panel::MediaRequest request_;
  std::uint32_t transfer_ = 0;      ///< 0: none is under way
  bool is_first_answer_ = false;    ///< what comes next says where the file goes on
  std::size_t files_done_ = 0;      ///< PutFiles
  std::uint64_t sent_ = 0;          ///< PutFiles: bytes of the file
  std::uint64_t acknowledged_ = 0;  ///< PutFiles: of those, what the station has; outlives a cut
  std::string received_;            ///< GetFile: what has come; outlives a cut
};

}  // namespace cnclab::lab
