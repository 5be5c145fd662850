// Programs and their blocks: the newest state, changed together with the record of the change.
#include <algorithm>
#include <ranges>

#include "db/block_list.hpp"
#include "db/change.hpp"
#include "db/statements.hpp"

namespace cnclab::db {
namespace {

std::vector<StoredBlock> blocks_from(Connection& connection, PersonId id, int program, int first) {
  Query query(connection,
              "SELECT number, text, check_code FROM block WHERE person_id = ?1 AND program = ?2 AND number >= ?3 "
              "ORDER BY number",
              id, program, first);
  std::vector<StoredBlock> blocks;
  while (query.next()) blocks.push_back({query.small(0), query.text(1), static_cast<std::uint32_t>(query.integer(2))});
  return blocks;
}

std::string block_text(Connection& connection, PersonId id, int program, int number) {
  Query query(connection, "SELECT text FROM block WHERE person_id = ?1 AND program = ?2 AND number = ?3", id, program,
              number);
  return query.next() ? query.text(0) : std::string{};
}

bool has_program(Connection& connection, PersonId id, int program) {
  return Query(connection, "SELECT 1 FROM program WHERE person_id = ?1 AND number = ?2", id, program).next();
}

void write_block(Connection& connection, PersonId id, int program, const StoredBlock& block) {
  Query(connection,
        "INSERT INTO block (person_id, program, number, text, check_code) VALUES (?1, ?2, ?3, ?4, ?5) "
        "ON CONFLICT (person_id, program, number) DO UPDATE SET text = excluded.text, check_code = excluded.check_code",
        id, program, block.number, block.text, block.check_code)
      .run();
}

void move_block(Connection& connection, PersonId id, int program, int from, const StoredBlock& to) {
  Query(connection,
        "UPDATE block SET number = ?4, text = ?5, check_code = ?6 "
        "WHERE person_id = ?1 AND program = ?2 AND number = ?3",
        id, program, from, to.number, to.text, to.check_code)
      .run();
}

void delete_blocks(Connection& connection, PersonId id, int program) {
  Query(connection, "DELETE FROM block WHERE person_id = ?1 AND program = ?2", id, program).run();
}

}  // namespace

std::vector<StoredProgram> Database::programs(PersonId id) {
  std::vector<StoredProgram> found;
  {
    Query query(*statements_, "SELECT number, version, changed_ms FROM program WHERE person_id = ?1 ORDER BY position",
                id);
    while (query.next()) found.push_back({query.small(0), query.small(1), query.integer(2), {}});
  }
  for (StoredProgram& program : found) program.blocks = blocks_from(*statements_, id, program.number, 0);
  return found;
}

void Database::put_block(PersonId id, int program, const StoredBlock& block, const Author& author) {
  check_storable(block);
  transaction([&] {
    const std::string before = block_text(*statements_, id, program, block.number);
    record_change(*statements_, {id, program, "put", block.number, before, block.text, author});
    write_block(*statements_, id, program, block);
  });
}

void Database::insert_block(PersonId id, int program, const StoredBlock& block, const Author& author,
                            const std::function<StoredBlock(const StoredBlock&, int)>& renumber) {
  check_storable(block);
  transaction([&] {
    const auto following = blocks_from(*statements_, id, program, block.number);
    record_change(*statements_, {id, program, "insert", block.number, write_list(following), block.text, author});
    // From the back, so that no number is taken twice at any moment.
    for (const StoredBlock& moved : following | std::views::reverse) {
      StoredBlock renumbered = renumber(moved, moved.number + 1);
      renumbered.number = moved.number + 1;
      check_storable(renumbered);
      move_block(*statements_, id, program, moved.number, renumbered);
    }
    write_block(*statements_, id, program, block);
  });
}

void Database::delete_block(PersonId id, int program, int block, const Author& author) {
  transaction([&] {
    const std::string before = block_text(*statements_, id, program, block);
    if (before.empty()) return;
    record_change(*statements_, {id, program, "delete", block, before, "", author});
    Query(*statements_, "DELETE FROM block WHERE person_id = ?1 AND program = ?2 AND number = ?3", id, program, block)
        .run();
  });
}

void Database::replace_program(PersonId id, int program, const std::vector<StoredBlock>& blocks, const Author& author) {
  std::vector<StoredBlock> ascending = blocks;
  std::ranges::sort(ascending, {}, &StoredBlock::number);
  for (const StoredBlock& block : ascending) check_storable(block);
  if (std::ranges::adjacent_find(ascending, {}, &StoredBlock::number) != ascending.end())
    throw StoreFailure(FailureKind::refused, "a program with the same block number twice");
  transaction([&] {
    const std::string before = write_list(blocks_from(*statements_, id, program, 0));
    record_change(*statements_, {id, program, "replace", 0, before, write_list(ascending), author});
    delete_blocks(*statements_, id, program);
    for (const StoredBlock& block : ascending) write_block(*statements_, id, program, block);
  });
}

void Database::remove_program(PersonId id, int program, const Author& author) {
  transaction([&] {
    if (!has_program(*statements_, id, program)) return;
    const std::string before = write_list(blocks_from(*statements_, id, program, 0));
    record_change(*statements_, {id, program, "remove", 0, before, "", author});
    Query(*statements_, "DELETE FROM program WHERE person_id = ?1 AND number = ?2", id, program).run();
  });
}

}  // namespace cnclab::db
