// Keys in, ticks on, pictures out.
#include "bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "language/tape.hpp"

namespace cnclab::panel {

namespace {

constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr int kMsPerPoll = 10;

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

Memory memory_of(const std::string& tape, int memory_bytes) {
  Memory memory(memory_bytes);
  if (tape.empty()) return memory;
  language::Tape read = language::read_tape(tape, language::Reading::file);
  for (const language::Error& error : read.errors) ADD_FAILURE() << explain(error, language::Tongue::german);
  for (language::ReadProgram& program : read.programs) memory.put_program(std::move(program.program));
  return memory;
}

Bench::Bench(const Setup& setup)
    : machine(setup.data),
      channel(std::make_shared<machine::Channel>(machine, setup.data)),
      control(setup.settings, memory_of(setup.tape, setup.settings.memory_bytes), setup.data) {
  side.station = 7;
  side.user = "schueler07";
  side.on_lab_machine = setup.is_lab_machine;
  side.controlling_station = 3;
  constexpr machine::Epoch kEpoch{1};
  channel->grant(kEpoch, machine::kNeverExpires);
  control.connect({channel, kEpoch, setup.is_lab_machine, setup.lab_data});
  run_for(kMsPerPoll);
}

void Bench::answer(const Outcome& outcome) {
  line_news.insert(line_news.end(), outcome.line_news.begin(), outcome.line_news.end());
  if (outcome.remote_start) {
    remote_starts.push_back(*outcome.remote_start);
    answer(control.answer_remote_start(remote_refusal, now));
  }
  if (outcome.media) {
    std::expected<std::string, std::string> reply;
    if (const auto* put = std::get_if<PutFiles>(&*outcome.media))
      for (const MediaFile& file : put->files) media[file.name] = file.bytes;
    if (const auto* get = std::get_if<GetFile>(&*outcome.media)) {
      const auto there = std::ranges::find_if(get->names, [&](const auto& name) { return media.contains(name); });
      if (there == get->names.end())
        reply = std::unexpected("Datei " + get->names.front() + " fehlt.");
      else
        reply = media.at(*there);
    }
    control.media_done(reply);
    return answer(control.poll(now));
  }
  if (!outcome.store) return;  // what does not leave with an outcome is never stored
  ++stores_;
  control.store_done(next_store_error_.value_or(""));
  next_store_error_.reset();
}

void Bench::press(Key key) {
  const Outcome outcome = control.press(key, now);
  control.release(key, now);
  answer(outcome);
}

void Bench::keys(std::string_view names) {
  std::istringstream stream{std::string(names)};
  for (std::string name; stream >> name;) {
    const std::vector<Key> chord = keys_of(name);
    ASSERT_FALSE(chord.empty()) << "no key is called " << name;
    if (chord.size() == 1) {
      press(chord.front());
    } else {
      answer(control.press_chord(chord, now));
    }
  }
}

void Bench::type(std::string_view text) {
  for (const char figure : text) {
    if (figure == '.') press(Key::POINT);
    if (figure == '-') press(Key::SIGN);
    if (figure >= '0' && figure <= '9') press(static_cast<Key>(static_cast<int>(Key::D0) + (figure - '0')));
  }
}

void Bench::run_for(int ms) {
  for (int i = 0; i < ms; ++i) {
    now.monotonic_ns += kNsPerMs;
    channel->tick(now.monotonic_ns, 0.001);
    if (now.monotonic_ns / kNsPerMs % kMsPerPoll == 0) answer(control.poll(now));
  }
}

void Bench::hold(Key key, int ms) {
  answer(control.press(key, now));
  run_for(ms);
  control.release(key, now);
}

bool Bench::run_until(const std::function<bool()>& condition, int most_ms) {
  for (int passed = 0; passed < most_ms; passed += kMsPerPoll) {
    if (condition()) return true;
    run_for(kMsPerPoll);
  }
  return condition();
}

bool Bench::run_to_rest(int most_ms) {
  run_for(2 * kMsPerPoll);
  return run_until(
      [this] {
        const auto state = snapshot().state;
        const bool moves = state == machine::MotionState::moving || state == machine::MotionState::stopping;
        return !control.is_running() && !snapshot().started && !moves;
      },
      most_ms);
}

Screen Bench::screen() const {
  SideView view = side;
  view.override_percent = control.override_percent();
  return control.draw(now, view);
}

std::string Bench::row(int index) const { return trimmed(screen().text(index)); }

std::string Bench::monitor(int index) const {
  const std::u32string cells = from_utf8(screen().text(index + 1));
  std::string line;
  for (std::size_t column = 1; column <= 64; ++column) line += to_utf8(cells.at(column));
  return trimmed(line);
}

std::string Bench::picture() const {
  const Screen drawn = screen();
  std::string picture;
  for (int index = 0; index < Screen::kRows; ++index) picture += trimmed(drawn.text(index)) + "\n";
  return picture;
}

std::vector<std::string> Bench::marks() const {
  const Screen drawn = screen();
  std::vector<std::string> marks;
  for (int index = 0; index < Screen::kRows; ++index) {
    for (int column = 0, length = 0; column < Screen::kColumns; column += length + 1) {
      length = 0;
      while (column + length < Screen::kColumns && drawn.at(index, column + length).attribute == Attribute::inverse)
        ++length;
      if (length > 0)
        marks.push_back(std::to_string(index) + " " + std::to_string(column) + " " + std::to_string(length));
    }
  }
  return marks;
}

}  // namespace cnclab::panel
