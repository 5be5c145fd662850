// Who sits where: the desks of all who are logged in, and the raised hands in their order.
#pragma once

#include <map>
#include <memory>
#include <ranges>
#include <vector>

#include "lab/desk.hpp"

namespace cnclab::lab {

class Seats {
 public:
  using DeskPtr = std::shared_ptr<Desk>;

  /// All desks, also those whose line is broken (SEAT-004).
  [[nodiscard]] auto all() const { return std::views::values(desks_); }
  /// A copy of the list, for loops that may end logins.
  [[nodiscard]] std::vector<DeskPtr> list() const { return {all().begin(), all().end()}; }
  /// Who has a connection at that station; nullptr: nobody.
  [[nodiscard]] DeskPtr at(int station) const;
  /// Who is to be seen at that station: who has a connection there, else whose control is kept there, the last one that
  /// left; nullptr: nobody.
  [[nodiscard]] DeskPtr shown_at(int station) const;
  /// Where a person works; nullptr: not logged in.
  [[nodiscard]] DeskPtr of(db::PersonId person) const;
  [[nodiscard]] DeskPtr with(LoginId login) const;

  void add(const DeskPtr& desk) { desks_[desk->person.id] = desk; }
  void remove(const Desk& desk) { desks_.erase(desk.person.id); }
  void clear() { desks_.clear(); }

  /// Raises the hand, or lowers it (INS-006).
  void turn_hand(const DeskPtr& desk);
  void lower_hand(const Desk& desk);
  /// From 1 on in the order of raising; 0: not raised.
  [[nodiscard]] int hand_of(const Desk& desk) const;

 private:
  std::map<db::PersonId, DeskPtr> desks_;
  std::vector<std::weak_ptr<Desk>> hands_;
};

}  // namespace cnclab::lab
