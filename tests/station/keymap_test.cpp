// The table of keys: complete, unambiguous, reachable from any keyboard; the help page and the drawn keyboard follow
// it.
#include "station/keymap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "shared/screen.hpp"
#include "station/help_page.hpp"
#include "station/keyboard_view.hpp"

namespace cnclab::station {
namespace {

constexpr Language kLanguages[] = {Language::german, Language::english};

const Press* press_of(const Binding& binding) { return std::get_if<Press>(&binding.action); }

std::string name_of_binding(const Binding& binding) { return std::string(binding.label.english); }

TEST(Keymap, EveryKeyOfTheControlHasExactlyOneBinding) {
  std::map<Key, int> bound;
  for (const Binding& binding : keymap()) {
    if (const Press* const press = press_of(binding); press != nullptr && press->keys.size() == 1) {
      ++bound[press->keys.front()];
    }
  }
  for (int number = 1; number <= kKeys; ++number) {
    EXPECT_EQ(bound[static_cast<Key>(number)], 1) << name_of(static_cast<Key>(number));
  }
}

TEST(Keymap, EveryBindingHasAPlainKeyAndNoAltKey) {
  for (const Binding& binding : keymap()) {
    EXPECT_TRUE(std::ranges::any_of(binding.inputs, is_plain)) << name_of_binding(binding);
    for (const Input& input : binding.inputs) {
      EXPECT_NE(input, Input(Special::escape)) << name_of_binding(binding) << ": Escape begins what Alt sends";
    }
  }
}

TEST(Keymap, NoInputMeansTwoThings) {
  std::set<std::string> used;
  for (const Binding& binding : keymap()) {
    for (const Input& input : binding.inputs) {
      EXPECT_TRUE(used.insert(input_name(input, Language::english)).second)
          << name_of_binding(binding) << ": " << input_name(input, Language::english);
      EXPECT_EQ(binding_of(input), &binding) << name_of_binding(binding);
    }
  }
  EXPECT_EQ(binding_of(U'ß'), nullptr);
}

TEST(Keymap, TheKeysThatInterfacesNameAreWhereTheySay) {
  struct Row {
    Input input;
    std::vector<Key> keys;
  };
  const Row rows[] = {
      {Special::f9, {Key::ENTER, Key::RESET}},
      {Special::f10, {Key::DOWN, Key::RESET}},
      {Special::f11, {Key::D3, Key::D6, Key::D9}},
      {Special::f12, {Key::MASCHINE_HALT}},
      {U' ', {Key::STOP}},
      {U's', {Key::START}},
      {Special::enter, {Key::ENTER}},
      {U'-', {Key::SIGN}},
      {U'.', {Key::POINT}},
      {U'7', {Key::D7}},
      {U'X', {Key::MINUS_X}},
      {Special::backspace, {Key::CLEAR}},
  };
  for (const Row& row : rows) {
    const Binding* const binding = binding_of(row.input);
    ASSERT_NE(binding, nullptr) << input_name(row.input, Language::english);
    ASSERT_NE(press_of(*binding), nullptr);
    EXPECT_EQ(press_of(*binding)->keys, row.keys) << input_name(row.input, Language::english);
  }
  // KEY-072: ↓ is released 2 s after RESET was pressed.
  EXPECT_GE(press_of(*binding_of(Special::f10))->hold, std::chrono::seconds(2));
}

TEST(HelpPage, NamesEveryBindingAndEveryInput) {
  for (const Language language : kLanguages) {
    std::string page;
    for (const std::string& line : help_lines(language)) {
      EXPECT_LE(from_utf8(line).size(), 80U) << line;
      page += line + "\n";
    }
    for (const Binding& binding : keymap()) {
      EXPECT_NE(page.find(binding.label.in(language)), std::string::npos) << name_of_binding(binding);
      for (const Input& input : binding.inputs) {
        EXPECT_NE(page.find(input_name(input, language)), std::string::npos) << name_of_binding(binding);
      }
    }
  }
}

// CNCLAB_WRITE_KEYS=1 writes the page anew after the table has changed.
TEST(HelpPage, in_English_a_key_has_the_name_on_the_keyboard_and_the_one_in_the_controls_texts_beside_it) {
  const auto lines = help_lines(Language::english);
  for (const Binding& binding : keymap()) {
    const Press* const press = press_of(binding);
    if (press == nullptr || press->keys.size() != 1) continue;
    const bool is_found = std::ranges::any_of(lines, [&](const std::string& line) {
      return line.find(binding.label.german) != std::string::npos &&
             line.find(binding.label.english) != std::string::npos;
    });
    EXPECT_TRUE(is_found) << name_of_binding(binding);
  }
  for (const std::string& line : lines) EXPECT_LE(from_utf8(line).size(), 78U) << line;
}

TEST(HelpPage, TheDocumentationShowsTheSameTable) {
  const std::filesystem::path file = std::filesystem::path(CNCLAB_TEST_DATA) / "../../docs/keys.md";
  if (std::getenv("CNCLAB_WRITE_KEYS") != nullptr) std::ofstream(file) << key_table();
  std::ifstream stream(file);
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(page, key_table());
}

TEST(KeyboardView, ShowsEveryKeyOnceWithoutOverlapWithin12Rows) {
  for (const Language language : kLanguages) {
    const KeyboardView view(language);
    std::set<std::pair<int, int>> covered;
    std::set<Key> keys;
    for (const KeyCap& cap : view.caps()) {
      EXPECT_LE(static_cast<int>(from_utf8(cap.label).size()), cap.width) << cap.label;
      EXPECT_LE(static_cast<int>(from_utf8(cap.hint).size()), cap.width) << cap.label << ": " << cap.hint;
      for (int row = cap.row; row < cap.row + 2; ++row) {
        for (int column = cap.column; column < cap.column + cap.width; ++column) {
          EXPECT_TRUE(covered.insert({row, column}).second) << cap.label << " overlaps";
          EXPECT_EQ(view.hit(row, column), &cap);
          EXPECT_TRUE(row >= 1 && row < KeyboardView::kRows && column < 80) << cap.label;
        }
      }
      if (const Press* const press = press_of(*cap.binding)) keys.insert(press->keys.begin(), press->keys.end());
    }
    EXPECT_EQ(keys.size(), static_cast<std::size_t>(kKeys));
    EXPECT_EQ(view.hit(0, 0), nullptr);
    EXPECT_EQ(view.hit(1, 79), nullptr);
    EXPECT_EQ(view.hit(-5, 3), nullptr);
  }
}

TEST(KeyboardView, DEC_01_without_Unicode_the_caps_are_spelled_out_within_their_width) {
  const KeyboardView view(Language::german, true);
  std::string labels;
  for (const KeyCap& cap : view.caps()) {
    labels += cap.label + "|" + cap.hint + "|";
    EXPECT_LE(cap.label.size(), static_cast<std::size_t>(cap.width)) << cap.label;
  }
  for (const char* const expected : {"FRAESER|", "KUEHLM.|", "->|", "SP.LOES.|"})
    EXPECT_NE(labels.find(expected), std::string::npos) << labels;
}

TEST(KeyboardView, HasTheThreeBlocksOfTheManual) {  // KEY-001 to KEY-004, D-07
  const KeyboardView view(Language::german);
  ASSERT_EQ(view.titles().size(), 3U);
  const auto at = [&](std::string_view label) {
    const auto found =
        std::find_if(view.caps().begin(), view.caps().end(), [&](const KeyCap& cap) { return cap.label == label; });
    EXPECT_NE(found, view.caps().end()) << label;
    return found == view.caps().end() ? std::pair(-1, -1) : std::pair(found->row, found->column);
  };
  EXPECT_LT(at("HAND").second, at("AUTOMAT").second);
  EXPECT_LT(at("AUTOMAT").second, at("7").second);
  EXPECT_EQ(at("7").first, at("9").first);
  EXPECT_EQ(at("3").second, at("9").second) << "3, 6 and 9 are a column";
  EXPECT_EQ(at("3").second, at("6").second);
  EXPECT_EQ(at("1").second, at("7").second);
}

}  // namespace
}  // namespace cnclab::station
