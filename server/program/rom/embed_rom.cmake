# Turns the ROM programs' tape text into a C++ source:  cmake -DFILE=cycles.cnc -DOUT=rom_text.cpp -P embed_rom.cmake
file(READ "${FILE}" text)
file(WRITE "${OUT}.new"
"// Made from server/program/rom/cycles.cnc by server/program/rom/embed_rom.cmake.
#include \"program/rom_programs.hpp\"

namespace cnclab::program {

std::string_view rom_text() {
  return R\"rom(${text})rom\";
}

}  // namespace cnclab::program
")
file(RENAME "${OUT}.new" "${OUT}")
