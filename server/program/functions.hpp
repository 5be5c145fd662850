// Which functions this version executes: one table from function code to handler.
#pragma once

#include "program/block_run.hpp"

namespace cnclab::program {

/// The handler of a function, or nullptr where this version has none.
[[nodiscard]] Handler handler_of(language::Function function);

/// The error for a block that this version cannot execute: function_unknown where the control has no such function,
/// else not_in_this_version; nothing where it can.
[[nodiscard]] Outcome executable(const language::Block& block, geometry::SourceBlock source,
                                 const language::Vocabulary& vocabulary);

}  // namespace cnclab::program
