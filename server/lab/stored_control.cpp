// Database rows to blocks and back.
#include "lab/stored_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "language/tape.hpp"

namespace cnclab::lab {

namespace {

language::Block block_of(int program, const db::StoredBlock& stored) {
  const auto number = static_cast<std::uint16_t>(program);
  auto block = language::read_block(stored.text, number);
  const bool fits =
      block && block->number == stored.number && language::check_code(number, stored.text) == stored.check_code;
  if (fits) return *block;
  language::Block damaged = block.value_or(language::Block{});
  damaged.number = static_cast<std::uint16_t>(stored.number);
  damaged.is_damaged = true;
  return damaged;
}

/// The same block under another number, for insertion.
db::StoredBlock renumbered(int program, const db::StoredBlock& stored, int number) {
  language::Block block = block_of(program, stored);
  if (block.is_damaged) {  // keep the damage visible: text and code stay as they are
    return {number, stored.text, stored.check_code};
  }
  block.number = static_cast<std::uint16_t>(number);
  return stored_block(program, block);
}

bool is_sound(const db::StoredDatum& datum) {
  return stored_datum(datum.number, datum.value).check_code == datum.check_code;
}

/// F START/STOP may not exceed F MAX, so the order of setting matters: greatest numbers last would refuse a valid set.
machine::MachineData set_from(const std::vector<db::StoredDatum>& data) {
  machine::MachineData result;
  for (int pass = 0; pass < 2; ++pass)
    for (const auto& datum : data) static_cast<void>(result.set(datum.number, datum.value));
  return result;
}

struct CarryOut {
  db::Database& database;
  db::PersonId person;
  const db::Author& author;

