// Two bindings on a line, block after block; a key with two names has a line of its own.
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

// The control's own texts name its keys as they are labelled on the original, in every language (D-08); the keyboard
// on the screen is labelled in the reader's.
bool has_two_names(const Binding& binding, Language language) {
  const auto* const press = std::get_if<Press>(&binding.action);
  return language == Language::english && press != nullptr && press->keys.size() == 1 &&
         binding.label.german != binding.label.english;
}

std::string described(const Binding& binding, Language language) {
  std::string inputs;
  for (const Input& input : binding.inputs) inputs += (inputs.empty() ? "" : "  ") + input_name(input, language);
  const std::string original = has_two_names(binding, language) ? padded(std::string(binding.label.german), 18) : "";
  return original + padded(std::string(binding.label.in(language)), 18) + inputs;
}

std::string inputs_in_code(const Binding& binding) {
  std::string inputs;
  for (const Input& input : binding.inputs) {
    const std::string german = input_name(input, Language::german), english = input_name(input, Language::english);
    inputs += (inputs.empty() ? "`" : ", `") + german + (german == english ? "`" : "` (" + english + ")");
  }
  return inputs;
}

}  // namespace

std::string key_table() {
  std::string page =
      "# All keys\n\nThe key of the control, its English label, and what presses it on a plain keyboard. The station's "
      "help page\n"
      "(`?`) is made from the same table.\n";
  for (const Chapter& chapter : kChapters) {
    page += "\n## " + std::string(chapter.title.english) + "\n\n| key | English | on your keyboard |\n|---|---|---|\n";
    for (const Binding& binding : keymap()) {
      if (binding.group != chapter.group) continue;
      page += "| " + std::string(binding.label.german) + " | " + std::string(binding.label.english) + " | " +
              inputs_in_code(binding) + " |\n";
    }
  }
  return page;
}

std::vector<std::string> help_lines(Language language) {
  std::vector<std::string> lines;
  for (const Chapter& chapter : kChapters) {
    if (!lines.empty()) lines.emplace_back();
    lines.emplace_back(chapter.title.in(language));
    bool is_left = true;
    for (const Binding& binding : keymap()) {
      if (binding.group != chapter.group) continue;
      const std::string text = described(binding, language);
      if (has_two_names(binding, language)) {
        lines.push_back("  " + text);
        is_left = true;
        continue;
      }
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
