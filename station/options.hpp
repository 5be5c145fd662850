// The command line of cnclab-station (interfaces.md section 3).
#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

#include "shared/station_id.hpp"
#include "station/login.hpp"

namespace cnclab::station {

struct Options {
  Address server;
  std::optional<StationId> station, observe;
  std::string user;  ///< empty: asked for
  std::optional<std::filesystem::path> password_file, new_password_file;
  std::optional<MediaPlace> media;  ///< of --media, else the default place where there is one
  Trust trust;
  v1::Elsewhere elsewhere = v1::ELSEWHERE_UNSPECIFIED;
  bool is_ascii = false, is_headless = false;

  [[nodiscard]] Door door() const;
  /// The seat, or the one to be looked at; 0 where the user is to choose.
  [[nodiscard]] std::uint32_t seat() const;
};

/// What the command line asks for, or the end of the program: help and version end with 0, everything wrong with 2.
[[nodiscard]] std::expected<Options, Ending> parse_options(int count, const char* const* arguments);

/// The first line of a password file, 1 to 256 bytes. errors: usage, naming the file and what is wrong.
[[nodiscard]] std::expected<std::string, Ending> read_password(const std::filesystem::path& file);

/// Asks on the controlling terminal without echo. errors: usage where there is none.
[[nodiscard]] std::expected<std::string, Ending> ask_password(const std::string& prompt);

}  // namespace cnclab::station
