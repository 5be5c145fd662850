// Programs that several tests run.
#pragma once

#include <string>

namespace cnclab::harness {

/// To and fro along X for ever, 100 mm each way.
inline const std::string kEndless = "P0001\nN001G01X+100000F3000\nN002G01X-100000\nN003G20P0001N001\n";

}  // namespace cnclab::harness
