// Who may start what over a serial line (AUTH-013).
#include <fmt/format.h>

#include "lab/lab.hpp"
#include "lab/media/dnc_start.hpp"

namespace cnclab::lab {

void Lab::judge_remote_start(const DeskPtr& desk, const panel::RemoteStart& start) {
  const RemoteStartView view{.now_ns = clock_.monotonic_ns(),
                             .is_seated = desk->is_seated(),
                             .is_barred = bar(*desk).has_value(),
                             .on_lab_machine = desk->on_lab_machine,
                             .training_start = configuration_.dnc_training_start,
                             .has_lease = authority_.holder() == desk->login && !machine_view().lease_dead,
                             .is_halted = authority_.is_halted(),
                             .lease = authority_.newest(),
                             .armed = desk->control.armed()};
  const auto refusal = refusal_of(start, view);
  const std::string place = fmt::format("P{:04} N{:03}", start.program, start.block);
  journal_.write(refusal ? "remote_start_refused" : "remote_start",
                 refusal ? place + ": " + text_of(*refusal).english : place, desk->station, desk->person.name,
                 desk->on_lab_machine ? authority_.newest() : Epoch{});
  const std::string sentence = refusal ? text_of(*refusal).in(tongue_of(desk->person)) : std::string();
  outcome(desk, desk->control.answer_remote_start(sentence, now(*desk)), 0);
}

}  // namespace cnclab::lab
