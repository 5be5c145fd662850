// The file of certificates that this user has seen before, as ssh keeps one (SEC-001).
//
// One line for each server: "HOST:PORT SHA256:…". Lines that begin with # are comments. Stations of one user may write
// at the same time: the file is locked while it is read and extended.
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <string>

#include "station/client.hpp"

namespace cnclab::station {

/// $XDG_STATE_HOME/cnclab/known_hosts or ~/.local/state/cnclab/known_hosts; empty where neither variable is set.
[[nodiscard]] std::filesystem::path default_known_hosts();

enum class Acquaintance : std::uint8_t {
  known,       ///< the certificate is the given or the remembered one
  pinned_now,  ///< first use: remembered from now on, file mode 0600
};

/// Compares the certificate's fingerprint with `trust`. errors: certificate_differs, naming file and line and what to
/// do; cannot_connect where the file cannot be read or written.
[[nodiscard]] std::expected<Acquaintance, ConnectError> judge(const Trust& trust, const Address& address,
                                                              const std::string& fingerprint);

}  // namespace cnclab::station
