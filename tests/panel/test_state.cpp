// What outlives a login (SEAT-002, SEAT-004), the texts in both languages, and storms of keys.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "bench.hpp"
#include "panel/screen/canvas.hpp"
#include "panel/screen/names.hpp"
#include "panel/screen/texts.hpp"

namespace cnclab::panel {
namespace {

std::string monitor_of(const Bench& bench) {
  std::string text;
  for (int line = 0; line < 16; ++line) text += bench.monitor(line) + "\n";
  return text;
}

struct Kept {
  std::string_view name, keys, typed;
};

constexpr Kept kKept[] = {
    {"menu", "", ""},
    {"program prompt", "EINGABE CLEAR", "12"},
    {"overview", "EINGABE CLEAR ENTER", ""},
    {"number", "EINGABE ENTER", "4"},
    {"function", "EINGABE ENTER ENTER", "0"},
    {"word half typed", "EINGABE ENTER ENTER ENTER ENTER", "-12.3"},
    {"loaded block", "EINGABE ENTER 3 SATZ_SUCHEN ENTER ENTER", "7"},
    {"parameter begun", "EINGABE ENTER ENTER ENTER DOWN", ""},
    {"tool row", "EINGABE CLEAR 0 ENTER ENTER", "5."},
    {"automat block", "AUTOMAT ENTER CLEAR", "3"},
    {"automat ready", "AUTOMAT ENTER ENTER", ""},
    {"erase prompt", "SPEICHER_LOESCHEN 4 ENTER", "1"},
    {"external data", "EXTERNE_DATEN", ""},
    {"hand", "HAND", ""},
    {"hand, actual value", "HAND ISTWERT", ""},
    {"hand input", "HANDEINGABE", "9"},
    {"hand input, half a word", "HANDEINGABE ENTER ENTER", "-12.3"},
    {"teach in prompt", "TEACH_IN CLEAR", "4"},
    {"teach in", "TEACH_IN ENTER", ""},
    {"grafik prompt", "GRAFIK CLEAR", "4"},
    {"machine data, the clock", "ENTER+RESET", ""},
    {"machine data, half a value", "ENTER+RESET ENTER ENTER ENTER ENTER ENTER", "12"},
    {"teach in, half a word", "TEACH_IN ENTER ENTER ENTER ENTER ENTER", "12"},
};

TEST(State, SEAT_002_EveryScreenComesBackAndTypingGoesOn) {
  for (const Kept& kept : kKept) {
    SCOPED_TRACE(std::string(kept.name));
    Bench before({.tape = std::string(kBild7)});
    before.keys(kept.keys);
    before.type(kept.typed);
    Bench after({.tape = std::string(kBild7)});
    after.control.restore_state(before.control.save_state());
    after.run_for(10);
    EXPECT_EQ(monitor_of(after), monitor_of(before));
    EXPECT_EQ(after.control.save_state(), before.control.save_state());
    before.type("5");
    after.type("5");
    EXPECT_EQ(monitor_of(after), monitor_of(before));
    before.keys("EINGABE");
    after.keys("EINGABE");
    EXPECT_EQ(monitor_of(after), monitor_of(before));
  }
}

TEST(State, SEAT_002_TheDeviceOfExternalDataAndItsPromptComeBack) {
  Bench before({.tape = std::string(kBild7)});
  before.control.insert_cassette({}, before.now);
  before.keys("EXTERNE_DATEN 6 SIGN");
  before.type("12");
  const auto restored = [&](bool with_cassette) {
    auto after = std::make_unique<Bench>(Bench::Setup{.tape = std::string(kBild7)});
    after->control.restore_state(before.control.save_state());
    if (with_cassette) after->control.insert_cassette({}, after->now);
    after->run_for(10);
    return after;
  };
  const auto after = restored(true);
  EXPECT_EQ(monitor_of(*after), monitor_of(before));
  after->type("3");
  EXPECT_TRUE(after->monitor(8).contains("□0123")) << "typing goes on: " << after->monitor(8);
  const auto without = restored(false);
  without->keys("ENTER");
  EXPECT_TRUE(without->row(18).starts_with("Keine Kassette eingelegt.")) << without->row(18);
  EXPECT_FALSE(without->control.is_busy());
}

TEST(State, SEAT_002_CForEverythingHasToBePressedAgain) {
  Bench before({.tape = std::string(kBild7)});
  before.control.insert_cassette({}, before.now);
  before.keys("EXTERNE_DATEN 6 CLEAR");
  Bench after({.tape = std::string(kBild7)});
  after.control.insert_cassette({}, after.now);
  after.control.restore_state(before.control.save_state());
  after.keys("ENTER");
  EXPECT_FALSE(after.control.recorder_runs()) << "a whole memory would replace all programs";
}

/// Functions that leave spindle or coolant on, and others.
struct KeptM {
  std::string_view m, shown;
};

TEST(State, SEAT_004_TheMOfTheStatusLineComesBackAsTheMachineIs) {
  for (const auto& [m, shown] : {KeptM{"03", "M12"}, {"04", "M12"}, {"08", "M12"}, {"13", "M12"}, {"05", "M05"}}) {
    SCOPED_TRACE(std::string(m));
    Bench before;
    before.keys("HANDEINGABE 1 1 ENTER ENTER ENTER ENTER");
    before.type(m);
    before.keys("START");
    ASSERT_TRUE(before.run_to_rest());
    ASSERT_TRUE(before.monitor(3).contains("M" + std::string(m))) << before.monitor(3);
    Bench after;
    after.control.restore_state(before.control.save_state());
    after.run_for(10);
    EXPECT_TRUE(after.monitor(3).contains(shown)) << after.monitor(3);
  }
}

TEST(State, SEAT_002_ACounterBehindTheLargestWordComesBack) {
  Bench before;
  before.keys("HAND ISTWERT PLUS_X");
  before.type("9999.9");
  before.keys("ISTWERT PLUS_X START");
  ASSERT_TRUE(before.run_until([&] { return before.istwert(0) > 10'005; }, 20'000));
  before.keys("STOP");
  ASSERT_TRUE(before.run_to_rest());
  Bench after;
  after.control.restore_state(before.control.save_state());
  after.run_for(20);
  EXPECT_NEAR(after.istwert(0), before.istwert(0), 1e-9);
}

TEST(State, SEAT_004_ModalStateIstwertAndPotentiometerComeBackInStop) {
  Bench before({.tape = "P0001N001G90N002G01X+12500F600T03M03N003G01X+99000%"});
  before.control.set_override(80);
  before.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(before.run_until([&] { return before.row(18).contains("N003"); }));
  const std::string json = before.control.save_state();

  Bench after({.tape = "P0001N001G90N002G01X+12500F600T03M03N003G01X+99000%"});
  after.control.restore_state(json);
  after.run_for(20);
  EXPECT_FALSE(after.control.is_running());
  EXPECT_EQ(after.control.override_percent(), 80);
  EXPECT_TRUE(after.monitor(2).contains("G90 F0600 S0000 T03 M12")) << after.monitor(2);
  EXPECT_TRUE(after.monitor(2).contains("X  +0012.5")) << after.monitor(2);
  EXPECT_EQ(after.snapshot().spindle, geometry::SpindleTurn::off);
}

/// What a CNC 3300 has in force, kept; then the instructor makes it a CNC 3250.
struct KeptBy3300 {
  std::string_view name, keys, requirement;
};

constexpr KeptBy3300 kKeptBy3300[] = {
    {"G90", "HANDEINGABE 9 0 START", "MODEL-010"},
    {"G18", "HANDEINGABE 1 8 START", "MODEL-009"},
    {"G43", "HANDEINGABE 1 1 ENTER 6 0 0 ENTER ENTER 0 1 START MENU HANDEINGABE 4 3 START", "MODEL-009"},
    {"G46", "HANDEINGABE 1 1 ENTER 6 0 0 ENTER ENTER 0 1 START MENU HANDEINGABE 4 6 START", "MODEL-009"},
    {"GRAFIK", "GRAFIK", "MODEL-003"},
};

TEST(State, MODEL_003_MODEL_007_MODEL_009_MODEL_010_ADifferentModelKeepsOnlyWhatItHas) {
  constexpr std::string_view kTools = "P0000T001R+5000L+2000P0001N001G01X+1000%";
  for (const KeptBy3300& kept : kKeptBy3300) {
    SCOPED_TRACE(std::string(kept.name) + " " + std::string(kept.requirement));
    Bench before({.tape = std::string(kTools)});
    std::string keys(kept.keys);
    for (std::size_t from = 0, at = 0; at != std::string::npos; from = at + 6) {
      at = keys.find(" START", from);
      before.keys(keys.substr(from, at == std::string::npos ? at : at + 6 - from));
      ASSERT_TRUE(before.run_to_rest());
      if (at == std::string::npos) break;
    }
    Settings small;
    small.vocabulary.model = language::Model::cnc3250;
    Bench after({.settings = small, .tape = std::string(kTools)});
    after.control.restore_state(before.control.save_state());
    after.run_for(20);
    after.keys("MENU HANDEINGABE");
    ASSERT_EQ(after.control.mode(), Mode::hand_input);
    after.keys("0 0 ENTER 1 0 START");
    ASSERT_TRUE(after.run_to_rest());
    after.keys("MENU HANDEINGABE 0 0 ENTER 1 0 START");
    ASSERT_TRUE(after.run_to_rest());
    EXPECT_EQ(after.istwert(0), 20) << "two ways of 10 mm, incremental and uncompensated";
  }
}

TEST(State, MODEL_003_A3250DoesNotComeUpInGrafik) {
  Bench before({.tape = std::string(kBild7)});
  before.keys("GRAFIK");
  ASSERT_EQ(before.control.mode(), Mode::graphics);
  Settings small;
  small.vocabulary.model = language::Model::cnc3250;
  Bench after({.settings = small, .tape = std::string(kBild7)});
  after.control.restore_state(before.control.save_state());
  EXPECT_EQ(after.control.mode(), Mode::menu);
}

TEST(State, STO_001_DEC_10_AClockOfItsOwnGoesOnFromWhereItStood) {
  Bench before;
  before.now.wall = {0, 0, 0, 0, 0, 0};  // [control] clock = "original"
  before.keys("ENTER+RESET");
  before.type("101112");
  before.keys("ENTER");
  before.type("830711");
  before.keys("ENTER MENU");
  before.run_for(1500);
  Bench after;
  after.now.wall = before.now.wall;
  after.now.monotonic_ns = 99'000'000'000;
  after.control.restore_state(before.control.save_state());
  after.run_for(20);
  EXPECT_TRUE(after.row(1).contains("10:11:13 11/07/83")) << after.row(1);
  after.run_for(3000);
  EXPECT_TRUE(after.row(1).contains("10:11:16 11/07/83")) << after.row(1);
}

constexpr std::string_view kBroken[] = {
    "",
    "{",
    "[]",
    "null",
    "7",
    "{}",
    R"({"mode":5})",
    R"({"mode":"EINGABEMODUS","editor":7})",
    R"({"mode":"EINGABEMODUS","editor":{"program":{"value":1,"typed":9},"open":true,"line":{"marker":2,"word":9}}})",
    R"({"mode":"EINGABEMODUS","editor":{"program":{"value":99999},"open":true,"list_from":-3,"overview":1e99}})",
    R"({"mode":"EINGABEMODUS","editor":{"program":{"value":1},"open":true,"plane":7,"line":{"shown":[0,1],"words":[{},[],3]}}})",
    R"({"mode":"AUTOMAT","automat":{"phase":2,"program":{"value":4711},"block":{"value":-1}}})",
    R"({"mode":"HANDEINGABE","hand_input":{"plane":9,"line":{"marker":2,"word":3,"shown":[0,2],"words":[{},{}]}}})",
    R"({"mode":"TEACH IN","teach_in":{"program":{"value":9983},"open":true,"line":{},"reference":[1,"a"]},"taught":[]})",
    R"({"mode":"HANDBETRIEB","hand":{"istwert":4}})",
    R"({"mode":"AUTOMAT","automat":{"phase":99,"program":[],"block":null}})",
    R"({"modal":{"plane":99,"radius":-1,"scale":[1,2],"f":-5,"m":1e300},"istwert":["a",{},1e400]})",
    R"({"parameters":{"4":99999999999999999999,"70":1},"override":1000,"istwert":[1,2]})",
    "\xff\xfe{\"mode\"",
};

TEST(State, AnyTextIsTakenWithoutHarm) {
  for (const std::string_view text : kBroken) {
    SCOPED_TRACE(std::string(text));
    Bench bench({.tape = std::string(kBild7)});
    bench.control.restore_state(std::string(text));
    bench.run_for(20);
    (void)bench.picture();
    bench.keys("1 ENTER ENTER START EINGABE DOWN");
    bench.run_for(50);
    EXPECT_GE(bench.control.override_percent(), 0);
    EXPECT_LE(bench.control.override_percent(), 100);
  }
}

RC_GTEST_PROP(State, DamagedTextIsTakenWithoutHarm, (std::uint16_t place, char byte)) {
  Bench bench({.tape = std::string(kBild7)});
  bench.keys("EINGABE ENTER 3 SATZ_SUCHEN ENTER ENTER ENTER 5");
  std::string json = bench.control.save_state();
  json[place % json.size()] = byte;
  bench.control.restore_state(json);
  (void)bench.picture();
  bench.keys("1 ENTER DOWN EINGABE");
}

TEST(Texts, DEC_02_BothLanguagesAreCompleteAndTakeTheSameValues) {
  for (const TextRow& row : text_table()) {
    SCOPED_TRACE(std::string(row.german));
    EXPECT_FALSE(row.german.empty());
    EXPECT_FALSE(row.english.empty());
    const auto values = [](std::string_view text) {
      int count = 0;
      for (std::size_t at = text.find("{}"); at != std::string_view::npos; at = text.find("{}", at + 2)) ++count;
      return count;
    };
    EXPECT_EQ(values(row.german), values(row.english));
  }
}

TEST(Texts, SentencesAndTitlesFitTheirPlaces) {
  for (const TextRow& row : text_table()) {
    EXPECT_LE(columns_of(row.german), 2 * Screen::kColumns) << row.german;
    EXPECT_LE(columns_of(row.english), 2 * Screen::kColumns) << row.english;
  }
  for (int i = 0; i < kModes; ++i) {
    const auto mode = static_cast<Mode>(i);
    EXPECT_FALSE(name_of(mode).empty());
    EXPECT_LE(columns_of(title_of(mode, language::Tongue::english)), 27) << "between model and clock";
  }
}

/// A key of the keyboard; entry keys come more often than others.
Key random_key(std::mt19937& random) {
  std::uniform_int_distribution<int> any(1, kKeys), percent(0, 99);
  if (percent(random) < 55) return static_cast<Key>(static_cast<int>(Key::D0) + any(random) % 10);
  if (percent(random) < 40) return Key::ENTER;
  return static_cast<Key>(any(random));
}

class Storm : public testing::TestWithParam<unsigned> {};

TEST_P(Storm, NeverStoresWithoutEingabeNeverBelowZeroNeverThrows) {
  std::mt19937 random(GetParam());
  Bench::Setup setup;
  setup.settings.memory_bytes = 400;
  setup.tape = kBild7;
  Bench bench(setup);
  constexpr int kKeysPressed = 4000;
  for (int i = 0; i < kKeysPressed; ++i) {
    const Key key = random_key(random);
    const int stores = bench.stores();
    const Mode mode = bench.control.mode();
    const int free_before = bench.control.memory().free_bytes();
    bench.press(key);
    if (bench.stores() != stores) {
      const bool confirms = mode == Mode::erase_memory || mode == Mode::machine_data;
      EXPECT_TRUE(key == Key::EINGABE || key == Key::SATZ_LOESCHEN || (confirms && key == Key::ENTER)) << name_of(key);
    } else {
      EXPECT_EQ(bench.control.memory().free_bytes(), free_before);
    }
    ASSERT_GE(bench.control.memory().free_bytes(), 0);
    if (i % 7 == 0) bench.run_for(10);
    if (i % 50 == 0) bench.control.set_override(static_cast<int>(random() % 101));
    if (i % 20 == 0) (void)bench.picture();
    if (i % 500 == 0) bench.control.restore_state(bench.control.save_state());
  }
  for (const language::Program& program : bench.control.memory().programs()) {
    EXPECT_TRUE(std::ranges::is_sorted(program.blocks, {}, &language::Block::number));
    EXPECT_FALSE(language::is_reserved_for_cycles(program.number)) << "DEC-06";
  }
}

INSTANTIATE_TEST_SUITE_P(Keys, Storm, testing::Range(1U, 9U));

}  // namespace
}  // namespace cnclab::panel
