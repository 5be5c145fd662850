// Behind key LABOR: keys to the menu, the menu's orders to the lab.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"

namespace cnclab::lab {

namespace {
constexpr std::size_t kMessagesKept = 40;

/// Each message whole: what does not fit into a row goes on in the next, under its text.
std::vector<std::string> message_lines(const std::deque<std::string>& messages) {
  constexpr std::size_t kWidth = Screen::kColumns - 2;
  const std::u32string indent(7, U' ');  // as wide as the time
  std::vector<std::string> lines;
  for (const std::string& message : messages) {
    std::u32string rest = from_utf8(message);
    while (rest.size() > kWidth) {
      const std::size_t blank = rest.rfind(U' ', kWidth);
      const std::size_t end = blank == std::u32string::npos || blank <= indent.size() ? kWidth : blank;
      lines.push_back(to_utf8(rest.substr(0, end)));
      rest.replace(0, rest[end] == U' ' ? end + 1 : end, indent);
    }
    lines.push_back(to_utf8(rest));
  }
  return lines;
}

}  // namespace

bool Lab::takes_for_menu(const Desk& desk, Key key) const {
  const bool is_asked = desk.login != kNoLogin && authority_.asked() == desk.login;
  return key == Key::LABOR || (desk.labor && key != Key::RESET && !(key == Key::START && is_asked));
}

LaborFacilities Lab::labor_facilities(const Desk& desk) const {
  const VisitPtr visit = desk.visit.lock();
  return {.can_print_screen = !configuration_.printer_queue.empty() || (visit && visit->has_media),
          .has_cassettes = true};
}

/// What each order of the menu does.
struct Lab::LaborOrders {
  Lab& lab;
  const DeskPtr& desk;

  [[nodiscard]] language::Tongue tongue() const { return lab.tongue_of(desk->person); }
  void close(const std::string& sentence) const {
    desk->labor.reset();
    lab.note(*desk, sentence);
  }

  void operator()(const std::monostate& /*order*/) const {}
  void operator()(const CloseMenu& /*order*/) const { desk->labor.reset(); }
  void operator()(const ReadVersions& order) const { lab.read_versions(desk, order.of); }
  void operator()(const RestoreVersion& order) const {
    desk->labor.reset();
    lab.restore_version(desk, order.of, order.version);
  }
  void operator()(const AskForPassword& /*order*/) const {
    // While the station's keys are letters of a password they cannot stop the machine.
    if (desk->on_lab_machine)
      return close(say(tongue(), "Das Passwort lässt sich ändern, wenn die Maschine abgegeben ist.",
                       "The password can be changed once the machine is released."));
    const VisitPtr visit = desk->visit.lock();
    if (!visit) return;
    v1::ServerMessage message;
    message.mutable_ask_password();
    visit->peer->send(message);
    desk->labor.reset();  // the station itself says what it asks for, and until when
  }
  void operator()(const ChooseLanguage& order) const { lab.choose_language(desk, order.tongue); }
  void operator()(const ReadList& order) const {
    switch (order.list) {
      case LaborList::messages:
        return desk->labor->show_list(order.list, message_lines(desk->messages));
      case LaborList::cassettes:
        return desk->labor->show_list(order.list, lab.cassette_lines(*desk));
    }
  }
  void operator()(const PrintScreen& /*order*/) const {
    desk->labor.reset();
    lab.print_screen(desk);
  }
  void operator()(const ChooseCassette& order) const { lab.show_cassette(desk, order.index); }
  void operator()(const MakeCassette& /*order*/) const { lab.wish_cassette(desk, NewCassette{}); }
  void operator()(const ActOnCassette& order) const { lab.act_on_cassette(desk, order); }
  void operator()(const LogOut& /*order*/) const {
    if (const VisitPtr visit = desk->visit.lock()) lab.log_out(visit, "log-out");
  }
};

void Lab::labor_key(const DeskPtr& desk, Key key) {
  if (!desk->labor) {
    desk->labor.emplace(labor_facilities(*desk));
    return;
  }
  std::visit(LaborOrders{*this, desk}, desk->labor->press(key));
}

void Lab::deliver(Desk& desk, const std::string& message) {
  const panel::WallClock at = wall_clock(clock_.unix_ms());
  desk.messages.push_front(fmt::format("{:02}:{:02}  {}", at.hour, at.minute, message));
  if (desk.messages.size() > kMessagesKept) desk.messages.pop_back();
  note(desk, message);
}

void Lab::choose_language(const DeskPtr& desk, language::Tongue tongue) {
  const std::string language = tongue == language::Tongue::german ? "de" : "en";
  desk->person.language = language;
  desk->labor.reset();
  desk->control.set_tongue(tongue);
  note(*desk, say(tongue, "Die Texte sind jetzt deutsch.", "The texts are English now."));
  if (const VisitPtr visit = desk->visit.lock()) {
    visit->person.language = language;
    v1::ServerMessage message;
    message.mutable_language_chosen()->set_language(language);
    visit->peer->send(message);
  }
  store_.run([id = desk->person.id, language](db::Database& database) { database.set_language(id, language); },
             [this, weak = std::weak_ptr(desk), alive = alive_](const std::expected<void, db::StoreError>& result) {
               const DeskPtr owner = weak.lock();
               if (*alive && owner && !result) note(*owner, sentence_for(result.error(), tongue_of(owner->person)));
             });
}

}  // namespace cnclab::lab
