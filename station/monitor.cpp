// One loop: take what has arrived, draw, wait for the next change or deadline.
#include "station/monitor.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "station/cell_text.hpp"
#include "station/overlays.hpp"

namespace cnclab::station {

namespace asio = boost::asio;
using namespace std::chrono_literals;

namespace {

// A held key comes about every 33 ms, a quick typist's next one after 80 ms or more.
constexpr auto kRepeat = 60ms;
constexpr auto kLit = 150ms;
constexpr auto kTone = 1000ms;
// Of inputs that the server has not handled. It hangs up at 256 that wait, and what comes behind them is lost with
// them.
constexpr std::uint64_t kMostUnhandled = 200;

Colour colour_of(const Binding& binding) {
  const auto* const press = std::get_if<Press>(&binding.action);
  if (press == nullptr || press->keys.size() != 1) return Colour::standard;
  if (press->keys.front() == Key::START) return Colour::green;
  return is_stop(binding) ? Colour::red : Colour::standard;
}

std::string centred(const std::string& text, int width) {
  const int length = static_cast<int>(from_utf8(text).size());
  const int left = std::max(0, (width - length) / 2);
  return std::string(static_cast<std::size_t>(left), ' ') + text +
         std::string(static_cast<std::size_t>(std::max(0, width - length - left)), ' ');
}

}  // namespace

bool has_room(Terminal& terminal, Language language) {
  if (terminal.rows() >= Screen::kRows && terminal.columns() >= Screen::kColumns) return true;
  terminal.clear();
  terminal.write(0, 0, too_small_text(terminal.rows(), terminal.columns(), language));
  terminal.flush();
  return false;
}

Monitor::Monitor(Terminal& terminal, TerminalEvents& events, Broadcast& changed, Session& session)
    : terminal_(terminal), events_(events), changed_(changed), session_(session) {}

asio::awaitable<void> Monitor::run(const bool& is_form_open) {
  while (!has_ended_) {
    if (!is_form_open) {
      if (events_.take_resized()) terminal_.redraw();
      while (const auto event = events_.take()) {
        std::visit([this](const auto& happened) { handle(happened); }, *event);
      }
      follow_password();
      release_due();
      sound();
      draw();
    }
    if (!has_ended_) co_await changed_.wait_until(next_deadline());
  }
}

void Monitor::handle(const Input& input) {
  switch (view_) {
    case View::help:
      return handle_in_help(input);
    case View::log_out_question:
      return handle_question(input);
    case View::new_password:
      return handle_password(input);
    case View::monitor:
      break;
  }
  const bool repeated = is_repeat(input);
  if (const Binding* const binding = binding_of(input)) act(*binding, repeated);
}

bool Monitor::is_repeat(const Input& input) {
  const auto now = Clock::now();
  const bool repeated = last_input_ == input && now - last_input_time_ < kRepeat;
  last_input_ = input;
  last_input_time_ = now;
  return repeated;
}

// STOP and MASCHINE HALT act whatever is drawn over the monitor.
void Monitor::press_urgent(const Input& input) {
  const Binding* const binding = binding_of(input);
  if (binding != nullptr && is_stop(*binding)) act(*binding, false);
}

void Monitor::handle_in_help(const Input& input) {
  const std::size_t page = Screen::kRows - 4, last = last_help_start(session_.language());
  if (input == Input(Special::down)) {
    help_start_ = std::min(help_start_ + 1, last);
  } else if (input == Input(Special::up)) {
    help_start_ -= std::min<std::size_t>(help_start_, 1);
  } else if (input == Input(Special::page_down)) {
    help_start_ = std::min(help_start_ + page, last);
  } else if (input == Input(Special::page_up)) {
    help_start_ -= std::min(help_start_, page);
  } else {
    view_ = View::monitor;
    press_urgent(input);
  }
}

void Monitor::handle_question(const Input& input) {
  view_ = View::monitor;
  const bool is_yes =
      input == Input(U'q') || input == Input(U'j') || input == Input(U'y') || input == Input(Special::ctrl_c);
  if (!is_yes) return press_urgent(input);
  session_.log_out();
  has_ended_ = session_.is_lost();
}

// Letters are the password's; F12 still halts the machine.
void Monitor::handle_password(const Input& input) {
  switch (password_.handle(input, session_.language())) {
    case PasswordForm::State::editing:
      if (std::holds_alternative<Special>(input)) press_urgent(input);
      return;
    case PasswordForm::State::submitted:
      return session_.change_password(password_.old_password(), password_.new_password());
    case PasswordForm::State::cancelled:
      view_ = View::monitor;
      password_ = PasswordForm();
      return;
  }
}

// Opens where the server asks, closes with its consent; a refusal stands there with the fields empty again.
void Monitor::follow_password() {
  if (session_.take_password_question()) {
    view_ = View::new_password;
    password_ = PasswordForm();
  }
  const auto answer = session_.take_password_answer();
  const bool is_open = view_ == View::new_password;
  if (session_.is_lost() && is_open) view_ = View::monitor;
  if (!answer || !is_open) return;
  password_ = PasswordForm();
  if (answer->result() == v1::LOGIN_RESULT_OK)
    view_ = View::monitor;
  else
    password_.say(refusal_text(*answer, session_.language()));
}

void Monitor::handle(const Stray& stray) {
  if (view_ == View::new_password) return handle_password(stray.character);
  press_urgent(stray.character);
}

void Monitor::handle(const Click& click) {
  if (view_ == View::new_password) return;
  if (view_ != View::monitor || !session_.may_press()) {
    view_ = View::monitor;
    return;
  }
  const KeyboardView keyboard(session_.language());
  if (const KeyCap* const cap = keyboard.hit(click.row - Screen::kRows, click.column)) act(*cap->binding, false);
}

void Monitor::act(const Binding& binding, bool repeated) {
  lit_ = &binding;
  lit_until_ = Clock::now() + kLit;
  if (const auto* const keys = std::get_if<Press>(&binding.action)) {
    press(*keys, repeated);
  } else if (const auto* const pot = std::get_if<TurnPotentiometer>(&binding.action)) {
    turn(pot->percent);
  } else {
    switch (std::get<Local>(binding.action)) {
      case Local::help:
        view_ = View::help;
        help_start_ = 0;
        break;
      case Local::log_out:
        view_ = View::log_out_question;
        break;
      case Local::redraw:
        terminal_.redraw();
        break;
    }
  }
}

void Monitor::press(const Press& press, bool repeated) {
  if (press.keys == std::vector{Key::ENTER} && shows_external_data(session_.screen())) return press_latched(repeated);
  if (session_.unhandled() > kMostUnhandled && !is_stop(press)) return;
  if (!session_.send_keys(press.keys, true, repeated)) return;
  if (press.hold == 0ms) {
    session_.send_keys(press.keys, false, repeated);
  } else {
    releases_.push_back({Clock::now() + press.hold, press.keys});
  }
}

// The recorder's motor runs its leader while → is down; a terminal knows no release. So the key stays down until it is
// pressed again or the screen is another one (interfaces.md 3).
void Monitor::press_latched(bool repeated) {
  if (repeated) return;
  let_go();
  is_enter_held_ = session_.send_keys(std::array{Key::ENTER}, true).has_value();
}

void Monitor::let_go() {
  if (std::exchange(is_enter_held_, false)) session_.send_keys(std::array{Key::ENTER}, false);
}

// From where the control says it stands, or from our own last turn that it has not shown yet.
void Monitor::turn(int percent) {
  const bool is_on_its_way = turned_ && turned_->number > session_.handled_key();
  const int now = is_on_its_way ? turned_->percent : shown_potentiometer(session_.screen()).value_or(100);
  const int wanted = std::clamp(now + percent, 0, 100);
  if (const auto number = session_.send_potentiometer(static_cast<std::uint32_t>(wanted))) turned_ = {*number, wanted};
}

void Monitor::release_due() {
  if (!session_.is_online()) {
    releases_.clear();  // the server releases what a lost station held
    turned_.reset();
    is_enter_held_ = false;
  }
  if (is_enter_held_ && !shows_external_data(session_.screen())) let_go();
  const auto now = Clock::now();
  std::erase_if(releases_, [&](const Release& release) {
    if (release.due > now) return false;
    session_.send_keys(release.keys, false);
    return true;
  });
}

void Monitor::sound() {
  const auto now = Clock::now();
  const bool is_tone_due = session_.has_alarm_tone() && now >= next_tone_;
  if (is_tone_due) next_tone_ = now + kTone;
  if (session_.take_beeps() > 0 || is_tone_due) terminal_.beep();
}

Screen Monitor::shown() const {
  const Language language = session_.language();
  const auto since = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - session_.lost_since());
  if (view_ == View::help) {
    const Screen help = help_screen(help_start_, language);
    return session_.is_lost() ? with_lost_heading(help, since, language) : help;
  }
  const bool looks_on = !session_.may_press();
  Screen screen = session_.screen();
  if (looks_on) screen = with_looking_on(screen, session_.station(), language);
  if (session_.is_lost()) screen = with_lost_line(screen, since, session_.trouble(), language);
  if (view_ == View::new_password) return password_.over(screen, language);
  return view_ == View::log_out_question ? with_log_out_question(screen, looks_on, language) : screen;
}

