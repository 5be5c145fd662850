// Walks a program the way it is stored.
#include "panel/screen/block_window.hpp"

#include "language/block_form.hpp"
#include "program/reachable.hpp"

namespace cnclab::panel {

std::vector<WindowLine> window_from(const program::ProgramSet& programs, geometry::SourceBlock first, std::size_t lines,
                                    language::Plane plane) {
  std::vector<WindowLine> window;
  const language::Program* program = programs.find(first.program);
  const auto start = program == nullptr ? std::nullopt : program->find(first.block);
  if (!start) return window;
  program::Place place{program, *start};
  while (window.size() < lines && place.index < place.program->blocks.size()) {
    const language::Block& block = place.program->blocks[place.index];
    window.push_back({&block, language::plane_of_words(block, plane), {place.program->number, block.number}});
    const auto target = program::unconditional_target(programs, *place.program, block);
    place = target ? *target : program::Place{place.program, place.index + 1};
  }
  return window;
}

}  // namespace cnclab::panel
