// Feeds any text to the reader of a recorded run's order: refused in words, or an order that is kept and read as the
// same again (STO-007).
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "lab/runs/run_order_json.hpp"

namespace db = cnclab::db;
namespace lab = cnclab::lab;

namespace {

/// One person with one program of two versions.
struct Kept {
  db::Database database = db::Database::open(":memory:").value();
  db::PersonId eva{};
  Kept() {
    db::Person person;
    person.name = "eva";
    person.role = "student";
    eva = database.add_person(person, 1).value();
    for (const char* text : {"N001G01X+1000", "N001G01X+2000"}) database.put_block(eva, 1, {1, text, 0}, {"eva", 1, 1});
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Kept kept;
  const auto json = nlohmann::json::parse(data, data + size, nullptr, false);
  if (json.is_discarded()) return 0;
  const auto order = lab::order_of(json, kept.database, kept.eva);
  if (!order) {
    if (order.error().empty()) std::abort();
    return 0;
  }
  const auto written = lab::order_json(*order, kept.database, kept.eva);
  const auto again = lab::order_of(written, kept.database, kept.eva);
  if (!again || lab::order_json(*again, kept.database, kept.eva) != written) std::abort();
  return 0;
}
