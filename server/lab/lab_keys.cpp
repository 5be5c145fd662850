// Keys and the potentiometer: urgent ones at once, the others in their order, none honoured late (AUTH-005 to
// AUTH-008).
#include <spdlog/spdlog.h>

#include <algorithm>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"
#include "lab/stored_control.hpp"

namespace cnclab::lab {

namespace {

constexpr std::size_t kMostWaiting = 256;
constexpr std::int64_t kOldestStart_ns = 1'000'000'000;  ///< AUTH-008
constexpr std::int64_t kNotice_ns = 8'000'000'000;
const std::string kLineAuthor = "DNC";  ///< of versions that came over the serial line (STO-005)

bool contains(const Input& input, Key key) { return std::ranges::find(input.keys, key) != input.keys.end(); }

/// Keys that can start motion, spindle or coolant (AUTH: "start command"). FRÄSER and KÜHLMITTEL also switch off.
bool is_start_command(const Input& input) {
  return contains(input, Key::START) || contains(input, Key::REFERENZ) || contains(input, Key::FRAESER) ||
         contains(input, Key::KUEHLMITTEL);
}

}  // namespace

void Lab::take_key(const VisitPtr& visit, const v1::KeyEvent& event) {
  if (!visit->desk && visit->stage != Stage::at_console) return hang_up(visit, "keys without a seat");
  Input input;
  input.number = event.number();
  input.pressed = event.pressed();
  input.is_repeat = event.is_repeat();
  input.beat = event.seen().beat();
  input.state = event.seen().state();
  if (event.keys_size() < 1 || event.keys_size() > 3) return hang_up(visit, "key event of no or too many keys");
  for (const int key : event.keys()) {
    if (key < 1 || key > kKeys) return hang_up(visit, "unknown key");
    input.keys.push_back(static_cast<Key>(key));
  }
  take_input(visit, std::move(input));
}

void Lab::take_potentiometer(const VisitPtr& visit, const v1::Potentiometer& turn) {
  if (!visit->desk && visit->stage != Stage::at_console) return hang_up(visit, "potentiometer without a seat");
  if (turn.percent() > 100) return hang_up(visit, "potentiometer above 100 %");
  Input input;
  input.number = turn.number();
  input.percent = static_cast<int>(turn.percent());
  input.beat = turn.seen().beat();
  input.state = turn.seen().state();
  take_input(visit, std::move(input));
}

void Lab::take_input(const VisitPtr& visit, Input input) {
  const bool by_console = visit->desk == nullptr;
  std::uint64_t& received = by_console ? visit->received : visit->desk->received;
  if (input.number != received + 1) return hang_up(visit, "key numbers out of order");
  received = input.number;
  heard(visit, input.beat);
  const DeskPtr desk = typed_at(*visit);
  if (!desk) return;  // the keyboard was given back while the key was on its way
  if (by_console) input.number = 0;
  if (input.pressed && !input.keys.empty() && !input.is_repeat) {
    desk->last_key = std::string(name_of(input.keys.front()));
    journal_.write("key", by_console ? desk->last_key + " (" + visit->person.name + ")" : desk->last_key, desk->station,
                   desk->person.name);
  }
  const bool lets_go = !input.pressed && !input.keys.empty();  // of a key that was held when the keyboard was barred
  const bool acts = by_console || lets_go || !bar(*desk);
  if (!take_urgent(visit, desk, input) && acts) {
    if (desk->waiting.size() >= kMostWaiting) return hang_up(visit, "too many keys waiting");
    desk->waiting.push_back(std::move(input));
  }
  pump(desk);
  draw(desk, clock_.monotonic_ns());
}

bool Lab::take_urgent(const VisitPtr& visit, const DeskPtr& desk, const Input& input) {
  const bool stops = contains(input, Key::STOP), halts = contains(input, Key::MASCHINE_HALT);
  if (!input.pressed || (!stops && !halts)) return false;
  // What was to start and waits still was pressed before: it must not undo the stop (AUTH-006).
  std::erase_if(desk->waiting, [](const Input& queued) { return queued.pressed && is_start_command(queued); });
  if (halts && !input.is_repeat) halt_key_pressed(visit, desk);
  if (stops) stop_pressed(desk, input.number);
  return true;
}

void Lab::stop_pressed(const DeskPtr& desk, std::uint64_t number) {
  const auto tongue = tongue_of(desk->person);
  const bool declines = desk->login != kNoLogin && authority_.asked() == desk->login;
  static_cast<void>(decide(Decline{desk->login}, tongue));
  const bool stops_run = desk->control.is_running();
  panel::Outcome outcome_of_stop = desk->control.press(Key::STOP, now(*desk));
  if (stops_run) {  // the tick in progress may just have looked for stops
    const auto& channel = desk->on_lab_machine ? machine_.channel() : desk->training();
    desk->stopping = Desk::Stopping{channel, channel->snapshot().tick + 2};
  }
  outcome(desk, std::move(outcome_of_stop), number);
  if (!declines) return;
  desk->control.drop_hint();
  note(*desk, say(tongue, "Die Maschine ist abgelehnt.", "The machine is declined."));
}

void Lab::halt_key_pressed(const VisitPtr& visit, const DeskPtr& desk) {
  desk->control.note_labs_key();
  const auto tongue = tongue_of(desk->person);
  // Who types at a console signs as its F12 does: at no station, and not as the student.
  const HaltPressed press{visit->person.id, visit->person.name, visit->desk ? desk->station : 0};
  if (!authority_.holds_halt(press.person)) return note(*desk, decide(press, tongue));
  note(*desk, decide(HaltReleased{press.person}, tongue));
  if (authority_.is_halted())
    note(*desk, say(tongue, "MASCHINE HALT gilt noch, gedrückt von ", "MASCHINE HALT still holds, pressed by ") +
                    authority_.halted_by(tongue) + ".");
}

void Lab::pump(const DeskPtr& desk) {
  while (!desk->waiting.empty() && !desk->control.is_storing() && !desk->storing && !desk->switching) {
    const Input input = std::move(desk->waiting.front());
    desk->waiting.pop_front();
    act(desk, input);
  }
}

void Lab::act(const DeskPtr& desk, const Input& input) {
  desk->is_dirty = true;
  if (input.keys.empty()) {
    const bool raised_from_0 = desk->control.override_percent() == 0 && input.percent > 0;
    if (raised_from_0 && desk->on_lab_machine && !is_fresh(*desk, input))
      return note(*desk, say(tongue_of(desk->person), "Das Potentiometer wurde zu spät gehoben: bitte noch einmal.",
                             "The potentiometer was raised too late: please turn it again."));
    return desk->control.set_override(input.percent);
  }
  if (!input.pressed) {
    if (contains(input, Key::START)) desk->ignore_start_until_release = false;
    for (const Key key : input.keys) desk->control.release(key, now(*desk));
    return;
  }
  if (desk->notice_until_ns != 0) note(*desk, "");
  if (contains(input, Key::RESET)) desk->labor.reset();  // it acts in every state, the lab's menu is none (DEC-39)
  if (input.keys.size() > 1) return outcome(desk, desk->control.press_chord(input.keys, now(*desk)), input.number);
  const Key key = input.keys.front();
  const bool is_for_menu = takes_for_menu(*desk, key);
  if (is_for_menu || key == Key::MELDUNG) desk->control.note_labs_key();
  if (is_for_menu) return labor_key(desk, key);
  if (key == Key::MELDUNG) {
    seats_.turn_hand(desk);
    return everybody_changed();
  }
  if (is_start_command(input)) return start_pressed(desk, input);
  outcome(desk, desk->control.press(key, now(*desk)), input.number);
}

void Lab::start_pressed(const DeskPtr& desk, const Input& input) {
  const bool is_start = contains(input, Key::START);
  if (is_start && (desk->ignore_start_until_release || input.is_repeat)) return;
  if (is_start && authority_.asked() != kNoLogin && authority_.asked() == desk->login) {
    desk->ignore_start_until_release = true;  // that START only accepts
    return note(*desk, decide(Accept{desk->login}, tongue_of(desk->person)));
  }
  if (desk->on_lab_machine && authority_.is_halted())
    return note(*desk,
                say(tongue_of(desk->person), "MASCHINE HALT ist gedrückt von ", "MASCHINE HALT was pressed by ") +
                    authority_.halted_by(tongue_of(desk->person)) +
                    say(tongue_of(desk->person), ": erst lösen, dann START.", ": release it, then START."));
  if (desk->on_lab_machine && !is_fresh(*desk, input)) {
    journal_.write("start_refused", "pressed before the present situation was seen", desk->station, desk->person.name,
                   authority_.newest());
    return note(*desk, say(tongue_of(desk->person), "START kam zu spät und gilt nicht: bitte noch einmal drücken.",
                           "START came too late and does not count: please press it again."));
  }
  outcome(desk, desk->control.press(input.keys.front(), now(*desk)), input.number);
}

bool Lab::is_fresh(const Desk& desk, const Input& input) const {
  const auto sent_ns = beats_.sent_ns(input.beat);
  return input.state == desk.state && sent_ns && clock_.monotonic_ns() - *sent_ns <= kOldestStart_ns;
}

void Lab::outcome(const DeskPtr& desk, panel::Outcome outcome, std::uint64_t number) {
  desk->is_dirty = true;
  for (const std::string& news : outcome.line_news) journal_.write("dnc", news, desk->station, desk->person.name);
  if (outcome.store)
    store(desk, std::move(*outcome.store), number, outcome.is_from_line ? kLineAuthor : desk->person.name);
  if (outcome.media) order_media(desk, std::move(*outcome.media), MediaOrder::From::control);
  if (outcome.picture) order_media(desk, std::move(*outcome.picture), MediaOrder::From::hardcopy);
  if (outcome.mode_changed) save_state(desk);
  if (outcome.was_reset && desk->on_lab_machine) {  // DEC-39
    const auto tongue = tongue_of(desk->person);
    static_cast<void>(decide(Deprived{desk->login, "RESET"}, tongue));
    note(*desk, say(tongue, "RESET hat die Maschine abgegeben.", "RESET has given the machine back."));
  }
  if (outcome.remote_start) judge_remote_start(desk, *outcome.remote_start);
  if (!desk->switching && desk->awaits_effect()) desk->switching = number;
  record_run(desk);  // a run that begins now is recorded with the versions that the store has now
}

void Lab::heed_switched(const DeskPtr& desk) {
  if (!desk->switching || desk->awaits_effect()) return;
  desk->switching.reset();
  desk->stopping.reset();
  desk->is_dirty = true;
  pump(desk);
}

void Lab::store(const DeskPtr& desk, panel::StoreRequest request, std::uint64_t number, const std::string& author) {
  desk->storing = number;
  journal_.write("program", change_text(request), desk->station, desk->person.name);
  store_.run(
      [id = desk->person.id, request = std::move(request), by = db::Author{author, desk->station, clock_.unix_ms()}](
          db::Database& database) { lab::carry_out(database, id, request, by); },
      [this, weak = std::weak_ptr(desk), alive = alive_](const std::expected<void, db::StoreError>& result) {
        const DeskPtr stored = weak.lock();
        if (!*alive || !stored) return;
        if (!result) spdlog::error("{}: not stored: {}", stored->person.name, result.error().text);
        stored->storing.reset();
        stored->control.store_done(result ? "" : sentence_for(result.error(), tongue_of(stored->person)));
        stored->settle_machine_data();  // ahead of a START that waits already
        stored->is_dirty = true;
        pump(stored);
        draw(stored, clock_.monotonic_ns());
      });
}

void Lab::note(Desk& desk, const std::string& sentence) {
  desk.notice = sentence;
  desk.notice_until_ns = sentence.empty() ? 0 : clock_.monotonic_ns() + kNotice_ns;
  desk.is_dirty = true;
}

void Lab::save_state(const DeskPtr& desk) {
  desk->last_saved_ns = clock_.monotonic_ns();
  save_cassette(desk);
  std::string state = desk->control.save_state();
  if (state == desk->saved_state) return;
  desk->saved_state = state;
  store_.run([id = desk->person.id, state = std::move(state),
              time = clock_.unix_ms()](db::Database& database) { database.put_control_state(id, state, time); },
             [name = desk->person.name](const std::expected<void, db::StoreError>& result) {
               if (!result) spdlog::error("{}: state not stored: {}", name, result.error().detail);
             });
}

}  // namespace cnclab::lab
