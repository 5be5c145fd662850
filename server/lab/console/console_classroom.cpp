// Requests about stations: messages, screens, keyboards, who must go (INS-002, AUTH-016, SEC-007).
#include <fmt/format.h>

#include "cnclab/v1/envelope.pb.h"
#include "lab/console/console_ask.hpp"
#include "shared/screen.hpp"

namespace cnclab::lab {

namespace {
constexpr std::size_t kLongestMessage = Screen::kColumns;  ///< behind any name it fits the two rows at the stations
}  // namespace

std::shared_ptr<Desk> Console::desk_at(const Reply& reply, std::uint32_t station) const {
  auto desk = lab_.seats_.working_at(static_cast<int>(station));
  if (!desk) send_error(reply, say(reply.tongue, "Dort ist niemand angemeldet.", "Nobody is logged in there."));
  return desk;
}

void Console::done_at(const Reply& reply, const std::shared_ptr<Desk>& desk, const std::string& what) const {
  lab_.journal_.write(what, reply.visit->person.name, desk->station, desk->person.name);
  send_done(reply);
}

void Console::select(const Reply& reply, const v1::SelectStation& request) const {
  // A keyboard whose console is gone would leave nobody to press START.
  const auto desk = lab_.seats_.at(static_cast<int>(request.station()));
  if (desk && !desk->taken_by.empty() && desk->taker.expired()) lab_.give_back(desk);
  decided(reply, Select{static_cast<int>(request.station()), request.force(), reply.who()});
}

void Console::message(const Reply& reply, const v1::SendMessage& request) const {
  const std::string& text = request.text();
  const std::size_t columns = from_utf8(text).size();
  if (text.find_first_not_of(' ') == std::string::npos)
    return send_error(reply, say(reply.tongue, "Die Nachricht ist leer.", "The message is empty."));
  if (columns > kLongestMessage)
    return send_error(
        reply, fmt::format(fmt::runtime(say(reply.tongue, "Eine Nachricht hat höchstens {} Zeichen, diese hat {}.",
                                            "A message has at most {} characters, this one has {}.")),
                           kLongestMessage, columns));
  std::vector<Lab::DeskPtr> readers = lab_.seats_.list();
  if (request.station() != 0) readers = {lab_.seats_.working_at(static_cast<int>(request.station()))};
  std::erase(readers, nullptr);
  if (readers.empty())
    return send_error(reply, say(reply.tongue, "Dort ist niemand angemeldet.", "Nobody is logged in there."));
  for (const auto& desk : readers) lab_.deliver(*desk, reply.who() + ": " + text);
  lab_.journal_.write("message", text, static_cast<int>(request.station()), reply.visit->person.name);
  send_done(reply);
}

void Console::show(const Reply& reply, const v1::ShowStation& request) const {
  if (request.station() == 0) {
    lab_.show_to_all(0);
    lab_.journal_.write("show_end", "", 0, reply.visit->person.name);
    return send_done(reply);
  }
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  if (!desk->is_seated())
    return send_error(reply, say(reply.tongue, "Die Verbindung dieses Platzes ist unterbrochen.",
                                 "The line of that station is broken."));
  lab_.show_to_all(desk->station);
  done_at(reply, desk, "show");
}

void Console::watch(const Reply& reply, const v1::StationOnly& request) const {
  Visit& visit = *reply.visit;
  if (request.station() == 0) {
    visit.watched_station = 0;
    return send_done(reply);
  }
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  visit.watched_station = desk->station;
  v1::ServerMessage message;  // the screens themselves come as ScreenUpdates
  message.mutable_answer()->set_number(reply.number);
  message.mutable_answer()->set_more(true);
  visit.peer->send(message);
  desk->is_dirty = true;
}

void Console::take(const Reply& reply, const v1::StationOnly& request) const {
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  lab_.take_keyboard(reply.visit, desk);
  done_at(reply, desk, "keyboard_taken");
}

void Console::give(const Reply& reply, const v1::StationOnly& request) const {
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  lab_.give_back(desk);
  done_at(reply, desk, "keyboard_given");
}

void Console::lock(const Reply& reply, const v1::StationOnly& request, bool on) const {
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  lab_.set_locked(desk, on);
  done_at(reply, desk, on ? "locked" : "unlocked");
}

void Console::expel(const Reply& reply, const v1::StationOnly& request) const {
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  lab_.expel(desk);
  done_at(reply, desk, "expelled");
}

}  // namespace cnclab::lab
