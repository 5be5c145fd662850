// What each function does: one table from function code to handler.
#pragma once

#include "program/block_run.hpp"

namespace cnclab::program {

/// The handler of a function; nullptr for codes that are none, and for rows of the tool table.
[[nodiscard]] Handler handler_of(language::Function function);

/// function_unknown for a block whose function the control at hand does not have; nothing where it can be executed.
[[nodiscard]] Outcome executable(const language::Block& block, geometry::SourceBlock source,
                                 const language::Vocabulary& vocabulary);

}  // namespace cnclab::program
