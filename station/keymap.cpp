// The table of bindings, in the order of the manual's chapter 1.
#include "station/keymap.hpp"

#include <algorithm>

#include "shared/screen.hpp"

namespace cnclab::station {
namespace {

using enum Special;
using Inputs = std::vector<Input>;

Binding key(KeyGroup group, Key pressed, Inputs inputs, Text label, Text cap) {
  return {group, Press{{pressed}}, std::move(inputs), label, cap};
}

Binding digit(char32_t character, std::string_view text) {
  const auto pressed = static_cast<Key>(static_cast<std::uint32_t>(Key::D0) + (character - U'0'));
  return key(KeyGroup::data, pressed, {character}, {text, text}, {text, text});
}

// Block A (KEY-002).
std::vector<Binding> hand_keys() {
  constexpr auto kGroup = KeyGroup::hand;
  return {
      key(kGroup, Key::HAND, {U'h'}, {"HAND", "MANUAL"}, {"HAND", "MANUAL"}),
      key(kGroup, Key::START, {U's'}, {"START", "START"}, {"START", "START"}),
      key(kGroup, Key::STOP, {U' '}, {"STOP", "STOP"}, {"STOP", "STOP"}),
      key(kGroup, Key::PLUS_X, {U'x'}, {"+X", "+X"}, {"+X", "+X"}),
      key(kGroup, Key::MINUS_X, {U'X'}, {"-X", "-X"}, {"-X", "-X"}),
      key(kGroup, Key::PLUS_Y, {U'y'}, {"+Y", "+Y"}, {"+Y", "+Y"}),
      key(kGroup, Key::MINUS_Y, {U'Y'}, {"-Y", "-Y"}, {"-Y", "-Y"}),
      key(kGroup, Key::PLUS_Z, {U'z'}, {"+Z", "+Z"}, {"+Z", "+Z"}),
      key(kGroup, Key::MINUS_Z, {U'Z'}, {"-Z", "-Z"}, {"-Z", "-Z"}),
      key(kGroup, Key::ISTWERT, {U'i'}, {"ISTWERT", "ACTUAL VALUE"}, {"ISTWERT", "ACTUAL"}),
      key(kGroup, Key::FRAESER, {U'f'}, {"FRÄSER", "SPINDLE"}, {"FRÄSER", "SPINDLE"}),
      key(kGroup, Key::KUEHLMITTEL, {U'k'}, {"KÜHLMITTEL", "COOLANT"}, {"KÜHLM.", "COOLANT"}),
  };
}

// Block B (KEY-003).
std::vector<Binding> mode_keys() {
  constexpr auto kGroup = KeyGroup::mode;
  return {
      key(kGroup, Key::AUTOMAT, {U'a', f5}, {"AUTOMAT", "AUTOMATIC"}, {"AUTOMAT", "AUTO"}),
      key(kGroup, Key::GRAFIK, {U'g', f6}, {"GRAFIK", "GRAPHICS"}, {"GRAFIK", "GRAPHIC"}),
      key(kGroup, Key::MENU, {U'm'}, {"MENU", "MENU"}, {"MENU", "MENU"}),
      key(kGroup, Key::EINZELSATZ, {U'e'}, {"EINZELSATZ", "SINGLE BLOCK"}, {"EINZELS.", "SINGLE"}),
      key(kGroup, Key::REFERENZ, {U'r'}, {"REFERENZ", "REFERENCE"}, {"REFERENZ", "REFER."}),
      key(kGroup, Key::EXTERNE_DATEN, {U'd', f7}, {"EXTERNE DATEN", "EXTERNAL DATA"}, {"EXT.DAT.", "EXT.DATA"}),
      key(kGroup, Key::TEACH_IN, {U't', f8}, {"TEACH IN", "TEACH IN"}, {"TEACH IN", "TEACH IN"}),
      key(kGroup, Key::SATZ_SUCHEN, {U'u', f3}, {"SATZ SUCHEN", "SEARCH BLOCK"}, {"SUCHEN", "SEARCH"}),
      key(kGroup, Key::SPEICHER_LOESCHEN, {U'l'}, {"SPEICHER LÖSCHEN", "CLEAR MEMORY"}, {"SP.LÖSCH", "CLR.MEM."}),
      key(kGroup, Key::EINGABE, {tab, f2, insert}, {"EINGABE", "INPUT"}, {"EINGABE", "INPUT"}),
      key(kGroup, Key::HANDEINGABE, {U'b', f4}, {"HANDEINGABE", "MANUAL INPUT"}, {"HANDEING", "MAN.INP."}),
      key(kGroup, Key::SATZ_LOESCHEN, {U'w', remove}, {"SATZ LÖSCHEN", "DELETE BLOCK"}, {"SATZ LÖ.", "DEL.BLK."}),
  };
}

// Block C (KEY-004) as a pad of 4×4 (D-07): 7 8 9 C / 4 5 6 ↓ / 1 2 3 → / 0 . +/- RESET.
std::vector<Binding> data_keys() {
  constexpr auto kGroup = KeyGroup::data;
  return {
      digit(U'7', "7"),
      digit(U'8', "8"),
      digit(U'9', "9"),
      key(kGroup, Key::CLEAR, {U'c', backspace}, {"C", "C"}, {"C", "C"}),
      digit(U'4', "4"),
      digit(U'5', "5"),
      digit(U'6', "6"),
      key(kGroup, Key::DOWN, {U'v', down}, {"↓", "↓"}, {"↓", "↓"}),
      digit(U'1', "1"),
      digit(U'2', "2"),
      digit(U'3', "3"),
      key(kGroup, Key::ENTER, {enter, right}, {"→", "→"}, {"→", "→"}),
      digit(U'0', "0"),
      key(kGroup, Key::POINT, {U'.', U','}, {".", "."}, {".", "."}),
      key(kGroup, Key::SIGN, {U'-'}, {"+/-", "+/-"}, {"+/-", "+/-"}),
      key(kGroup, Key::RESET, {U'R'}, {"RESET", "RESET"}, {"RESET", "RESET"}),
  };
}

// What the original did not have, and keys pressed together.
std::vector<Binding> lab_keys() {
  constexpr auto kGroup = KeyGroup::lab;
  // The cold start wants ↓ held for two seconds (KEY-072).
  constexpr std::chrono::milliseconds kColdStart{2100};
  constexpr Text kNoCap{"", ""};
  return {
      key(kGroup, Key::MASCHINE_HALT, {U'!', f12}, {"MASCHINE HALT", "MACHINE HALT"}, {"M.HALT", "M.HALT"}),
      key(kGroup, Key::MELDUNG, {U'M'}, {"MELDUNG", "RAISE HAND"}, {"MELDUNG", "HAND UP"}),
      key(kGroup, Key::LABOR, {U'o'}, {"LABOR", "LAB"}, {"LABOR", "LAB"}),
      {kGroup, TurnPotentiometer{-5}, {U'<', page_down}, {"Poti -5 %", "Feed -5 %"}, {"Poti-", "Feed-"}},
      {kGroup, TurnPotentiometer{+5}, {U'>', page_up}, {"Poti +5 %", "Feed +5 %"}, {"Poti+", "Feed+"}},
      {kGroup, Local::help, {U'?', f1}, {"alle Tasten", "all keys"}, {"Hilfe", "Help"}},
      {kGroup, Local::log_out, {U'q', ctrl_c}, {"abmelden", "log out"}, {"Ende", "Quit"}},
      {kGroup, Press{{Key::ENTER, Key::RESET}}, {U'D', f9}, {"→ und RESET", "→ and RESET"}, kNoCap},
      {kGroup,
       Press{{Key::DOWN, Key::RESET}, kColdStart},
       {U'K', f10},
       {"↓ und RESET, 2 s", "↓ and RESET, 2 s"},
       kNoCap},
      {kGroup, Press{{Key::D3, Key::D6, Key::D9}}, {U'T', f11}, {"3, 6 und 9", "3, 6 and 9"}, kNoCap},
      {kGroup, Local::redraw, {U'#', ctrl_l}, {"neu zeichnen", "redraw"}, kNoCap},
  };
}

std::vector<Binding> every_binding() {
  std::vector<Binding> all;
  for (auto part : {hand_keys(), mode_keys(), data_keys(), lab_keys()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

struct SpecialName {
  Special special;
  Text name;
};

constexpr SpecialName kSpecialNames[] = {
    {enter, {"Enter", "Enter"}},
    {tab, {"Tab", "Tab"}},
    {backspace, {"Rücktaste", "Backspace"}},
    {escape, {"Esc", "Esc"}},
    {up, {"Pfeil ↑", "Arrow ↑"}},
    {down, {"Pfeil ↓", "Arrow ↓"}},
    {left, {"Pfeil ←", "Arrow ←"}},
    {right, {"Pfeil →", "Arrow →"}},
    {page_up, {"Bild↑", "PgUp"}},
    {page_down, {"Bild↓", "PgDn"}},
    {home, {"Pos1", "Home"}},
    {end, {"Ende", "End"}},
    {insert, {"Einfg", "Insert"}},
    {remove, {"Entf", "Delete"}},
    {f1, {"F1", "F1"}},
    {f2, {"F2", "F2"}},
    {f3, {"F3", "F3"}},
    {f4, {"F4", "F4"}},
    {f5, {"F5", "F5"}},
    {f6, {"F6", "F6"}},
    {f7, {"F7", "F7"}},
    {f8, {"F8", "F8"}},
    {f9, {"F9", "F9"}},
    {f10, {"F10", "F10"}},
    {f11, {"F11", "F11"}},
    {f12, {"F12", "F12"}},
    {ctrl_c, {"Strg-C", "Ctrl-C"}},
    {ctrl_l, {"Strg-L", "Ctrl-L"}},
};

constexpr bool is_every_special_named() {
  for (std::size_t i = 0; i < std::size(kSpecialNames); ++i)
    if (kSpecialNames[i].special != static_cast<Special>(i)) return false;
  return std::size(kSpecialNames) == static_cast<std::size_t>(ctrl_l) + 1;
}
static_assert(is_every_special_named(), "the rows stand in the order of Special, which ends with ctrl_l");

Text special_name(Special special) { return kSpecialNames[static_cast<std::size_t>(special)].name; }

}  // namespace

std::span<const Binding> keymap() {
  static const std::vector<Binding> kBindings = every_binding();
  return kBindings;
}

const Binding* binding_of(const Input& input) {
  const auto bindings = keymap();
  const auto found = std::ranges::find_if(bindings, [&](const Binding& binding) {
    return std::ranges::find(binding.inputs, input) != binding.inputs.end();
  });
  return found == bindings.end() ? nullptr : &*found;
}

bool is_stop(const Press& press) {
  return press.keys.size() == 1 && (press.keys.front() == Key::STOP || press.keys.front() == Key::MASCHINE_HALT);
}

bool is_stop(const Binding& binding) {
  const auto* const press = std::get_if<Press>(&binding.action);
  return press != nullptr && is_stop(*press);
}

bool is_stop(const Input& input) {
  const Binding* const binding = binding_of(input);
  return binding != nullptr && is_stop(*binding);
}

std::string input_name(const Input& input, Language language) {
  if (const auto* const special = std::get_if<Special>(&input)) return std::string(special_name(*special).in(language));
  const char32_t character = std::get<char32_t>(input);
  if (character == U' ') return std::string(Text{"Leertaste", "Space"}.in(language));
  return to_utf8(character);
}

bool is_plain(const Input& input) {
  if (const auto* const special = std::get_if<Special>(&input)) {
    return *special == enter || *special == tab || *special == backspace;
  }
  const char32_t character = std::get<char32_t>(input);
  return character >= 0x20 && character < 0x7F;
}

}  // namespace cnclab::station
