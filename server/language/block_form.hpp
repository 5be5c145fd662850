// The structure of every block: which words a function has, in which order, with which text (section BLK).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "language/block.hpp"

namespace cnclab::language {

/// How a word is written, checked and costed.
struct WordFormat {
  Address address{};
  enum class Kind : std::uint8_t { millimetres, digits } kind{};
  int digits = 0;                    ///< digits shown (mm words: 4 before the point, 3 behind it)
  std::int64_t least = 0, most = 0;  ///< in the word's unit
  bool takes_parameter = true;       ///< may be #nn (PAR-003: all but M and T)
  int cost_bytes = 0;                ///< memory of a filled word (D-22)
};

/// The format of an address. Every address has exactly one.
[[nodiscard]] const WordFormat& format_of(Address address);

/// Where the explanatory text in parentheses stands.
enum class TextPlace : std::uint8_t { none, before_words, after_words };

/// Which words a block must have before it can be stored (D-45).
enum class Needed : std::uint8_t {
  nothing,              ///< G17, G40, …
  all,                  ///< every word of the form
  any_axis,             ///< at least one of X, Y, Z
  any_word,             ///< at least one word
  two_axes_and_radius,  ///< G05, G06
  cycle,                ///< as the cycle's row in CYC says; see `required_words`
};

struct BlockForm {
  Function function;
  std::span<const Address> words;  ///< normative order
  /// Text in parentheses, without them; ↓5x: "JUMP ZER TO"; ↓01 to ↓17: the operator, "+" or "COPY".
  std::string_view german, english;
  TextPlace text_place = TextPlace::none;
  Needed needed = Needed::nothing;
  std::span<const Address> required_words;  ///< for Needed::cycle
  bool is_planned = false;                  ///< marked * in the manual (BLK-200)
  bool on_3250 = false;                     ///< MODEL-001
  bool is_for_one_plane = false;            ///< G02, G03, G05, G06, G62, G63, G65, G66 have a form for each plane
  Plane plane = Plane::xy;                  ///< that plane; without meaning where the form serves all planes
};

/// What the control at hand knows (DEC-08).
struct Vocabulary {
  Model model = Model::cnc3300;
  bool planned_functions = true;
};

/// The form of a function; nullptr where the control does not have it (`Funktion nicht vorgesehen`).
/// plane: only G02, G03, G05, G06 and G62..G66 depend on it (D-54).
[[nodiscard]] const BlockForm* find_form(Function function, Plane plane, const Vocabulary& vocabulary);

/// Every form there is, one per function and plane; for tests, help and documentation.
[[nodiscard]] std::span<const BlockForm> all_forms();

/// Does an arc-like function's form depend on the plane?
[[nodiscard]] bool is_plane_dependent(Function function);

/// The plane whose form fits the words that a block has (a tape does not say it); `fallback` where several fit.
[[nodiscard]] Plane plane_of_words(const Block& block, Plane fallback);

/// The plane in force behind a block: that of G17, G18, G19, else as before.
[[nodiscard]] Plane plane_behind(const Block& block, Plane before);

/// A set of addresses, one bit for each character from '#' to 'Z'.
using AddressSet = std::uint64_t;
[[nodiscard]] constexpr AddressSet bit_of(Address address) { return AddressSet{1} << (letter(address) - '#'); }

/// The addresses that a form has; `form` must come from find_form or all_forms.
[[nodiscard]] AddressSet addresses_of(const BlockForm& form);

/// Those of them that every block of the form needs (D-45).
[[nodiscard]] AddressSet required_addresses_of(const BlockForm& form);

/// The addresses that a function has in one plane or another; none where the function does not exist.
[[nodiscard]] AddressSet addresses_in_any_plane(Function function);

/// As above, from the set of the words' addresses.
[[nodiscard]] Plane plane_of_words(Function function, AddressSet words, Plane fallback);

/// Is M`code` a function of this control (section M)?
[[nodiscard]] bool is_known_m(std::int64_t code);

}  // namespace cnclab::language
