// How the keys lead through a form: fields below each other, Enter in the last one hands it in.
#pragma once

#include <cstddef>
#include <cstdint>

#include "station/keymap.hpp"

namespace cnclab::station {

/// What a key asks of the form, apart from going to another field.
enum class FormAct : std::uint8_t { none, erase, submit, cancel };

/// Up and down stop at the ends, Tab goes round, Enter goes on to the next field.
///
/// current   index of the field that is being filled in, 0..fields-1; moved
/// fields    at least 1
[[nodiscard]] FormAct lead_through(Special key, std::size_t fields, std::size_t& current);

}  // namespace cnclab::station
