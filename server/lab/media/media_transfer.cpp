// One file after the other, one chunk after the other.
#include "lab/media/media_transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "shared/digest.hpp"
#include "shared/frame.hpp"
#include "shared/media_name.hpp"

namespace cnclab::lab {

namespace {

MediaProblem problem_of(v1::MediaFault fault) {
  switch (fault) {
    case v1::MEDIA_FAULT_NOT_FOUND:
      return MediaProblem::not_found;
    case v1::MEDIA_FAULT_NO_ROOM:
      return MediaProblem::no_room;
    case v1::MEDIA_FAULT_NOT_READABLE:
      return MediaProblem::not_readable;
    case v1::MEDIA_FAULT_NOT_WRITABLE:
      return MediaProblem::not_writable;
    case v1::MEDIA_FAULT_TOO_LARGE:
      return MediaProblem::too_large;
    case v1::MEDIA_FAULT_NO_FOLDER:
      return MediaProblem::no_folder;
    default:  // a newer station's, too
      return MediaProblem::refused;
  }
}

std::string_view german(MediaProblem problem) {
  switch (problem) {
    case MediaProblem::not_found:
      return "{} liegt nicht im Dateiordner des Platzes. Datei hineinlegen oder eine andere Nummer wählen.";
    case MediaProblem::no_room:
      return "{}: der Datenträger des Platzes ist voll. Platz schaffen und noch einmal ausgeben.";
    case MediaProblem::not_readable:
      return "{} ist am Platz nicht lesbar. Rechte und Datenträger prüfen (Verweise gelten nicht).";
    case MediaProblem::not_writable:
      return "{} ist am Platz nicht beschreibbar. Rechte des Dateiordners prüfen.";
    case MediaProblem::too_large:
      return "{} ist leer oder größer als 1 MiB: gelesen wurde nichts.";
    case MediaProblem::refused:
      return "{} wurde vom Platz abgelehnt: Name oder Größe gelten dort nicht.";
    case MediaProblem::no_folder:
      return "Der Dateiordner des Platzes fehlt. Datenträger einlegen oder --media prüfen.";
    case MediaProblem::no_place:
      return "Dieser Platz hat keinen Dateiordner: {} geht nicht. Station mit --media starten.";
    case MediaProblem::controlling:
      return "{}: keine Dateien, solange dieser Platz die Maschine hat. Erst die Maschine abgeben.";
    case MediaProblem::silent:
      return "{}: der Platz antwortet nicht, abgebrochen. Noch einmal versuchen.";
  }
  return {};
}

std::string_view english(MediaProblem problem) {
  switch (problem) {
    case MediaProblem::not_found:
      return "{} is not in this station's folder. Put it there or choose another number.";
    case MediaProblem::no_room:
      return "{}: the station's disk is full. Make room and put it out again.";
    case MediaProblem::not_readable:
      return "{} cannot be read at the station. Check rights and disk (links do not count).";
    case MediaProblem::not_writable:
      return "{} cannot be written at the station. Check the folder's rights.";
    case MediaProblem::too_large:
      return "{} is empty or larger than 1 MiB: nothing was read.";
    case MediaProblem::refused:
      return "{} was refused by the station: name or size are not valid there.";
    case MediaProblem::no_folder:
      return "The station's folder is gone. Insert the disk or check --media.";
    case MediaProblem::no_place:
      return "This station has no folder for files: {} cannot go there. Start it with --media.";
    case MediaProblem::controlling:
      return "{}: no files while this station has the machine. Give the machine back first.";
    case MediaProblem::silent:
      return "{}: the station does not answer, broken off. Try again.";
  }
  return {};
}

/// What of the file is with the receiver, and what proves it; nothing where nothing is.
template <class Request>
void tell_known(Request& request, std::string_view known) {
  if (known.empty()) return;
  request.set_offset(known.size());
  request.set_digest(sha256(known));
}

}  // namespace

std::string media_sentence(MediaProblem problem, const std::string& file, language::Tongue tongue) {
  return fmt::format(fmt::runtime(tongue == language::Tongue::german ? german(problem) : english(problem)), file);
}

const std::string& MediaTransfer::file() const {
  if (const auto* put = std::get_if<panel::PutFiles>(&request_))
    return put->files[std::min(files_done_, put->files.size() - 1)].name;
  return std::get<panel::GetFile>(request_).names.front();
}

MediaTransfer::Step MediaTransfer::finish(std::expected<std::string, MediaProblem> result) {
  transfer_ = 0;
  return {.result = std::move(result)};
}

MediaTransfer::Step MediaTransfer::begin(std::uint32_t& numbers) {
  transfer_ = ++numbers;
  is_first_answer_ = true;
  if (const auto* put = std::get_if<panel::PutFiles>(&request_)) return ask_to_write(put->files[files_done_]);
  return ask_to_send(std::get<panel::GetFile>(request_));
}

MediaTransfer::Step MediaTransfer::ask_to_write(const panel::MediaFile& file) {
  if (!is_media_name(file.name) || file.bytes.empty() || file.bytes.size() > kLargestMediaWritten)
    return finish(std::unexpected(MediaProblem::refused));
  sent_ = acknowledged_;
  v1::ServerMessage message;
  v1::PutMedia& put = *message.mutable_put_media();
  put.set_transfer(transfer_);
  put.set_name(file.name);
  put.set_size(file.bytes.size());
  tell_known(put, std::string_view(file.bytes).substr(0, acknowledged_));
  return {.send = std::move(message)};
}

MediaTransfer::Step MediaTransfer::ask_to_send(const panel::GetFile& request) const {
  v1::ServerMessage message;
  v1::GetMedia& get = *message.mutable_get_media();
  get.set_transfer(transfer_);
  for (const std::string& name : request.names) get.add_names(name);
  tell_known(get, received_);
  return {.send = std::move(message)};
}

MediaTransfer::Step MediaTransfer::take(const v1::ChunkAck& ack, std::uint32_t& numbers) {
  if (!is_under_way() || ack.transfer() != transfer_) return {};
  const auto* put = std::get_if<panel::PutFiles>(&request_);
  if (put == nullptr) return {.is_breach = true};
  if (ack.abort()) return finish(std::unexpected(MediaProblem::refused));
  if (std::exchange(is_first_answer_, false) && ack.next_offset() == 0) sent_ = 0;
  if (ack.next_offset() != sent_) return {.is_breach = true};
  acknowledged_ = sent_;
  const panel::MediaFile& file = put->files[files_done_];
  if (sent_ < file.bytes.size()) return send_chunk(file);
  acknowledged_ = 0;
  if (++files_done_ < put->files.size()) return begin(numbers);
  return finish(std::string());
}

MediaTransfer::Step MediaTransfer::send_chunk(const panel::MediaFile& file) {
  v1::ServerMessage message;
  v1::Chunk& chunk = *message.mutable_chunk();
  chunk.set_transfer(transfer_);
  chunk.set_offset(sent_);
  chunk.set_data(file.bytes.substr(sent_, kLargestChunk));
  sent_ += chunk.data().size();
  chunk.set_is_last(sent_ == file.bytes.size());
  return {.send = std::move(message)};
}

MediaTransfer::Step MediaTransfer::take(const v1::Chunk& chunk) {
  if (!is_under_way() || chunk.transfer() != transfer_) return {};
  if (std::exchange(is_first_answer_, false) && chunk.offset() == 0) received_.clear();
  const bool is_in_order = std::holds_alternative<panel::GetFile>(request_) && chunk.offset() == received_.size() &&
                           !chunk.data().empty() && chunk.data().size() <= kLargestChunk &&
                           received_.size() + chunk.data().size() <= kLargestMediaRead;
  if (!is_in_order) return {.is_breach = true};
  received_ += chunk.data();
  v1::ServerMessage message;
  message.mutable_chunk_ack()->set_transfer(transfer_);
  message.mutable_chunk_ack()->set_next_offset(received_.size());
  Step step = chunk.is_last() ? finish(std::move(received_)) : Step{};
  step.send = std::move(message);
  return step;
}

MediaTransfer::Step MediaTransfer::take(const v1::MediaFailed& failed) {
  if (!is_under_way() || failed.transfer() != transfer_) return {};
  return finish(std::unexpected(problem_of(failed.fault())));
}

v1::ServerMessage MediaTransfer::cancel() {
  v1::ServerMessage message;
  message.mutable_chunk_ack()->set_transfer(std::exchange(transfer_, 0));
  message.mutable_chunk_ack()->set_abort(true);
  return message;
}

}  // namespace cnclab::lab