  void operator()(const panel::PutBlock& put) const {
    database.put_block(person, put.program, stored_block(put.program, put.block), author);
  }
  void operator()(const panel::InsertBlock& insert) const {
    const int program = insert.program;
    database.insert_block(
        person, program, stored_block(program, insert.block), author,
        [program](const db::StoredBlock& old, int number) { return renumbered(program, old, number); });
  }
  void operator()(const panel::DeleteBlock& erase) const {
    database.delete_block(person, erase.program, erase.block, author);
  }
  void operator()(const panel::RemovePrograms& remove) const {
    for (const auto number : remove.programs) database.remove_program(person, number, author);
  }
  /// Only what has changed becomes a version; a datum whose check code was wrong has changed.
  void operator()(const panel::PutMachineData& put) const {
    const std::vector<db::StoredDatum> before = database.machine_data(person);
    database.transaction([&] {
      for (const auto& form : machine::datum_forms()) {
        const db::StoredDatum datum = stored_datum(form.number, put.data.get(form.number));
        const auto old = std::ranges::find(before, datum.number, &db::StoredDatum::number);
        const bool stands_there = old == before.end()  // what is missing has its default
                                      ? datum.value == machine::MachineData{}.get(form.number)
                                      : old->value == datum.value && old->check_code == datum.check_code;
        if (!stands_there) database.put_machine_datum(person, datum, author);
      }
    });
  }
  void operator()(const panel::PutPrograms& put) const {
    database.transaction([&] {
      (*this)(panel::RemovePrograms{put.removed});
      for (const language::Program& program : put.programs)
        database.replace_program(person, program.number, stored_blocks(program), author);
      if (put.data) (*this)(panel::PutMachineData{*put.data});
    });
  }
  void operator()(const panel::EraseMemory& all) const {
    database.transaction([&] {
      (*this)(panel::RemovePrograms{all.programs});
      (*this)(panel::PutMachineData{all.data});
    });
  }
};

}  // namespace

StoredControl read_control(db::Database& database, db::PersonId person) {
  StoredControl control{database.programs(person), database.machine_data(person), database.control_state(person), {}};
  control.cassettes.list = database.cassettes(person);
  for (const db::StoredCassette& cassette : control.cassettes.list)
    if (cassette.is_inserted) control.cassettes.tape = database.tape(person, cassette.id);
  return control;
}

panel::Memory memory_of(const std::vector<db::StoredProgram>& programs, int memory_bytes) {
  panel::Memory memory(memory_bytes);
  for (const auto& stored : programs) {
    language::Program program{static_cast<std::uint16_t>(stored.number), {}};
    program.blocks.reserve(stored.blocks.size());
    for (const auto& block : stored.blocks) program.blocks.push_back(block_of(stored.number, block));
    memory.put_program(std::move(program));
  }
  return memory;
}

bool is_damaged(const std::vector<db::StoredDatum>& data) { return !std::ranges::all_of(data, is_sound); }

int used_bytes(const panel::Memory& memory) {
  int bytes = 0;
  for (const language::Program& program : memory.programs())
    for (const language::Block& block : program.blocks) bytes += language::cost_bytes(block);
  return bytes;
}

machine::MachineData machine_data_of(const std::vector<db::StoredDatum>& data) {
  return is_damaged(data) ? machine::MachineData{} : set_from(data);
}

FoundMachineData lab_machine_data_of(const std::vector<db::StoredDatum>& data) {
  FoundMachineData found;
  if (data.empty()) return found;  // never changed: as delivered
  std::vector<db::StoredDatum> sound;
  std::ranges::copy_if(data, std::back_inserter(sound), is_sound);
  found.data = set_from(sound);
  for (const auto& form : machine::datum_forms())
    if (const auto datum = std::ranges::find(sound, form.number, &db::StoredDatum::number);
        datum == sound.end() || found.data.get(form.number) != datum->value)
      found.damaged.push_back(form.number);
  return found;
}

db::StoredBlock stored_block(int program, const language::Block& block) {
  std::string text = language::write_block(block);
  const std::uint32_t code = language::check_code(static_cast<std::uint16_t>(program), text);
  return {block.number, std::move(text), code};
}

std::vector<db::StoredBlock> stored_blocks(const language::Program& program) {
  std::vector<db::StoredBlock> blocks;
  blocks.reserve(program.blocks.size());
  for (const auto& block : program.blocks) blocks.push_back(stored_block(program.number, block));
  return blocks;
}

db::StoredDatum stored_datum(int number, std::int64_t value) {
  return {number, value, language::datum_check_code(number, value)};
}

std::string renumbered_text(int program, const std::string& text, int number) {
  auto block = language::read_block(text, static_cast<std::uint16_t>(program));
  if (!block) return text;
  block->number = static_cast<std::uint16_t>(number);
  return language::write_block(*block);
}

std::optional<db::BlockTexts> version_texts(db::Database& database, db::PersonId person, int program, int version) {
  return database.program_at(person, program, version, [program](const std::string& text, int number) {
    return renumbered_text(program, text, number);
  });
}

bool is_damaged(int program, const db::StoredBlock& block) { return block_of(program, block).is_damaged; }

std::string change_text(const panel::StoreRequest& request) {
  if (const auto* put = std::get_if<panel::PutBlock>(&request))
    return fmt::format("put P{:04} N{:03}", put->program, put->block.number);
  if (const auto* insert = std::get_if<panel::InsertBlock>(&request))
    return fmt::format("insert P{:04} N{:03}", insert->program, insert->block.number);
  if (const auto* erase = std::get_if<panel::DeleteBlock>(&request))
    return fmt::format("delete P{:04} N{:03}", erase->program, erase->block);
  std::string text;
  if (const auto* remove = std::get_if<panel::RemovePrograms>(&request)) {
    for (const auto number : remove->programs) text += fmt::format(" P{:04}", number);
    return "remove" + text;
  }
  if (const auto* put = std::get_if<panel::PutPrograms>(&request)) {
    for (const auto& program : put->programs) text += fmt::format(" P{:04}", program.number);
    return "read" + text + (put->data ? " machine data" : "");
  }
  if (std::holds_alternative<panel::EraseMemory>(request)) return "erase the whole memory";
  return "machine data";
}

void carry_out(db::Database& database, db::PersonId person, const panel::StoreRequest& request,
               const db::Author& author) {
  std::visit(CarryOut{database, person, author}, request);
}

}  // namespace cnclab::lab
