// Random programs that are right: every function, every word, values over their whole range.
#pragma once

#include <rapidcheck.h>

#include <ostream>

#include "language/block.hpp"
#include "language/block_form.hpp"

namespace cnclab::language {

/// A block with the form's needed words and some of the others; `number` as given.
[[nodiscard]] rc::Gen<Block> random_block(const BlockForm& form, std::uint16_t number);

/// One to thirty blocks with ascending numbers and gaps; P0000 holds tool rows, the others everything else.
[[nodiscard]] rc::Gen<Program> random_program();

/// What RapidCheck prints of a case that fails.
void showValue(const Block& block, std::ostream& out);
void showValue(const Program& program, std::ostream& out);

}  // namespace cnclab::language
