// The rule of remote starts, in the order in which its reasons are given.
#include "lab/media/dnc_start.hpp"

namespace cnclab::lab {

namespace {

constexpr std::int64_t kOldest_ns = 1'000'000'000;  ///< AUTH-008

using R = RemoteStartRefusal;

std::optional<R> refusal_on_machine(const panel::RemoteStart& start, const RemoteStartView& view) {
  if (!view.has_lease) return R::no_lease;
  if (view.is_halted) return R::halted;
  if (!view.armed) return R::not_released;
  const panel::Armed& armed = *view.armed;
  if (armed.program != start.program || armed.block != start.block) return R::released_otherwise;
  const bool is_over = view.now_ns - armed.at_ns > panel::Armed::kValid_ns || armed.at_ns > view.now_ns;
  if (is_over || armed.lease != view.lease) return R::release_over;
  return std::nullopt;
}

}  // namespace

std::optional<R> refusal_of(const panel::RemoteStart& start, const RemoteStartView& view) {
  if (!view.is_seated) return R::nobody_there;
  if (view.is_barred) return R::barred;
  if (view.now_ns - start.came_ns > kOldest_ns) return R::late;
  if (view.on_lab_machine) return refusal_on_machine(start, view);
  return view.training_start ? std::nullopt : std::optional(R::training);
}

Refusal text_of(R refusal) {
  switch (refusal) {
    case R::nobody_there:
      return {"Fernstart abgelehnt: am Platz sitzt niemand.", "Remote start refused: nobody sits at the station."};
    case R::barred:
      return {"Fernstart abgelehnt: die Tastatur ist gesperrt oder übernommen.",
              "Remote start refused: the keyboard is locked or taken over."};
    case R::late:
      return {"Fernstart abgelehnt: er kam zu spät an.", "Remote start refused: it came too late."};
    case R::training:
      return {"Fernstart abgelehnt: dieser Platz hat die Maschine nicht.",
              "Remote start refused: this station does not have the machine."};
    case R::no_lease:
      return {"Fernstart abgelehnt: die Maschine wurde diesem Platz genommen.",
              "Remote start refused: the machine was taken from this station."};
    case R::halted:
      return {"Fernstart abgelehnt: MASCHINE HALT ist gedrückt.", "Remote start refused: MASCHINE HALT is pressed."};
    case R::not_released:
      return {"Fernstart abgelehnt: erst auf diesem Platz in EXTERNE DATEN mit START erlauben.",
              "Remote start refused: first release it with START in EXTERNE DATEN at this station."};
    case R::released_otherwise:
      return {"Fernstart abgelehnt: erlaubt ist ein anderes Programm oder ein anderer Satz.",
              "Remote start refused: another program or block is released."};
    case R::release_over:
      return {"Fernstart abgelehnt: die Erlaubnis ist abgelaufen.", "Remote start refused: the release is over."};
  }
  return {};
}

}  // namespace cnclab::lab
