// How a console's question goes to the store and its answer comes back; shared by the console's files only.
#pragma once

#include <expected>
#include <utility>

#include "lab/console/console.hpp"

namespace cnclab::lab {

/// A job may refuse by throwing `Refusal` before it has changed anything; the store then keeps the others' work.
template <class Job, class Then>
void Console::ask_store(const Reply& reply, Job job, Then then) const {
  using Result = std::invoke_result_t<Job, db::Database&>;
  using Outcome = std::expected<Result, Refusal>;
  lab_.store_.run(
      [job = std::move(job)](db::Database& database) mutable -> Outcome {
        try {
          return job(database);
        } catch (const Refusal& refusal) {
          return std::unexpected(refusal);
        }
      },
      [&lab = lab_, alive = lab_.alive_, reply,
       then = std::move(then)](std::expected<Outcome, db::StoreError> result) mutable {
        if (!*alive || reply.visit->stage != Stage::at_console) return;
        const Console console(lab);
        if (!result) return console.send_error(reply, result.error().text);
        if (!*result) return console.send_error(reply, result->error().in(reply.tongue));
        then(console, std::move(**result));
      });
}

/// The person of a name, or a refusal.
[[nodiscard]] db::Person person_named(db::Database& database, const std::string& name);

/// Memory that a stored block takes; one that cannot be read takes what its number and check code take.
[[nodiscard]] int stored_cost(int program, const db::StoredBlock& block);

}  // namespace cnclab::lab
