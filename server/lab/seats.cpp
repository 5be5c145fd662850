// Desks by person, station and login; hands in order.
#include "lab/seats.hpp"

#include <algorithm>

namespace cnclab::lab {

Seats::DeskPtr Seats::at(int station) const {
  for (const DeskPtr& desk : all())
    if (desk->station == station && desk->is_seated()) return desk;
  return nullptr;
}

Seats::DeskPtr Seats::shown_at(int station) const {
  DeskPtr shown = at(station);
  if (shown) return shown;
  for (const DeskPtr& desk : all())
    if (desk->station == station && (!shown || desk->keep_until_ns > shown->keep_until_ns)) shown = desk;
  return shown;
}

Seats::DeskPtr Seats::of(db::PersonId person) const {
  const auto found = desks_.find(person);
  return found == desks_.end() ? nullptr : found->second;
}

Seats::DeskPtr Seats::with(LoginId login) const {
  for (const DeskPtr& desk : all())
    if (desk->login == login) return desk;
  return nullptr;
}

void Seats::turn_hand(const DeskPtr& desk) {
  if (hand_of(*desk) > 0)
    lower_hand(*desk);
  else
    hands_.push_back(desk);
}

void Seats::lower_hand(const Desk& desk) {
  std::erase_if(hands_, [&](const auto& hand) { return hand.lock().get() == &desk; });
}

int Seats::hand_of(const Desk& desk) const {
  const auto raised = std::ranges::find_if(hands_, [&](const auto& hand) { return hand.lock().get() == &desk; });
  return raised == hands_.end() ? 0 : static_cast<int>(raised - hands_.begin()) + 1;
}

}  // namespace cnclab::lab
