// Random changes of two persons against a plain map that remembers every state (STO-001, STO-005).
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "lab_folder.hpp"

namespace cnclab::db {
namespace {

// The same random numbers each time; RC_PARAMS from outside (long runs) wins.
[[maybe_unused]] const int kSeeded = ::setenv("RC_PARAMS", "seed=3300 max_success=25", 0);

using Blocks = std::map<int, std::string>;  // number -> words

struct ModelProgram {
  Blocks blocks;
  bool is_stored = false;
  std::vector<Blocks> versions;  // versions[0] is version 1
};

struct Model {
  std::map<std::pair<int, int>, ModelProgram> programs;  // {person, program}

  void change(int person, int program, Blocks blocks, bool is_stored) {
    ModelProgram& changed = programs[{person, program}];
    changed.blocks = std::move(blocks);
    changed.is_stored = is_stored;
    changed.versions.push_back(changed.blocks);
  }
};

std::vector<std::string> texts(const Blocks& blocks) {
  std::vector<std::string> list;
  for (const auto& [number, words] : blocks) list.push_back(block(number, words).text);
  return list;
}

std::vector<StoredBlock> stored(const Blocks& blocks) {
  std::vector<StoredBlock> list;
  for (const auto& [number, words] : blocks) list.push_back(block(number, words));
  return list;
}

std::string any_words() { return *rc::gen::element<std::string>("G00X+1", "G01Y-20", "G04H0010", "M05"); }

void insert(Database& database, PersonId id, Model& model, int person, int program, int number) {
  const Blocks& old = model.programs[{person, program}].blocks;
  const std::string words = any_words();
  Blocks after;
  for (const auto& [n, w] : old) after[n >= number ? n + 1 : n] = w;
  after[number] = words;
  database.insert_block(id, program, block(number, words), kAuthor, renumbered);
  model.change(person, program, std::move(after), true);
}

void replace(Database& database, PersonId id, Model& model, int person, int program) {
  Blocks after;
  for (const int number : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 13))) after[number] = any_words();
  database.replace_program(id, program, stored(after), kAuthor);
  model.change(person, program, std::move(after), true);
}

void step(Database& database, PersonId id, Model& model, int person) {
  const int program = *rc::gen::inRange(0, 3);
  const int number = *rc::gen::inRange(1, 13);
  Blocks blocks = model.programs[{person, program}].blocks;
  switch (*rc::gen::weightedElement<int>({{5, 0}, {3, 1}, {3, 2}, {1, 3}, {1, 4}})) {
    case 0:
      blocks[number] = any_words();
      database.put_block(id, program, block(number, blocks[number]), kAuthor);
      return model.change(person, program, std::move(blocks), true);
    case 1:
      return insert(database, id, model, person, program, number);
    case 2:
      database.delete_block(id, program, number, kAuthor);
      if (blocks.erase(number) > 0) model.change(person, program, std::move(blocks), true);
      return;
    case 3:
      return replace(database, id, model, person, program);
    default:
      database.remove_program(id, program, kAuthor);
      if (model.programs[{person, program}].is_stored) model.change(person, program, {}, false);
  }
}

void compare(Database& database, const std::vector<PersonId>& people, const Model& model) {
  std::size_t stored_programs = 0;
  for (const auto& [key, expected] : model.programs) {
    const PersonId id = people.at(static_cast<std::size_t>(key.first));
    for (std::size_t i = 0; i < expected.versions.size(); ++i)
      RC_ASSERT(texts_at(database, id, key.second, static_cast<int>(i) + 1) == texts(expected.versions[i]));
    RC_ASSERT(database.versions(id, key.second).size() == expected.versions.size());
    if (expected.is_stored) ++stored_programs;
    for (const StoredProgram& program : database.programs(id))
      if (program.number == key.second) {
        RC_ASSERT(expected.is_stored);
        RC_ASSERT(program.blocks == stored(expected.blocks));
        RC_ASSERT(program.version == static_cast<int>(expected.versions.size()));
      }
  }
  RC_ASSERT(database.programs(people[0]).size() + database.programs(people[1]).size() == stored_programs);
}

RC_GTEST_PROP(VersionsModel, EveryVersionOfEveryProgramComesBackAfterAnyChanges, ()) {
  const LabFolder folder;
  auto database = std::make_unique<Database>(opened(folder.file()));
  const std::vector<PersonId> people{add_student(*database, "anna"), add_student(*database, "berta")};
  Model model;
  const int steps = *rc::gen::inRange(1, 60);
  for (int i = 0; i < steps; ++i) {
    const int person = *rc::gen::inRange(0, 2);
    database->transaction([&] { step(*database, people[static_cast<std::size_t>(person)], model, person); });
    if (*rc::gen::inRange(0, 20) == 0) {
      database.reset();  // its lock goes first
      database = std::make_unique<Database>(opened(folder.file()));
      compare(*database, people, model);
    }
  }
  compare(*database, people, model);
}

}  // namespace
}  // namespace cnclab::db
