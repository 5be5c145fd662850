// Judges and makes names of media files.
#include "shared/media_name.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cnclab {

namespace {

constexpr std::array<std::pair<std::string_view, MediaKind>, 5> kEndings{{{".tap", MediaKind::punched_tape},
                                                                          {".txt", MediaKind::tape_text},
                                                                          {".nc", MediaKind::diskette},
                                                                          {".pdf", MediaKind::printed_pages},
                                                                          {".svg", MediaKind::picture}}};

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_name_character(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.'; }

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

/// Windows opens a device for these, whatever stands behind the first point.
bool is_device(std::string_view name) {
  const std::string stem = upper(name.substr(0, name.find('.')));
  if (stem == "CON" || stem == "PRN" || stem == "AUX" || stem == "NUL") return true;
  return stem.size() == 4 && (stem.starts_with("COM") || stem.starts_with("LPT")) && stem[3] >= '0' && stem[3] <= '9';
}

}  // namespace

std::optional<MediaKind> media_kind(std::string_view name) {
  if (name.empty() || name.size() > kLongestMediaName || !std::ranges::all_of(name, is_name_character))
    return std::nullopt;
  if (name.front() == '.' || name.front() == '-' || name.contains("..") || is_device(name)) return std::nullopt;
  for (const auto& [ending, kind] : kEndings)
    if (name.ends_with(ending) && name.size() > ending.size()) return kind;
  return std::nullopt;
}

std::string media_name(MediaKind kind, std::optional<int> program) {
  std::string name = "SPEICHER";
  if (program) {
    const std::string digits = std::to_string(std::clamp(*program, 0, 9999));
    name = "P" + std::string(4 - digits.size(), '0') + digits;
  }
  for (const auto& [ending, of_kind] : kEndings)
    if (of_kind == kind) name += ending;
  return name;
}

}  // namespace cnclab
