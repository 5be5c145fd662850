// Field by field; structured bindings see to it that a field that is added to a struct is not forgotten here.
#include "lab/runs/run_order_json.hpp"

#include <fmt/format.h>

#include <ranges>

#include "lab/stored_control.hpp"
#include "language/tape.hpp"
#include "panel/modal_json.hpp"

namespace cnclab::lab {

namespace {

using Json = nlohmann::json;

/// A database may hold anything: a number outside its range is an error, not a value that no switch knows.
template <class Number>
Number number_in(const Json& json, const char* key, std::int64_t least, std::int64_t most) {
  const auto value = json.at(key).get<std::int64_t>();
  if (value < least || value > most) throw std::runtime_error(fmt::format("{}: {}", key, value));
  return static_cast<Number>(value);
}

/// The same for what is read by putting right: written again it has to be what stood there.
void expect_same(const Json& json, const Json& read) {
  for (const auto& [key, value] : read.items())
    if (json.at(key) != value) throw std::runtime_error(fmt::format("{}: {}", key, json.at(key).dump()));
  for (const auto& [key, value] : json.items())
    if (!read.contains(key)) throw std::runtime_error(fmt::format("{}: {}", key, value.dump()));
}

program::ModalState modal_of(const Json& json) {
  const program::ModalState modal = panel::modal_of(json);
  expect_same(json, panel::modal_json(modal));
  return modal;
}

program::Parameters parameters_of(const Json& json) {
  const program::Parameters parameters = panel::parameters_of(json);
  expect_same(json, panel::parameters_json(parameters));
  return parameters;
}

Json start_json(const program::Start& start) {
  const auto& [program, block, position, modal, parameters, compensation] = start;
  return {{"program", program},
          {"block", block},
          {"position", {position.x, position.y, position.z, position.u}},
          {"compensation", compensation},
          {"modal", panel::modal_json(modal)},
          {"parameters", panel::parameters_json(parameters)}};
}

/// The line of HANDEINGABE runs under a number that no stored program can have.
std::uint16_t last_program(const Json& json) {
  const bool is_line = json.value("is_single_function", false);
  return static_cast<std::uint16_t>(language::kLastProgram + (is_line ? 1 : 0));
}

program::Start start_of(const Json& json) {
  program::Start start;
  auto& [program, block, position, modal, parameters, compensation] = start;
  program = number_in<std::uint16_t>(json, "program", 0, last_program(json));
  block = number_in<std::uint16_t>(json, "block", 0, language::kLastBlock);
  const auto place = json.at("position").get<std::array<double, 4>>();
  position = {place[0], place[1], place[2], place[3]};
  json.at("compensation").get_to(compensation);
  modal = modal_of(json.at("modal"));
  parameters = parameters_of(json.at("parameters"));
  return start;
}

Json tools_json(const machine::ToolList& tools) {
  Json list = Json::object();
  for (const auto& [number, tool] : tools.tools()) list[std::to_string(number)] = {tool.radius_mm, tool.length_mm};
  return {{"in_spindle", tools.in_spindle()}, {"list", list}};
}

machine::ToolList tools_of(const Json& json) {
  machine::ToolList tools;
  tools.set_in_spindle(json.at("in_spindle"));
  for (const auto& [number, tool] : json.at("list").items())
    tools.put(std::stoi(number), {tool.at(0).get<double>(), tool.at(1).get<double>()});
  return tools;
}

std::vector<std::string> texts_of(const language::Program& program) {
  std::vector<std::string> texts;
  for (const language::Block& block : program.blocks) texts.push_back(language::write_block(block));
  return texts;
}

std::vector<std::string> texts_of(const db::StoredProgram& program) {
  std::vector<std::string> texts;
  for (const db::StoredBlock& block : program.blocks) texts.push_back(block.text);
  return texts;
}

language::Program program_from(std::uint16_t number, const std::vector<std::string>& texts) {
  language::Program program{number, {}};
  for (const std::string& text : texts) {
    auto block = language::read_block(text, number);
    if (!block) throw std::runtime_error(fmt::format("P{:04}: {}", number, text));
    program.blocks.push_back(std::move(*block));
  }
  return program;
}

/// The numbers of a program's damaged blocks: played again they stop the run as they did.
std::vector<std::uint16_t> damaged_in(const language::Program& program) {
  std::vector<std::uint16_t> numbers;
  for (const language::Block& block : program.blocks)
    if (block.is_damaged) numbers.push_back(block.number);
  return numbers;
}

void mark_damage(const Json& json, language::Program& program) {
  if (!json.contains("damaged")) return;
  const auto numbers = json.at("damaged").value(std::to_string(program.number), std::vector<std::uint16_t>{});
  for (const std::uint16_t number : numbers) program.blocks.at(program.find(number).value()).is_damaged = true;
}

std::uint16_t program_number(const std::string& key, std::uint16_t last) {
  const unsigned long number = std::stoul(key);
  if (number > last) throw std::runtime_error("P" + key);
  return static_cast<std::uint16_t>(number);
}

program::ProgramSet programs_of(const Json& json, db::Database& database, db::PersonId person) {
  program::ProgramSet programs;
  for (const auto& [key, version] : json.at("versions").items()) {
    const std::uint16_t number = program_number(key, language::kLastProgram);
    const auto texts = version_texts(database, person, number, version.get<int>());
    if (!texts) throw std::runtime_error(fmt::format("P{:04} version {}", number, version.get<int>()));
    const auto blocks = std::views::values(*texts);
    language::Program program = program_from(number, {blocks.begin(), blocks.end()});
    mark_damage(json, program);
    programs.put(std::move(program));
  }
  for (const auto& [key, texts] : json.at("texts").items()) {
    const std::uint16_t number = program_number(key, last_program(json));
    language::Program program = program_from(number, texts);
    mark_damage(json, program);
    programs.put(std::move(program));
  }
  return programs;
}

}  // namespace

Json order_json(const panel::RunOrder& order, db::Database& database, db::PersonId person) {
  Json json = start_json(order.start);
  json["data"] = Json::object();
  for (const auto& form : machine::datum_forms())
    json["data"][std::to_string(form.number)] = order.data.get(form.number);
  json["model"] = order.vocabulary.model == language::Model::cnc3250 ? 3250 : 3300;
  json["planned_functions"] = order.vocabulary.planned_functions;
  json["io_cards"] = order.io_cards;
  json["rests_accumulate"] = order.rests_accumulate;
  json["is_single_function"] = order.is_single_function;
  if (order.machine_mm) json["machine_mm"] = *order.machine_mm;
  if (order.tools) json["tools"] = tools_json(*order.tools);
  json["versions"] = json["texts"] = Json::object();
  std::map<int, db::StoredProgram> stored;
  for (auto& program : database.programs(person)) stored.emplace(program.number, std::move(program));
  for (const std::uint16_t number : order.programs.numbers()) {
    const auto found = stored.find(number);
    const auto texts = texts_of(*order.programs.find(number));
    if (const auto damaged = damaged_in(*order.programs.find(number)); !damaged.empty())
      json["damaged"][std::to_string(number)] = damaged;
    if (found != stored.end() && texts_of(found->second) == texts)
      json["versions"][std::to_string(number)] = found->second.version;
    else
      json["texts"][std::to_string(number)] = texts;
  }
  return json;
}

std::expected<panel::RunOrder, std::string> order_of(const Json& json, db::Database& database, db::PersonId person) {
  try {
    panel::RunOrder order;
    order.start = start_of(json);
    // Twice: F START/STOP may not exceed F MAX, in whichever order they come.
    for (int pass = 0; pass < 2; ++pass)
      for (const auto& [number, value] : json.at("data").items())
        static_cast<void>(order.data.set(std::stoi(number), value));
    order.vocabulary.model = json.at("model") == 3250 ? language::Model::cnc3250 : language::Model::cnc3300;
    json.at("planned_functions").get_to(order.vocabulary.planned_functions);
    order.io_cards = json.value("io_cards", order.io_cards);
    order.rests_accumulate = json.value("rests_accumulate", false);
    order.is_single_function = json.value("is_single_function", false);
    if (json.contains("machine_mm")) order.machine_mm = json.at("machine_mm").get<std::array<double, 3>>();
    if (json.contains("tools")) order.tools = tools_of(json.at("tools"));
    order.programs = programs_of(json, database, person);
    const language::Program* const first = order.programs.find(order.start.program);
    if (first == nullptr || !first->find(order.start.block))
      throw std::runtime_error(fmt::format("P{:04} N{:03}", order.start.program, order.start.block));
    return order;
  } catch (const std::exception& error) {  // a record that is not as it was written
    return std::unexpected(error.what());
  }
}

}  // namespace cnclab::lab
