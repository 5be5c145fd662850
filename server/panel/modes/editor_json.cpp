// Writes and reads EINGABEMODUS, digit by digit.
#include "panel/modes/editor_json.hpp"

#include <algorithm>
#include <string_view>

#include "panel/json_readers.hpp"

namespace cnclab::panel {

namespace {

using Json = nlohmann::json;

constexpr int kMostFigures = 4, kMostDecimals = 3, kLargestFunction = 99;
constexpr std::size_t kMostOverview = 10'000;

Json word_json(const WordEntry& word) {
  Json json{{"a", std::string(1, language::letter(word.address))}};
  if (word.is_parameter) json["p"] = true;
  if (word.has_value) json["v"] = true;
  if (word.is_negative) json["n"] = true;
  if (word.is_begun) json["b"] = true;
  if (word.is_signed) json["s"] = true;
  json["m"] = word.magnitude;
  json["f"] = word.figures;
  if (word.decimals) json["d"] = *word.decimals;
  return json;
}

WordEntry word_of(const Json& json, language::Address address) {
  WordEntry word;
  word.address = address;
  word.is_parameter = flag_in(json, "p");
  word.has_value = flag_in(json, "v");
  word.is_negative = flag_in(json, "n");
  word.is_begun = flag_in(json, "b");
  word.is_signed = flag_in(json, "s");
  word.magnitude = integer_in(json, "m", 0, language::kLargestWord_um, 0);
  word.figures = static_cast<int>(integer_in(json, "f", 0, kMostFigures, 0));
  if (const auto decimals = integer_in(json, "d", -1, kMostDecimals, -1); decimals >= 0)
    word.decimals = static_cast<int>(decimals);
  return word;
}

std::optional<language::Function> function_in(const Json& json) {
  const Json* shown = member_of(json, "shown");
  if (shown == nullptr || !shown->is_array() || shown->size() != 2) return std::nullopt;
  const auto kind = integer_of((*shown)[0], 0, 2), code = integer_of((*shown)[1], 0, kLargestFunction);
  if (!kind || !code) return std::nullopt;
  return language::Function{static_cast<language::Function::Kind>(*kind), static_cast<std::uint8_t>(*code)};
}

/// The words as kept, where they are those of the function; otherwise false and nothing read.
bool read_words(const Json& json, const language::BlockForm& form, EntryLine::Content& content) {
  const Json* words = member_of(json, "words");
  if (words == nullptr || !words->is_array() || words->size() != form.words.size()) return false;
  for (std::size_t i = 0; i < form.words.size(); ++i) content.words.push_back(word_of((*words)[i], form.words[i]));
  content.shown = form.function;
  return true;
}

}  // namespace

Json field_json(const DigitField& field) {
  Json json{{"typed", field.typed}};
  if (field.value) json["value"] = *field.value;
  return json;
}

void read_field(const Json& json, const char* name, DigitField& field) {
  const Json* member = member_of(json, name);
  if (member == nullptr) return;
  int most = 1;
  for (int i = 0; i < field.places; ++i) most *= 10;
  field.clear();
  if (const auto value = integer_in(*member, "value", -1, most - 1, -1); value >= 0)
    field.value = static_cast<int>(value);
  if (field.value) field.typed = static_cast<int>(integer_in(*member, "typed", 0, field.places, 0));
}

Json line_json(const EntryLine& line) {
  const EntryLine::Content& content = line.content();
  Json json{{"loaded", content.is_loaded},
            {"parametric", content.is_parametric},
            {"number", field_json(content.number)},
            {"code", field_json(content.code)},
            {"marker", static_cast<int>(content.marker)},
            {"word", content.word},
            {"words", Json::array()}};
  if (content.shown) json["shown"] = {static_cast<int>(content.shown->kind), content.shown->code};
  for (const WordEntry& word : content.words) json["words"].push_back(word_json(word));
  return json;
}

EntryLine line_of(const Json& json, bool is_tool_row, language::Plane plane, const language::Vocabulary& vocabulary) {
  EntryLine::Content content;
  content.is_tool_row = is_tool_row;
  content.is_loaded = flag_in(json, "loaded");
  content.is_parametric = !is_tool_row && flag_in(json, "parametric");
  read_field(json, "number", content.number);
  read_field(json, "code", content.code);
  const auto function = function_in(json);
  const bool fits = function && (function->kind == language::Function::Kind::tool) == is_tool_row;
  const language::BlockForm* form = fits ? language::find_form(*function, plane, vocabulary) : nullptr;
  if (form != nullptr) (void)read_words(json, *form, content);
  content.marker = static_cast<EntryLine::Marker>(integer_in(json, "marker", 0, 2, 0));
  content.word =
      static_cast<std::size_t>(integer_in(json, "word", 0, static_cast<std::int64_t>(language::kMostWords), 0));
  if (content.marker == EntryLine::Marker::function && is_tool_row) content.marker = EntryLine::Marker::number;
  if (content.marker == EntryLine::Marker::word && content.word >= content.words.size())
    content.marker = EntryLine::Marker::number;
  return EntryLine(std::move(content));
}

Json editor_json(const EditorMode& mode) {
  Json json{{"program", field_json(mode.program)},
            {"open", mode.is_open},
            {"plane", static_cast<int>(mode.plane)},
            {"g", mode.proposed_g},
            {"line", line_json(mode.line)}};
  if (mode.overview) json["overview"] = *mode.overview;
  if (mode.list_from) json["list_from"] = *mode.list_from;
  return json;
}

EditorMode editor_of(const Json& json, const ControlState& state) {
  EditorMode mode = open_editor(state);
  read_field(json, "program", mode.program);
  mode.plane = static_cast<language::Plane>(integer_in(json, "plane", 0, 2, 0));
  mode.proposed_g = static_cast<std::uint8_t>(integer_in(json, "g", 0, kLargestFunction, 0));
  if (const auto from = integer_in(json, "list_from", -1, language::kLastBlock, -1); from >= 0)
    mode.list_from = static_cast<std::uint16_t>(from);
  const auto overview = integer_in(json, "overview", -1, kMostOverview, -1);
  if (overview >= 0 && static_cast<std::size_t>(overview) < state.memory.programs().size())
    mode.overview = static_cast<std::size_t>(overview);
  const bool can_be_open =
      !language::is_reserved_for_cycles(mode.number()) || program_in(state, mode.number()) != nullptr;
  mode.is_open = mode.program.value && flag_in(json, "open") && can_be_open;
  const Json* line = member_of(json, "line");
  if (mode.is_open && line != nullptr)
    mode.line = line_of(*line, mode.number() == language::kToolTable, mode.plane, state.settings.vocabulary);
  return mode;
}

}  // namespace cnclab::panel