void Monitor::draw() {
  if (!has_room(terminal_, session_.language())) return;
  terminal_.clear();
  terminal_.draw(shown());
  if (terminal_.rows() >= Screen::kRows + KeyboardView::kRows && session_.may_press()) draw_keyboard();
  terminal_.flush();
}

void Monitor::draw_keyboard() {
  const KeyboardView keyboard(session_.language(), terminal_.is_ascii());
  for (const auto& title : keyboard.titles()) terminal_.write(Screen::kRows, title.column, title.text, Attribute::dim);
  for (const KeyCap& cap : keyboard.caps()) {
    const bool is_lit = cap.binding == lit_ && Clock::now() < lit_until_;
    const int row = Screen::kRows + cap.row;
    terminal_.write(row, cap.column, centred(cap.label, cap.width), is_lit ? Attribute::bold : Attribute::inverse,
                    colour_of(*cap.binding));
    terminal_.write(row + 1, cap.column, centred(cap.hint, cap.width), Attribute::dim);
  }
}

Monitor::Clock::time_point Monitor::next_deadline() const {
  const auto now = Clock::now();
  auto next = Clock::time_point::max();
  if (lit_until_ > now) next = std::min(next, lit_until_);
  for (const Release& release : releases_) next = std::min(next, release.due);
  if (session_.has_alarm_tone()) next = std::min(next, next_tone_);
  if (session_.is_lost()) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - session_.lost_since());
    next = std::min(next, session_.lost_since() + seconds + 1s);
  }
  return next;
}

}  // namespace cnclab::station
