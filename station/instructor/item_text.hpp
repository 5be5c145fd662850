// One object of an answer as the one-shot commands print it.
#pragma once

#include <string>

namespace cnclab::v1 {
class InstructorItem;
}

namespace cnclab::instructor {

/// JSON in one line with the field names of interfaces.md section 4; a program's tape text and a screen's 24 lines
/// (each | + 80 columns + |, then "end") as they are. Ends with a newline.
[[nodiscard]] std::string text_of(const v1::InstructorItem& item);

}  // namespace cnclab::instructor
