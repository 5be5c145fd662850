// Looking forms and formats up: constant tables made from the rows of form_table.hpp when this is compiled.
#include "language/block_form.hpp"

#include <array>
#include <bit>
#include <iterator>

#include "language/form_table.hpp"

namespace cnclab::language {

namespace {

using Kind = Function::Kind;

constexpr int kCodes = 100;
constexpr int kPlanes = 3;
constexpr std::array kAllPlanes{Plane::xy, Plane::xz, Plane::yz};

/// Place of a form in kForms plus 1, by kind, code and plane; 0 where there is none.
using FormIndex = std::array<std::array<std::array<std::uint8_t, kPlanes>, kCodes>, 2>;

constexpr FormIndex make_form_index() {
  FormIndex index{};
  for (std::size_t i = 0; i < std::size(kForms); ++i) {
    const BlockForm& form = kForms[i];
    if (form.function.kind == Kind::tool) continue;
    auto& planes = index[static_cast<std::size_t>(form.function.kind)][form.function.code];
    const auto place = static_cast<std::uint8_t>(i + 1);
    if (form.is_for_one_plane)
      planes[static_cast<std::size_t>(form.plane)] = place;
    else
      planes = {place, place, place};
  }
  return index;
}

constexpr FormIndex kFormIndex = make_form_index();
static_assert(std::size(kForms) < 255);

/// P0000 has one row form for all its tools (D-50).
constexpr std::size_t find_tool_form() {
  for (std::size_t i = 0; i < std::size(kForms); ++i)
    if (kForms[i].function.kind == Kind::tool) return i;
  return 0;
}
constexpr std::size_t kToolForm = find_tool_form();

const BlockForm* form_at(Function function, Plane plane) {
  if (function.kind == Kind::tool) return &kForms[kToolForm];
  if (function.code >= kCodes) return nullptr;
  const auto place =
      kFormIndex[static_cast<std::size_t>(function.kind)][function.code][static_cast<std::size_t>(plane)];
  return place == 0 ? nullptr : &kForms[place - 1];
}

constexpr std::array<std::uint8_t, 128> make_format_index() {
  std::array<std::uint8_t, 128> index{};
  for (std::size_t i = 0; i < std::size(kFormats); ++i)
    index[static_cast<unsigned char>(letter(kFormats[i].address))] = static_cast<std::uint8_t>(i);
  return index;
}
constexpr std::array<std::uint8_t, 128> kFormatIndex = make_format_index();

constexpr AddressSet set_of_words(const BlockForm& form) {
  AddressSet set = 0;
  for (const Address address : form.words) set |= bit_of(address);
  return set;
}

constexpr AddressSet set_of_required_words(const BlockForm& form) {
  AddressSet set = 0;
  switch (form.needed) {
    case Needed::all:
      return set_of_words(form);
    case Needed::two_axes_and_radius:
      for (const Address address : form.words.first(3)) set |= bit_of(address);  // they stand first in every plane
      return set;
    case Needed::cycle:
      for (const Address address : form.required_words) set |= bit_of(address);
      return set;
    case Needed::nothing:
    case Needed::any_axis:
    case Needed::any_word:
      return set;
  }
  return set;
}

using FormSets = std::array<AddressSet, std::size(kForms)>;

template <typename SetOf>
constexpr FormSets make_form_sets(SetOf set_of) {
  FormSets sets{};
  for (std::size_t i = 0; i < std::size(kForms); ++i) sets[i] = set_of(kForms[i]);
  return sets;
}
constexpr FormSets kFormSets = make_form_sets(set_of_words);
constexpr FormSets kRequiredSets = make_form_sets(set_of_required_words);

/// The addresses of a function in all its planes, by kind and code.
using FunctionSets = std::array<std::array<AddressSet, kCodes>, 2>;

constexpr FunctionSets make_any_plane_sets() {
  FunctionSets sets{};
  for (const BlockForm& form : kForms)
    if (form.function.kind != Kind::tool)
      sets[static_cast<std::size_t>(form.function.kind)][form.function.code] |= set_of_words(form);
  return sets;
}
constexpr FunctionSets kAnyPlaneSets = make_any_plane_sets();

/// No function has more words than a block has room for, not even with those of all its planes.
constexpr bool blocks_hold_all_words() {
  for (const BlockForm& form : kForms)
    if (form.words.size() > kMostWords) return false;
  for (const auto& sets : kAnyPlaneSets)
    for (const AddressSet set : sets)
      if (static_cast<std::size_t>(std::popcount(set)) > kMostWords) return false;
  return true;
}
static_assert(blocks_hold_all_words());

}  // namespace

const WordFormat& format_of(Address address) {
  return kFormats[kFormatIndex[static_cast<unsigned char>(letter(address)) % kFormatIndex.size()]];
}

const BlockForm* find_form(Function function, Plane plane, const Vocabulary& vocabulary) {
  const BlockForm* form = form_at(function, plane);
  if (form == nullptr) return nullptr;
  if (vocabulary.model == Model::cnc3250 && !form->on_3250) return nullptr;
  if (form->is_planned && !vocabulary.planned_functions) return nullptr;
  return form;
}

std::span<const BlockForm> all_forms() { return kForms; }

bool is_plane_dependent(Function function) {
  const BlockForm* form = form_at(function, Plane::xy);
  return form != nullptr && form->is_for_one_plane;
}

AddressSet addresses_of(const BlockForm& form) { return kFormSets[static_cast<std::size_t>(&form - kForms)]; }

AddressSet required_addresses_of(const BlockForm& form) {
  return kRequiredSets[static_cast<std::size_t>(&form - kForms)];
}

AddressSet addresses_in_any_plane(Function function) {
  if (function.kind == Kind::tool) return kFormSets[kToolForm];
  if (function.code >= kCodes) return 0;
  return kAnyPlaneSets[static_cast<std::size_t>(function.kind)][function.code];
}

Plane plane_of_words(Function function, AddressSet words, Plane fallback) {
  const auto fits = [&](Plane plane) {
    const BlockForm* form = form_at(function, plane);
    return form != nullptr && (words & ~addresses_of(*form)) == 0;
  };
  if (!is_plane_dependent(function) || fits(fallback)) return fallback;
  for (const Plane plane : kAllPlanes)
    if (fits(plane)) return plane;
  return fallback;
}

Plane plane_of_words(const Block& block, Plane fallback) {
  AddressSet words = 0;
  for (const Word& word : block.words) words |= bit_of(word.address);
  return plane_of_words(block.function, words, fallback);
}

Plane plane_behind(const Block& block, Plane before) {
  if (block.function.kind != Kind::g) return before;
  if (block.function.code == 17) return Plane::xy;
  if (block.function.code == 18) return Plane::xz;
  if (block.function.code == 19) return Plane::yz;
  return before;
}

bool is_known_m(std::int64_t code) {
  if (code < 0 || code > 98) return false;
  if (code < 40) {
    switch (code) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
      case 5:
      case 8:
      case 9:
      case 12:
      case 13:
      case 14:
      case 15:
      case 16:
      case 20:
      case 21:
      case 22:
      case 23:
      case 24:
        return true;
      default:
        return false;
    }
  }
  return code % 10 != 9;  // M40–M98: outputs and inputs 1–8 of cards 1 and 2, 0 for all of them
}

}  // namespace cnclab::language
