// Two bindings on a line, block after block.
#include "station/help_page.hpp"

#include "shared/screen.hpp"

namespace cnclab::station {
namespace {

struct Chapter {
  KeyGroup group;
  Text title;
};

constexpr Chapter kChapters[] = {
    {KeyGroup::hand, {"A  Tasten für Handbetrieb", "A  Keys for manual operation"}},
    {KeyGroup::mode, {"B  Tasten für Betriebsartenwahl", "B  Keys for the operating modes"}},
    {KeyGroup::data, {"C  Tasten für Dateneingabe", "C  Keys for data entry"}},
    {KeyGroup::lab, {"Labor, und Tasten zugleich", "Lab, and keys together"}},
};

std::string padded(std::string text, std::size_t columns) {
  const std::size_t length = from_utf8(text).size();
  if (length < columns) text.append(columns - length, ' ');
  return text;
}

std::string described(const Binding& binding, Language language) {
  std::string inputs;
  for (const Input& input : binding.inputs) inputs += (inputs.empty() ? "" : "  ") + input_name(input, language);
  return padded(std::string(binding.label.in(language)), 18) + inputs;
}

}  // namespace

std::vector<std::string> help_lines(Language language) {
  std::vector<std::string> lines;
  for (const Chapter& chapter : kChapters) {
    if (!lines.empty()) lines.emplace_back();
    lines.emplace_back(chapter.title.in(language));
    bool is_left = true;
    for (const Binding& binding : keymap()) {
      if (binding.group != chapter.group) continue;
      const std::string text = described(binding, language);
      if (is_left) {
        lines.push_back("  " + padded(text, 40));
      } else {
        lines.back() += text;
      }
      is_left = !is_left;
    }
  }
  return lines;
}

}  // namespace cnclab::station
