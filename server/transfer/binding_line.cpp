// Judges the first line of a TCP serial line.
#include "transfer/binding_line.hpp"

#include <algorithm>
#include <charconv>

namespace cnclab::transfer {

namespace {

constexpr std::string_view kStation = "STATION ";
constexpr std::size_t kLongestToken = 64;
constexpr int kLastStation = 15;

bool is_token_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
}

}  // namespace

std::expected<Binding, std::string_view> parse_binding(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.size() > kLongestBinding) return std::unexpected("line too long");
  if (!line.starts_with(kStation)) return std::unexpected("does not begin with STATION");
  line.remove_prefix(kStation.size());
  const std::size_t blank = line.find(' ');
  if (blank == std::string_view::npos) return std::unexpected("has no token");
  const std::string_view number = line.substr(0, blank), token = line.substr(blank + 1);
  Binding binding{.token = std::string(token)};
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), binding.station);
  const bool is_number = error == std::errc() && end == number.data() + number.size() && number.front() != '0';
  if (!is_number || binding.station < 1 || binding.station > kLastStation)
    return std::unexpected("station is not 1..15");
  if (token.empty() || token.size() > kLongestToken || !std::ranges::all_of(token, is_token_character))
    return std::unexpected("token is malformed");
  return binding;
}

}  // namespace cnclab::transfer
