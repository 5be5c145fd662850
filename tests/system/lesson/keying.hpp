// How a student keys in a program: the words of each block in the control's order, and what must stand in the store.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cnclab::lesson {

/// A block as the drawing office wrote it, e.g. `G01 X20 Y-5.5 F3000`: values in mm with a point, others as digits.
struct WrittenBlock {
  std::string function;               ///< two digits
  std::map<char, std::string> words;  ///< address → value
};

/// A program to be keyed in: blocks N001, N002 …
struct WrittenProgram {
  int number = 1;
  std::vector<std::string> blocks;
};

/// Throws std::invalid_argument where the text is no block.
[[nodiscard]] WrittenBlock parse_block(std::string_view text);

/// The addresses that EINGABEMODUS asks for after this G code, in its order (BLK-100 to BLK-191); `plane` is the
/// function of the plane that holds there: 17, 18 or 19 (D-54). Throws std::invalid_argument for other codes.
[[nodiscard]] std::string word_order(const std::string& function, int plane);

/// The plane that holds after this block.
[[nodiscard]] int plane_after(const WrittenBlock& block, int plane);

/// The commands of the station's line protocol for one block, from the marker on the offered N to EINGABE
/// (EDIT-007 to EDIT-013, DEC-12): → to G, the code, → to the words, each value and →, EINGABE.
[[nodiscard]] std::vector<std::string> key_commands(const WrittenBlock& block, int plane);

/// The block as the tape form gives it (D-101): `N001G01X+20000Y-5500F3000`.
[[nodiscard]] std::string tape_text(const WrittenBlock& block, int number, int plane);

/// The whole program: `P0001` and its blocks, without blanks and line breaks.
[[nodiscard]] std::string tape_text(const WrittenProgram& program);

/// A tape text without what the tape form ignores: characters below 21H, and `%` at the end.
[[nodiscard]] std::string bare_tape(std::string_view text);

}  // namespace cnclab::lesson
