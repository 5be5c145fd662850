// KEY-090: every key in every mode of the table, as data and as pressed on a control.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "bench.hpp"
#include "panel/key_table.hpp"

namespace cnclab::panel {
namespace {

/// A line of the matrix for the columns that this control has; "-" is ignored, "AU: on" marks START state of AUTOMAT.
struct MatrixRow {
  std::string_view keys;
  Effect menu, automat, editor, started;
};

constexpr Effect kNo = Effect::ignored;

// Copied from the matrix KEY-090: columns MN, AU, EM and START state.
constexpr MatrixRow kMatrix[] = {
    {"HAND", Effect::open_hand, kNo, kNo, kNo},
    {"START", kNo, Effect::start, kNo, Effect::start},  // START state: only while the program waits (KEY-013)
    {"STOP", kNo, kNo, kNo, Effect::stop},
    {"PLUS_X MINUS_X PLUS_Y MINUS_Y PLUS_Z MINUS_Z", kNo, kNo, kNo, kNo},
    {"ISTWERT FRAESER KUEHLMITTEL", kNo, kNo, kNo, kNo},
    {"AUTOMAT", Effect::open_automat, kNo, kNo, kNo},
    {"GRAFIK", Effect::open_graphics, kNo, kNo, kNo},
    {"MENU", kNo, Effect::open_menu, Effect::open_menu, kNo},
    {"EINZELSATZ", kNo, Effect::single_block, kNo, Effect::single_block},
    {"REFERENZ", kNo, kNo, kNo, kNo},
    {"EXTERNE_DATEN", Effect::open_external_data, kNo, kNo, kNo},
    {"TEACH_IN", Effect::open_teach_in, kNo, kNo, kNo},
    {"SATZ_SUCHEN", kNo, kNo, Effect::search, kNo},
    {"SPEICHER_LOESCHEN", Effect::open_erase_memory, kNo, kNo, kNo},
    {"EINGABE", Effect::open_editor, kNo, Effect::store, kNo},
    {"HANDEINGABE", Effect::open_hand_input, kNo, kNo, kNo},
    {"SATZ_LOESCHEN", kNo, kNo, Effect::erase_block, kNo},
    {"0 1 2 3 4 5 6 7 8 9", kNo, Effect::digit, Effect::digit, kNo},
    {"POINT", kNo, kNo, Effect::point, kNo},
    {"SIGN", kNo, kNo, Effect::sign, kNo},
    {"DOWN", kNo, kNo, Effect::down, kNo},
    {"CLEAR", kNo, Effect::clear, Effect::clear, kNo},
    {"ENTER", kNo, Effect::enter, Effect::enter, kNo},
    {"MELDUNG MASCHINE_HALT LABOR RESET", kNo, kNo, kNo, kNo},  // the lab's own; RESET acts apart from the table
};

constexpr std::array kEditor{Place::editor_program, Place::editor_number, Place::editor_function, Place::editor_word};
constexpr std::array kAutomat{Place::automat_program, Place::automat_block, Place::automat_ready};
constexpr std::array kStarted{Place::automat_running, Place::automat_waiting};
constexpr std::array kMenu{Place::menu};

/// All effects that a key has in the places of one column.
std::set<Effect> effects_in(std::span<const Place> places, Key key) {
  std::set<Effect> effects;
  for (const Place place : places)
    if (const Effect effect = effect_of(place, key); effect != Effect::ignored) effects.insert(effect);
  return effects;
}

std::vector<Key> keys_in(std::string_view names) {
  std::vector<Key> keys;
  while (!names.empty()) {
    const std::size_t blank = names.find(' ');
    keys.push_back(key_of(names.substr(0, blank)).value());
    names.remove_prefix(blank == std::string_view::npos ? names.size() : blank + 1);
  }
  return keys;
}

TEST(KeyTable, KEY_090_EveryCellOfTheMatrixForMenuAutomatAndEntry) {
  std::set<Key> seen;
  for (const MatrixRow& row : kMatrix) {
    for (const Key key : keys_in(row.keys)) {
      SCOPED_TRACE(std::string(name_of(key)));
      seen.insert(key);
      const auto only = [](Effect effect) { return effect == kNo ? std::set<Effect>{} : std::set{effect}; };
      EXPECT_EQ(effects_in(kMenu, key), only(row.menu)) << "MN";
      EXPECT_EQ(effects_in(kAutomat, key), only(row.automat)) << "AU";
      EXPECT_EQ(effects_in(kEditor, key), only(row.editor)) << "EM";
      EXPECT_EQ(effects_in(kStarted, key), only(row.started)) << "START state";
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(kKeys)) << "every key of the keyboard is in the matrix";
}

TEST(KeyTable, KEY_013_StartIsPolledInStartStateOnlyWhileTheProgramWaits) {
  EXPECT_EQ(effect_of(Place::automat_running, Key::START), Effect::ignored);
  EXPECT_EQ(effect_of(Place::automat_waiting, Key::START), Effect::start);
}

TEST(KeyTable, MOD_014_015_DirectChangesLeadOnlyThroughHandbetrieb) {
  const std::map<std::pair<Place, Key>, Effect> allowed{{{Place::hand, Key::HANDEINGABE}, Effect::open_hand_input},
                                                        {{Place::hand, Key::TEACH_IN}, Effect::open_teach_in},
                                                        {{Place::hand_input, Key::HAND}, Effect::open_hand},
                                                        {{Place::teach_in, Key::HAND}, Effect::open_hand}};
  for (const Place place : {Place::hand, Place::hand_input, Place::teach_in}) {
    for (int i = 1; i <= kKeys; ++i) {
      const auto key = static_cast<Key>(i);
      const auto found = allowed.find({place, key});
      const Effect expected = key == Key::MENU ? Effect::open_menu : found == allowed.end() ? kNo : found->second;
      EXPECT_EQ(effect_of(place, key), expected) << name_of(key);
    }
  }
}

TEST(KeyTable, KeysOfAPlaceDoNotOverlap) {
  for (const KeyRow& row : key_table())
    for (const KeyRow& other : key_table())
      if (&row != &other && row.place == other.place) {
        EXPECT_TRUE(row.last < other.first || other.last < row.first) << name_of(row.first);
      }
}

/// The monitor and what is kept: an ignored key changes neither (KEY conventions).
std::string visible_state(const Bench& bench) {
  std::string text = bench.control.save_state();
  for (int line = 0; line < 16; ++line) text += bench.monitor(line) + "\n";
  return text;
}

struct Scene {
  std::string_view name;
  std::string_view keys;
  Place place;
};

constexpr Scene kScenes[] = {
    {"MN", "", Place::menu},
    {"EM program", "EINGABE", Place::editor_program},
    {"EM number", "EINGABE ENTER", Place::editor_number},
    {"EM function", "EINGABE ENTER ENTER", Place::editor_function},
    {"EM word", "EINGABE ENTER ENTER ENTER", Place::editor_word},
    {"AU program", "AUTOMAT", Place::automat_program},
    {"AU block", "AUTOMAT ENTER", Place::automat_block},
    {"AU ready", "AUTOMAT ENTER ENTER", Place::automat_ready},
    {"HA", "HAND", Place::hand},
    {"GR", "GRAFIK", Place::graphics},
    {"SL", "SPEICHER_LOESCHEN", Place::erase_memory},
};

TEST(Keys, KEY_090_IgnoredKeysChangeNeitherMonitorNorState) {
  for (const Scene& scene : kScenes) {
    for (int i = 1; i <= kKeys; ++i) {
      const auto key = static_cast<Key>(i);
      if (effect_of(scene.place, key) != Effect::ignored || key == Key::RESET) continue;
      SCOPED_TRACE(std::string(scene.name) + " " + std::string(name_of(key)));
      Bench bench({.tape = std::string(kBild7)});
      bench.keys(scene.keys);
      const std::string before = visible_state(bench);
      bench.press(key);
      EXPECT_EQ(visible_state(bench), before);
      EXPECT_EQ(bench.stores(), 0);
      EXPECT_EQ(bench.control.take_beeps(), 0);
    }
  }
}

TEST(Keys, KEY_011_012_InStartStateOnlyStopAndEinzelsatzActAndTheRunGoesOn) {
  for (int i = 1; i <= kKeys; ++i) {
    const auto key = static_cast<Key>(i);
    if (key == Key::STOP || key == Key::EINZELSATZ || key == Key::RESET) continue;
    SCOPED_TRACE(std::string(name_of(key)));
    Bench bench({.tape = std::string(kBild7)});
    bench.keys("AUTOMAT ENTER ENTER START");
    bench.run_for(100);
    bench.press(key);
    EXPECT_TRUE(bench.control.is_running());
    EXPECT_EQ(bench.control.mode(), Mode::automat);
  }
}

TEST(Keys, D_121_ResetStopsSwitchesOffAndLeadsToTheMenu) {
  Bench bench({.tape = "P0001N001G11F1000M13N002G01X+100000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(500);
  ASSERT_TRUE(bench.snapshot().coolant);
  bench.press(Key::RESET);
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  bench.run_for(2000);
  EXPECT_FALSE(bench.snapshot().started);
  EXPECT_EQ(bench.snapshot().speed_mm_per_min, 0);
  EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(bench.snapshot().coolant);
  bench.keys("AUTOMAT");
  EXPECT_TRUE(bench.monitor(2).contains("G17 G40 G45 G74 G91 F0000 S0000 T00 M12")) << bench.monitor(2);
}

TEST(Keys, ChordsOpenTheServiceModesExceptOnTheLabsMachine) {
  Bench own;
  own.keys("3+6+9");
  EXPECT_EQ(own.control.mode(), Mode::memory_test);
  own.keys("ENTER+RESET");
  EXPECT_EQ(own.control.mode(), Mode::machine_data);
  own.keys("DOWN+RESET");
  EXPECT_EQ(own.control.mode(), Mode::menu);

  Bench lab({.is_lab_machine = true});
  lab.keys("3+6+9");
  EXPECT_EQ(lab.control.mode(), Mode::menu);
  EXPECT_FALSE(lab.row(18).empty());
  lab.keys("ENTER+RESET");
  EXPECT_EQ(lab.control.mode(), Mode::menu) << "DEC-39";
}

}  // namespace
}  // namespace cnclab::panel
