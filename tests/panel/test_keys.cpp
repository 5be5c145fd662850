// KEY-090: every key in every mode of the table, as data and as pressed on a control.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "bench.hpp"
#include "panel/key_table.hpp"
#include "panel/screen/names.hpp"

namespace cnclab::panel {
namespace {

// The matrix KEY-090 as the manual has it, column by column: MN HA HE TI AU XD GR SL EM MDM. "-" is ignored.
//
//   move, run … the mode's own effect; → opens a mode. GR is DEC-37; MENU is ignored in a transfer of XD (D-107).
struct MatrixRow {
  std::string_view keys;
  std::array<std::string_view, 10> cells;
};

constexpr MatrixRow kMatrix[] = {
    {"HAND", {"open_hand", "-", "open_hand", "open_hand", "-", "-", "-", "-", "-", "-"}},
    {"START", {"-", "start", "start", "start", "start", "-", "start", "-", "-", "-"}},
    {"STOP", {"-", "stop", "-", "stop", "-", "stop", "stop", "-", "-", "-"}},
    {"PLUS_X MINUS_X PLUS_Y MINUS_Y PLUS_Z MINUS_Z",
     {"-", "direction", "-", "direction", "-", "-", "direction", "-", "-", "-"}},
    {"ISTWERT", {"-", "istwert", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"FRAESER", {"-", "spindle", "-", "spindle", "-", "-", "-", "-", "-", "-"}},
    {"KUEHLMITTEL", {"-", "coolant", "-", "coolant", "-", "-", "-", "-", "-", "-"}},
    {"AUTOMAT", {"open_automat", "-", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"GRAFIK", {"open_graphics", "-", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"MENU", {"-", "menu", "menu", "menu", "menu", "menu", "menu", "menu", "menu", "menu"}},
    {"EINZELSATZ", {"-", "-", "-", "-", "single", "-", "single", "-", "-", "-"}},
    {"REFERENZ", {"-", "reference", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"EXTERNE_DATEN", {"open_external", "-", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"TEACH_IN", {"open_teach", "open_teach", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"SATZ_SUCHEN", {"-", "-", "-", "-", "-", "-", "-", "-", "search", "-"}},
    {"SPEICHER_LOESCHEN", {"open_erase", "-", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"EINGABE", {"open_editor", "-", "-", "store", "-", "-", "-", "-", "store", "enter"}},
    {"HANDEINGABE", {"open_input", "open_input", "-", "-", "-", "-", "-", "-", "-", "-"}},
    {"SATZ_LOESCHEN", {"-", "-", "-", "-", "-", "-", "-", "-", "erase", "-"}},
    {"0 1 2 3 4 5 6 7 8 9", {"-", "digit", "digit", "digit", "digit", "digit", "digit", "digit", "digit", "digit"}},
    {"POINT", {"-", "point", "point", "point", "-", "-", "-", "-", "point", "-"}},
    {"SIGN", {"-", "sign", "sign", "sign", "-", "sign", "-", "-", "sign", "-"}},
    {"DOWN", {"-", "-", "-", "-", "-", "-", "down", "-", "down", "-"}},
    {"CLEAR", {"-", "clear", "clear", "clear", "clear", "clear", "clear", "clear", "clear", "clear"}},
    {"ENTER", {"-", "-", "enter", "enter", "enter", "enter", "enter", "enter", "enter", "enter"}},
    {"MELDUNG MASCHINE_HALT LABOR RESET",  // the lab's own; RESET acts apart from the table
     {"-", "-", "-", "-", "-", "-", "-", "-", "-", "-"}},
};

struct NamedEffect {
  std::string_view name;
  Effect effect;
};

constexpr NamedEffect kEffects[] = {
    {"open_hand", Effect::open_hand},
    {"open_input", Effect::open_hand_input},
    {"open_teach", Effect::open_teach_in},
    {"open_automat", Effect::open_automat},
    {"open_external", Effect::open_external_data},
    {"open_graphics", Effect::open_graphics},
    {"open_erase", Effect::open_erase_memory},
    {"open_editor", Effect::open_editor},
    {"menu", Effect::open_menu},
    {"start", Effect::start},
    {"stop", Effect::stop},
    {"direction", Effect::direction},
    {"istwert", Effect::istwert},
    {"spindle", Effect::spindle},
    {"coolant", Effect::coolant},
    {"single", Effect::single_block},
    {"reference", Effect::reference},
    {"search", Effect::search},
    {"store", Effect::store},
    {"enter", Effect::enter},
    {"erase", Effect::erase_block},
    {"digit", Effect::digit},
    {"point", Effect::point},
    {"sign", Effect::sign},
    {"down", Effect::down},
    {"clear", Effect::clear},
};

struct Column {
  std::string_view name;
  std::vector<Place> places;  ///< STOP state
};

const std::vector<Column> kColumns{
    {"MN", {Place::menu}},
    {"HA", {Place::hand_ready, Place::hand_istwert, Place::hand_value}},
    {"HE", {Place::input_function, Place::input_word, Place::input_rest}},
    {"TI", {Place::teach_program, Place::teach_ready, Place::teach_word}},
    {"AU", {Place::automat_program, Place::automat_block, Place::automat_ready}},
    {"XD",
     {Place::external_device, Place::external_write, Place::external_read, Place::external_transfer,
      Place::external_leader, Place::external_reading}},
    {"GR", {Place::graphics_program, Place::graphics}},
    {"SL", {Place::erase_program, Place::erase_all}},
    {"EM", {Place::editor_program, Place::editor_number, Place::editor_function, Place::editor_word}},
    {"MDM", {Place::machine_data}},
};

constexpr Effect kNo = Effect::ignored;

/// All effects that a key has in the places of one column.
std::set<Effect> effects_in(std::span<const Place> places, Key key) {
  std::set<Effect> effects;
  for (const Place place : places)
    if (const Effect effect = effect_of(place, key); effect != kNo) effects.insert(effect);
  return effects;
}

std::set<Effect> effects_named(std::string_view name) {
  for (const NamedEffect& row : kEffects)
    if (row.name == name) return {row.effect};
  EXPECT_EQ(name, "-") << "no effect of that name";
  return {};
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

TEST(KeyTable, KEY_090_EveryCellOfTheMatrix) {
  std::set<Key> seen;
  for (const MatrixRow& row : kMatrix) {
    for (const Key key : keys_in(row.keys)) {
      seen.insert(key);
      for (std::size_t column = 0; column < kColumns.size(); ++column) {
        SCOPED_TRACE(std::string(name_of(key)).append(" in ").append(kColumns[column].name));
        EXPECT_EQ(effects_in(kColumns[column].places, key), effects_named(row.cells.at(column)));
      }
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(kKeys)) << "every key of the keyboard is in the matrix";
}

// The column "START state" of KEY-090, with KEY-011 to KEY-013: only STOP is polled; in AUTOMAT EINZELSATZ too, and
// START while the program waits.
TEST(KeyTable, KEY_011_012_013_StartStateOfEveryMode) {
  const std::map<Place, std::map<Key, Effect>> started{
      {Place::hand_moving, {{Key::STOP, Effect::stop}}},
      {Place::hand_reference, {{Key::STOP, Effect::stop}}},
      {Place::input_running, {{Key::STOP, Effect::stop}}},
      {Place::input_waiting, {{Key::STOP, Effect::stop}, {Key::START, Effect::start}}},
      {Place::teach_moving, {{Key::STOP, Effect::stop}}},
      {Place::automat_running, {{Key::STOP, Effect::stop}, {Key::EINZELSATZ, Effect::single_block}}},
      {Place::automat_waiting,
       {{Key::STOP, Effect::stop}, {Key::EINZELSATZ, Effect::single_block}, {Key::START, Effect::start}}}};
  for (int i = 0; i < kPlaces; ++i) {
    const auto place = static_cast<Place>(i);
    EXPECT_EQ(is_start_state(place), started.contains(place)) << i;
    if (!started.contains(place)) continue;
    for (int number = 1; number <= kKeys; ++number) {
      const auto key = static_cast<Key>(number);
      const auto& polled = started.at(place);
      EXPECT_EQ(effect_of(place, key), polled.contains(key) ? polled.at(key) : kNo) << name_of(key);
    }
  }
}

// KEY-051, ERR-031, ERR-033: SPEICHER LÖSCHEN starts the memory test, which runs until RESET.
TEST(KeyTable, KEY_051_MemoryTest) {
  for (int number = 1; number <= kKeys; ++number) {
    const auto key = static_cast<Key>(number);
    const Effect expected = key == Key::SPEICHER_LOESCHEN ? Effect::test_memory
                            : key == Key::MENU            ? Effect::open_menu
                                                          : kNo;
    EXPECT_EQ(effect_of(Place::memory_list, key), expected) << name_of(key);
    EXPECT_EQ(effect_of(Place::memory_running, key), key == Key::RESET ? Effect::reset : kNo) << name_of(key);
  }
}

TEST(KeyTable, KEY_041_MODEL_003_006_KeysOfAbsentFunctions) {
  const language::Vocabulary small{.model = language::Model::cnc3250};
  const language::Vocabulary plain{.planned_functions = false};
  EXPECT_EQ(effect_of(Place::menu, Key::GRAFIK, small), kNo);
  EXPECT_EQ(effect_of(Place::menu, Key::GRAFIK, plain), kNo) << "D-02";
  EXPECT_EQ(effect_of(Place::editor_function, Key::DOWN, small), kNo);
  EXPECT_EQ(effect_of(Place::editor_word, Key::DOWN, small), kNo);
  EXPECT_EQ(effect_of(Place::editor_number, Key::DOWN, small), Effect::down) << "paging is no parameter";
  EXPECT_EQ(effect_of(Place::editor_word, Key::DOWN, plain), Effect::down);
  for (const Key key : {Key::D1, Key::D3, Key::D7}) {
    EXPECT_EQ(effect_of(Place::external_device, key, small), kNo) << "MODEL-004, MODEL-005";
    EXPECT_EQ(effect_of(Place::external_device, key), Effect::digit);
  }
  for (const Key key : {Key::D2, Key::D4, Key::D5, Key::D6, Key::D8, Key::D9})
    EXPECT_EQ(effect_of(Place::external_polled, key, small), Effect::digit) << name_of(key);
}

TEST(KeyTable, KeysOfAPlaceDoNotOverlap) {
  for (const language::Model model : {language::Model::cnc3300, language::Model::cnc3250}) {
    const language::Vocabulary vocabulary{.model = model};
    for (const KeyRow& row : key_table())
      for (const KeyRow& other : key_table())
        if (&row != &other && row.place == other.place && has_row(row, vocabulary) && has_row(other, vocabulary)) {
          EXPECT_TRUE(row.last < other.first || other.last < row.first) << name_of(row.first);
        }
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
    {"EM word", "EINGABE ENTER ENTER 0 1 ENTER", Place::editor_word},
    {"AU program", "AUTOMAT", Place::automat_program},
    {"AU block", "AUTOMAT ENTER", Place::automat_block},
    {"AU ready", "AUTOMAT ENTER ENTER", Place::automat_ready},
    {"HA", "HAND", Place::hand_ready},
    {"HA ISTWERT", "HAND ISTWERT", Place::hand_istwert},
    {"HA value", "HAND ISTWERT PLUS_X", Place::hand_value},
    {"HE function", "HANDEINGABE", Place::input_function},
    {"HE word", "HANDEINGABE ENTER", Place::input_word},
    {"TI program", "TEACH_IN", Place::teach_program},
    {"TI ready", "TEACH_IN ENTER", Place::teach_ready},
    {"TI word", "TEACH_IN ENTER ENTER", Place::teach_word},
    {"XD", "EXTERNE_DATEN", Place::external_device},
    {"GR program", "GRAFIK", Place::graphics_program},
    {"GR", "GRAFIK ENTER", Place::graphics},
    {"SL", "SPEICHER_LOESCHEN", Place::erase_program},
    {"MDM", "ENTER+RESET", Place::machine_data},
    {"MT list", "3+6+9", Place::memory_list},
    {"MT", "3+6+9 SPEICHER_LOESCHEN", Place::memory_running},
    {"SL all", "SPEICHER_LOESCHEN CLEAR", Place::erase_all},
};

/// Row 18 says in a sentence what the control waits for, the rows below which keys work, from the one table.
TEST(Keys, DEC_01_EveryPlaceHasASentenceAndItsKeysBelow) {
  for (const Scene& scene : kScenes) {
    for (const language::Tongue tongue : {language::Tongue::german, language::Tongue::english}) {
      SCOPED_TRACE(std::string(scene.name));
      Bench::Setup setup{.tape = std::string(kBild7)};
      setup.settings.tongue = tongue;
      Bench bench(setup);
      bench.control.connect_media(true);  // a device that is not there is not listed
      bench.keys(scene.keys);
      bench.run_for(10);
      const std::string sentence = bench.row(18) + " " + bench.row(19);
      EXPECT_TRUE(sentence.find_first_of(".!…") != std::string::npos) << sentence;
      std::string below;
      for (int row = 19; row < 24; ++row) below += bench.row(row) + " ";
      for (const KeyRow& entry : key_table()) {
        if (entry.place != scene.place || !has_row(entry, setup.settings.vocabulary)) continue;
        if (entry.effect == Effect::erase_block && scene.keys.find("SATZ_SUCHEN") == std::string_view::npos) continue;
        const std::string help(text(entry.help, tongue));
        EXPECT_TRUE(below.contains(help)) << help << " is missing in\n" << bench.picture();
      }
    }
  }
}

std::string keys_below(const Bench& bench) {
  std::string keys;
  for (int row = 19; row < 24; ++row) keys += bench.row(row) + "\n";
  return keys;
}

// The rows below list no key that does nothing where the marker stands (DEC-01, KEY-065).
TEST(Keys, DEC_01_KEY_065_PointSignAndParameterAreListedWhereTheWordTakesThem) {
  for (const std::string_view mode : {"EINGABE ENTER ENTER 0 1 ENTER", "HANDEINGABE ENTER"}) {
    SCOPED_TRACE(std::string(mode));
    Bench bench;
    bench.keys(mode);
    std::map<char, std::string> listed;  // by the word under the marker
    for (const char letter : {'X', 'Y', 'Z', 'F', 'S', 'T', 'M'}) {
      listed[letter] = keys_below(bench);
      bench.keys("ENTER");
    }
    for (const char letter : {'X', 'Y', 'Z'}) {
      EXPECT_TRUE(listed[letter].contains(" +/- ")) << letter << listed[letter];
      EXPECT_TRUE(listed[letter].contains(" . ")) << letter << listed[letter];
    }
    for (const char letter : {'F', 'S', 'T', 'M'}) {
      EXPECT_FALSE(listed[letter].contains(" +/- ")) << letter << listed[letter];
      EXPECT_FALSE(listed[letter].contains(" . ")) << letter << listed[letter];
    }
  }
}

TEST(Keys, KEY_065_PointAndSignInAWholeNumberAreIgnoredWithAHint) {
  Bench bench;
  bench.keys("EINGABE ENTER ENTER 0 1 ENTER ENTER ENTER ENTER ENTER ENTER");
  ASSERT_TRUE(bench.row(18).contains("Wort T")) << bench.row(18);
  EXPECT_FALSE(keys_below(bench).contains("↓")) << "T takes no parameter";
  EXPECT_TRUE(keys_below(bench).contains("EINGABE"));
  const std::string before = bench.monitor(5) + bench.monitor(4);
  for (const Key key : {Key::POINT, Key::SIGN, Key::DOWN}) {
    bench.press(key);
    EXPECT_EQ(bench.row(18), std::string(label_of(key)) + " hat hier keine Wirkung.");
  }
  EXPECT_EQ(bench.monitor(5) + bench.monitor(4), before);
}

TEST(Keys, DEC_06_ProgramsOfTheRomListNoKeyThatChangesThem) {
  Bench bench;
  bench.keys("EINGABE CLEAR 9 9 8 1 ENTER");
  EXPECT_FALSE(keys_below(bench).contains("speichern")) << keys_below(bench);
  EXPECT_FALSE(keys_below(bench).contains("SATZ LÖSCHEN")) << keys_below(bench);
  EXPECT_TRUE(keys_below(bench).contains("SATZ SUCHEN")) << keys_below(bench);
  bench.keys("EINGABE");
  EXPECT_EQ(bench.monitor(15), "Reserviert fuer Zyklen") << "and still says why not";
}

TEST(Keys, SCR_022_ERR_043_RemoteLightsTheFieldOfExternalData) {
  Bench::Setup setup;
  EXPECT_TRUE(Bench(setup).marks().empty());
  setup.settings.remote = true;
  const Bench bench(setup);
  ASSERT_EQ(bench.marks(), std::vector<std::string>{"9 1 1"}) << bench.picture();
  EXPECT_TRUE(bench.row(9).starts_with("│□ EXTERNE DATEN"));
}

TEST(Keys, SwitchedOffHintsLeaveTheSentence) {
  Bench::Setup setup;
  setup.settings.hints = false;
  Bench bench(setup);
  bench.keys("HAND");
  const std::string sentence = bench.row(18);
  bench.keys("AUTOMAT");
  EXPECT_EQ(bench.row(18), sentence);
}

TEST(Keys, KEY_090_IgnoredKeysChangeNeitherMonitorNorState) {
  for (const Scene& scene : kScenes) {
    for (int i = 1; i <= kKeys; ++i) {
      const auto key = static_cast<Key>(i);
      if (effect_of(scene.place, key) != Effect::ignored || key == Key::RESET) continue;
      SCOPED_TRACE(std::string(scene.name) + " " + std::string(name_of(key)));
      Bench bench({.tape = std::string(kBild7)});
      bench.keys(scene.keys);
      bench.run_for(10);
      const std::string before = visible_state(bench);
      const int stores = bench.stores();
      bench.press(key);
      bench.run_for(10);
      EXPECT_EQ(visible_state(bench), before);
      EXPECT_EQ(bench.stores(), stores);
      EXPECT_FALSE(bench.snapshot().started);
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

TEST(Keys, DEC_01_INS_002_BetweenLongSentencesTheNamesOfAllKeysHaveRoom) {
  Settings english;
  english.tongue = language::Tongue::english;
  Bench bench({.settings = english});
  bench.keys("HAND");
  bench.side.bar = std::string(90, 'b').replace(60, 1, " ");
  bench.side.notice = std::string(90, 'n').replace(60, 1, " ");
  std::string rows;
  for (int row = 21; row < 24; ++row) rows += bench.row(row) + "\n";
  for (const char* name : {"±X ±Y ±Z", "START", "STOP", "REFERENZ", "ISTWERT", "FRÄSER", "KÜHLMITTEL", "HANDEINGABE",
                           "TEACH IN", "MENU", "? all keys"})
    EXPECT_TRUE(rows.contains(name)) << name << " is not in\n" << rows;
  bench.side.bar.clear();
  bench.side.notice.clear();
  EXPECT_TRUE(bench.row(19).contains("choose directions")) << "with room they say what they do: " << bench.row(19);
}

}  // namespace
}  // namespace cnclab::panel
