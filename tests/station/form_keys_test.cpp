// The keys of the login form and of the dialog for a new password (SEAT-002, SEC-002).
#include "station/form_keys.hpp"

#include <gtest/gtest.h>

namespace cnclab::station {
namespace {

struct Row {
  const char* name;
  Special key;
  std::size_t from, to;  ///< of three fields
  FormAct act;
};

constexpr Row kRows[] = {
    {"Enter goes on", Special::enter, 0, 1, FormAct::none},
    {"Enter in the last hands in", Special::enter, 2, 2, FormAct::submit},
    {"down", Special::down, 1, 2, FormAct::none},
    {"down stops at the last", Special::down, 2, 2, FormAct::none},
    {"up", Special::up, 2, 1, FormAct::none},
    {"up stops at the first", Special::up, 0, 0, FormAct::none},
    {"Tab", Special::tab, 1, 2, FormAct::none},
    {"Tab goes round", Special::tab, 2, 0, FormAct::none},
    {"backspace", Special::backspace, 1, 1, FormAct::erase},
    {"Esc", Special::escape, 1, 1, FormAct::cancel},
    {"Ctrl-C", Special::ctrl_c, 1, 1, FormAct::cancel},
    {"others do nothing", Special::left, 1, 1, FormAct::none},
};

TEST(FormKeys, SEAT_002_LeadThroughThreeFields) {
  for (const Row& row : kRows) {
    std::size_t current = row.from;
    EXPECT_EQ(lead_through(row.key, 3, current), row.act) << row.name;
    EXPECT_EQ(current, row.to) << row.name;
  }
}

TEST(FormKeys, SEAT_002_AFormOfOneFieldHasNoOther) {
  for (const Special key : {Special::up, Special::down, Special::tab}) {
    std::size_t current = 0;
    EXPECT_EQ(lead_through(key, 1, current), FormAct::none);
    EXPECT_EQ(current, 0U);
  }
}

}  // namespace
}  // namespace cnclab::station
