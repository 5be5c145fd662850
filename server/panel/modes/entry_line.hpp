// The block that is being keyed in: its number, its function and its words, with the marker that moves through them.
//
//   □006            number        digits from the right; C clears
//   N006 □00        function      two digits, or ↓ and two digits
//   N006 G01 □+..50.000 Y.....,... …   words, the marker on the address letter
//
// The line knows what was typed so far, also what is no block yet; it never touches the memory.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "language/block.hpp"
#include "language/block_form.hpp"
#include "language/error.hpp"
#include "panel/key_table.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

/// A field of whole digits that fills from the right; the first digit replaces what was offered (DEC-12).
struct DigitField {
  int places = 4;
  std::optional<int> value;
  int typed = 0;

  void offer(int number) { value = number, typed = 0; }
  void clear() { value.reset(), typed = 0; }
  void digit(int figure);
  /// The number with leading zeros, or `places` dots.
  [[nodiscard]] std::string text() const;
};

/// One word while it is keyed in (D-14, DEC-12): whole millimetres until the point, then at most three decimals.
struct WordEntry {
  language::Address address{};
  bool is_parameter = false;
  bool has_value = false;
  bool is_negative = false;
  std::int64_t magnitude = 0;   ///< in the word's unit; the parameter number where `is_parameter`
  int figures = 0;              ///< typed since the marker came here
  std::optional<int> decimals;  ///< typed behind the point; nothing: no point yet
  bool is_begun = false;        ///< a digit or the point was typed since the marker came here
  bool is_signed = false;       ///< the sign was typed since the marker came here

  static WordEntry of(language::Address address, const language::Word* word);

  void arrive() { is_begun = is_signed = false, figures = 0, decimals.reset(); }
  void digit(int figure);
  void point();
  void sign();
  void clear();
  [[nodiscard]] bool takes_point_and_sign() const;  ///< a value in millimetres
  [[nodiscard]] bool takes_parameter() const;
  [[nodiscard]] bool to_parameter();  ///< false where the word takes none (M, T)

  [[nodiscard]] std::optional<language::Word> word() const;
  [[nodiscard]] bool is_half() const { return is_parameter && !has_value; }
  [[nodiscard]] std::string text() const;  ///< as it stands on the screen, in the word's full width

 private:
  void begin();
};

class EntryLine {
 public:
  enum class Marker : std::uint8_t { number, function, word };

  /// A fresh line that offers a number and a G function. In P0000 rows have no function.
  EntryLine(std::uint16_t program, int number, std::uint8_t proposed_g);
  /// The stored block as loaded by SATZ SUCHEN; the marker stays on the number.
  static EntryLine loaded(std::uint16_t program, const language::Block& block, const language::BlockForm& form);

  [[nodiscard]] Marker marker() const { return content_.marker; }
  [[nodiscard]] bool is_tool_row() const { return content_.is_tool_row; }
  [[nodiscard]] bool is_loaded() const { return content_.is_loaded; }
  [[nodiscard]] int number() const { return content_.number.value.value_or(0); }
  [[nodiscard]] bool is_number_typed() const { return content_.number.typed > 0; }
  /// The function as it stands there; nothing while its field is empty.
  [[nodiscard]] std::optional<language::Function> function() const;

  void digit(int figure);
  void point();
  void sign();
  /// Clears the field under the marker; an empty function field gives the marker back to the number.
  void clear();
  /// ↓: the function field becomes parametric, a word a parameter; false where it has no effect.
  [[nodiscard]] bool down();
  void offer_number(int number);

  /// Moves the marker to the number; the next digit replaces it.
  void go_to_number() { content_.marker = Marker::number, content_.number.typed = 0; }
  /// Moves the marker from the number to the function (tool rows: to their words, which need `form`).
  void go_to_function() { content_.marker = Marker::function, content_.code.typed = 0; }
  /// Shows the words of the function; words of the same address keep their values.
  void show_words(const language::BlockForm& form);
  [[nodiscard]] bool has_words_shown() const { return content_.shown.has_value(); }
  /// Are the shown words those of the function field as it stands?
  [[nodiscard]] bool words_fit_function() const { return content_.shown.has_value() && content_.shown == function(); }
  void next_word();  ///< after the last the first (D-14)
  [[nodiscard]] bool is_at_last_word() const;
  /// Has the key of this effect one on the word under the marker?
  [[nodiscard]] bool acts(Effect effect) const;
  /// Puts a value into the word of that address, or empties it; the marker stays.
  void fill(language::Address address, std::optional<std::int32_t> number);
  /// Puts the marker on the first word of that letter, an empty one before others; else on the function.
  void mark(char letter);

  /// What would be stored: filled words only.
  [[nodiscard]] language::Block block() const;
  /// The first word that was begun as a parameter and has no number yet.
  [[nodiscard]] const WordEntry* half_word() const;

  /// How a mode shows the line.
  enum class Style : std::uint8_t {
    editor,
    without_number,  ///< HANDEINGABE (Bild 3): the G under the marker stays readable and is shown inverse
    fixed_number,    ///< TEACH IN (Bild 4): the number is not entered and carries no marker
  };
  /// Draws the line with its marker.
  void draw(Monitor& monitor, int row, language::Plane plane, language::Tongue tongue,
            Style style = Style::editor) const;

  /// Everything that the line consists of, for keeping it (SEAT-002) and bringing it back.
  struct Content {
    bool is_tool_row = false, is_loaded = false, is_parametric = false;
    DigitField number{3, {}, 0}, code{2, {}, 0};
    Marker marker = Marker::number;
    std::optional<language::Function> shown;  ///< function whose words are shown
    std::vector<WordEntry> words;
    std::size_t word = 0;  ///< index of the word under the marker
  };
  [[nodiscard]] const Content& content() const { return content_; }
  /// content   consistent: `word` within `words` where the marker stands on a word
  explicit EntryLine(Content content) : content_(std::move(content)) {}

 private:
  void forget_words();
  void draw_words(Monitor& monitor, int row, int left, language::Plane plane, language::Tongue tongue) const;

  Content content_;
};

}  // namespace cnclab::panel
