// Files between the controls and their stations, and what is printed (interfaces.md sections 3 and 7; SYS-013,
// SYS-019).
//
//   control ── MediaRequest ──▶ order ── chunks ──▶ station       one order at a time for each desk; a line that breaks
//   LABOR ──── hardcopy ───────▶  │                               lets it go on at the next connection
//                                 └── PDF ──▶ print queue         on a thread that may wait
//
// No file travels to or from the station that has the machine: its line is for keys and stops.
#include <spdlog/spdlog.h>

#include <algorithm>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"
#include "lab/labor/hardcopy.hpp"
#include "lab/media/print_queue.hpp"

namespace cnclab::lab {

namespace {

constexpr std::int64_t kPatience_ns = 10'000'000'000;  ///< for one answer of a station
constexpr std::size_t kMostOrders = 4;                 ///< hardcopies that wait at one desk

/// The file that a printer takes.
const panel::MediaFile* pages_of(const panel::PutFiles& put) {
  const auto pdf = std::ranges::find_if(put.files, [](const auto& file) { return file.name.ends_with(".pdf"); });
  return pdf == put.files.end() ? nullptr : &*pdf;
}

}  // namespace

void Lab::order_media(const DeskPtr& desk, panel::MediaRequest request, MediaOrder::From from) {
  if (from == MediaOrder::From::hardcopy && desk->media.size() >= kMostOrders) return;
  const auto order = std::make_shared<MediaOrder>();
  order->from = from;
  const auto* put = std::get_if<panel::PutFiles>(&request);
  const bool is_for_paper = put != nullptr && put->is_printed && !configuration_.printer_queue.empty();
  const panel::MediaFile* const pages = is_for_paper ? pages_of(*put) : nullptr;
  if (pages != nullptr) print(desk, order, *pages);
  // What is printed needs no folder.
  const VisitPtr visit = desk->visit.lock();
  const bool may_stay_away = pages != nullptr && (!visit || !visit->has_media || controls_machine(*desk));
  if (!may_stay_away) order->transfer.emplace(std::move(request));
  desk->media.push_back(order);
  go_on_with_media(desk);
}

void Lab::print(const DeskPtr& desk, const std::shared_ptr<MediaOrder>& order, const panel::MediaFile& pdf) {
  order->is_printing = true;
  background_.enqueue([this, alive = alive_, post = post_, weak = std::weak_ptr(desk), order, pages = pdf,
                       queue = configuration_.printer_queue] {
    const auto printed = print_pages(queue, pages.name, pages.bytes);
    post([this, alive, weak, order, printed] {
      if (!*alive) return;
      order->is_printing = false;
      if (!printed) spdlog::error("printer: {}", printed.error());
      const DeskPtr owner = weak.lock();
      if (!owner) return;
      if (!printed)
        order->problem =
            say(tongue_of(owner->person), "Der Drucker nimmt nichts an: ", "The printer refuses: ") + printed.error();
      go_on_with_media(owner);
    });
  });
}

bool Lab::controls_machine(const Desk& desk) const {
  return desk.on_lab_machine || (desk.login != kNoLogin && desk.login == authority_.holder());
}

/// Answers what is over; begins what can begin.
void Lab::go_on_with_media(const DeskPtr& desk) {
  while (!desk->media.empty() && desk->media.front()->is_over()) {
    const auto order = desk->media.front();
    desk->media.pop_front();
    media_over(desk, *order);
  }
  if (desk->media.empty()) return;
  MediaOrder& order = *desk->media.front();
  const VisitPtr visit = desk->visit.lock();
  if (!order.transfer || order.transfer->is_under_way() || !visit) return;
  if (controls_machine(*desk)) return fail_media(desk, MediaProblem::controlling);
  if (!visit->has_media) return fail_media(desk, MediaProblem::no_place);
  media_step(visit, desk, order.transfer->begin(visit->transfers));
}

void Lab::media_step(const VisitPtr& visit, const DeskPtr& desk, MediaTransfer::Step step) {
  if (step.is_breach) {
    fail_media(desk, MediaProblem::refused);
    return hang_up(visit, "a file was not sent as it was agreed");
  }
  desk->media_moved_ns = clock_.monotonic_ns();
  if (step.send) visit->peer->send(*step.send);
  if (!step.result) return;
  MediaOrder& order = *desk->media.front();
  if (!*step.result) return fail_media(desk, step.result->error());
  order.read = std::move(**step.result);
  order.transfer.reset();
  go_on_with_media(desk);
}

void Lab::fail_media(const DeskPtr& desk, MediaProblem problem) {
  MediaOrder& order = *desk->media.front();
  const VisitPtr visit = desk->visit.lock();
  if (order.problem.empty()) order.problem = media_sentence(problem, order.transfer->file(), tongue_of(desk->person));
  if (order.transfer->is_under_way() && visit) visit->peer->send(order.transfer->cancel());
  order.transfer.reset();
  go_on_with_media(desk);
}

void Lab::media_over(const DeskPtr& desk, const MediaOrder& order) {
  const auto tongue = tongue_of(desk->person);
  desk->is_dirty = true;
  if (order.from == MediaOrder::From::hardcopy)
    return note(*desk, !order.problem.empty() ? order.problem
                                              : say(tongue, "Der Bildschirm ist gedruckt.", "The screen is printed."));
  if (order.problem.empty())
    desk->control.media_done(order.read);
  else
    desk->control.media_done(std::unexpected(order.problem));
  outcome(desk, desk->control.poll(now(*desk)), 0);  // the answer acts at once
}

void Lab::take_media(const VisitPtr& visit, const v1::ClientMessage& message) {
  const DeskPtr desk = visit->desk;
  if (!desk || desk->media.empty() || !desk->media.front()->transfer) return;  // of a transfer that is over
  MediaTransfer& transfer = *desk->media.front()->transfer;
  if (message.has_chunk_ack()) return media_step(visit, desk, transfer.take(message.chunk_ack(), visit->transfers));
  if (message.has_chunk()) return media_step(visit, desk, transfer.take(message.chunk()));
  media_step(visit, desk, transfer.take(message.media_failed()));
}

void Lab::watch_media(const DeskPtr& desk, std::int64_t now_ns) {
  if (desk->media.empty() || !desk->media.front()->transfer) return;
  const MediaOrder& order = *desk->media.front();
  if (order.from == MediaOrder::From::control && !desk->control.awaits_media())  // STOP
    return fail_media(desk, MediaProblem::refused);
  if (!order.transfer->is_under_way()) return;
  if (controls_machine(*desk)) return fail_media(desk, MediaProblem::controlling);
  if (now_ns - desk->media_moved_ns >= kPatience_ns) fail_media(desk, MediaProblem::silent);
}

void Lab::seat_media(const VisitPtr& visit, const DeskPtr& desk) {
  desk->control.connect_media(visit->has_media);
  desk->control.connect_printer(!configuration_.printer_queue.empty());
  pause_media(*desk);
  go_on_with_media(desk);
}

void Lab::pause_media(Desk& desk) {
  for (const auto& order : desk.media)
    if (order->transfer) order->transfer->pause();
}

void Lab::print_screen(const DeskPtr& desk) {
  const VisitPtr visit = desk->visit.lock();
  const auto tongue = tongue_of(desk->person);
  if (configuration_.printer_queue.empty() && (!visit || !visit->has_media))
    return note(*desk, media_sentence(MediaProblem::no_place, say(tongue, "Drucken", "Printing"), tongue));
  const std::string time = iso_time(clock_.unix_ms());
  const std::string title = say(tongue, "Platz ", "Station ") + std::to_string(desk->station) + "  " +
                            desk->person.name + "  " + time.substr(0, 10) + " " + time.substr(11, 8);
  desk->control.order_picture();
  pictures_.enqueue([this, alive = alive_, post = post_, weak = std::weak_ptr(desk),
                     screen = desk->control.draw(now(*desk), side_view(*desk, clock_.monotonic_ns())), title,
                     name = hardcopy_name(clock_.unix_ms())] {
    post([this, alive, weak, files = hardcopy_of(screen, title, name)]() mutable {
      const DeskPtr owner = weak.lock();
      if (*alive && owner) order_media(owner, std::move(files), MediaOrder::From::hardcopy);
    });
  });
  note(*desk, say(tongue, "Der Bildschirm wird gedruckt …", "The screen is being printed …"));
}

}  // namespace cnclab::lab
