// What recorded runs and backups say made them.
#pragma once

namespace cnclab::lab {

inline constexpr const char* kSoftware = "cnclab " CNCLAB_VERSION;

}  // namespace cnclab::lab
