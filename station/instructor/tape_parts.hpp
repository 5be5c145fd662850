// A long tape on its way to the server, piece by piece (interfaces.md section 7: at most 4 KiB, each acknowledged).
#pragma once

#include <optional>

#include "cnclab/v1/instructor.pb.h"

namespace cnclab::instructor {

/// The request that goes before the rest of `request`, whose tape is shorter by that piece then; nothing where what is
/// left goes in one. No letter is cut in two.
[[nodiscard]] std::optional<v1::InstructorRequest> take_part(v1::InstructorRequest& request);

}  // namespace cnclab::instructor
