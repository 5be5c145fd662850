// Who may start what over the serial line: every reason, one row (AUTH-013, AUTH-008, DEC-35).
#include "lab/media/dnc_start.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "lab/clock.hpp"

namespace cnclab::lab {
namespace {

using R = RemoteStartRefusal;

constexpr std::int64_t kNow_ns = 1000 * kSecond_ns;
constexpr machine::Epoch kLease{7};
constexpr panel::RemoteStart kStart{.program = 1, .block = 5, .came_ns = kNow_ns - 10};

/// On the lab's machine, released ten seconds ago: the one situation in which it moves.
RemoteStartView released() {
  return {.now_ns = kNow_ns,
          .is_seated = true,
          .on_lab_machine = true,
          .has_lease = true,
          .lease = kLease,
          .armed = panel::Armed{.program = 1, .block = 5, .lease = kLease, .at_ns = kNow_ns - 10 * kSecond_ns}};
}

struct Row {
  const char* name;
  std::function<void(RemoteStartView&, panel::RemoteStart&)> change;
  std::optional<R> expected;
};

const std::vector<Row> kRows{
    {"AUTH_013_released", [](auto&, auto&) {}, std::nullopt},
    {"AUTH_013_after_60_s_to_the_nanosecond", [](auto& v, auto&) { v.armed->at_ns = kNow_ns - 60 * kSecond_ns; },
     std::nullopt},
    {"AUTH_013_a_nanosecond_later", [](auto& v, auto&) { v.armed->at_ns = kNow_ns - 60 * kSecond_ns - 1; },
     R::release_over},
    {"AUTH_013_released_in_the_future", [](auto& v, auto&) { v.armed->at_ns = kNow_ns + 1; }, R::release_over},
    {"AUTH_013_nothing_released", [](auto& v, auto&) { v.armed.reset(); }, R::not_released},
    {"AUTH_013_another_program", [](auto&, auto& s) { s.program = 2; }, R::released_otherwise},
    {"AUTH_013_another_block", [](auto&, auto& s) { s.block = 6; }, R::released_otherwise},
    {"AUTH_002_released_under_another_lease", [](auto& v, auto&) { v.armed->lease = machine::Epoch{6}; },
     R::release_over},
    {"AUTH_002_no_lease", [](auto& v, auto&) { v.has_lease = false; }, R::no_lease},
    {"AUTH_006_halted", [](auto& v, auto&) { v.is_halted = true; }, R::halted},
    {"AUTH_008_a_second_old", [](auto&, auto& s) { s.came_ns = kNow_ns - kSecond_ns; }, std::nullopt},
    {"AUTH_008_older", [](auto&, auto& s) { s.came_ns = kNow_ns - kSecond_ns - 1; }, R::late},
    {"SEC_007_keyboard_locked", [](auto& v, auto&) { v.is_barred = true; }, R::barred},
    {"AUTH_007_nobody_sits_there", [](auto& v, auto&) { v.is_seated = false; }, R::nobody_there},
    {"DEC_35_training", [](auto& v, auto&) { v.on_lab_machine = false; }, R::training},
    {"DEC_35_training_allowed", [](auto& v, auto&) { v.on_lab_machine = false, v.training_start = true; },
     std::nullopt},
    {"DEC_35_training_needs_neither_release_nor_lease",
     [](auto& v, auto&) {
       v.on_lab_machine = v.has_lease = false;
       v.training_start = v.is_halted = true;
       v.armed.reset();
     },
     std::nullopt},
    {"DEC_35_the_permission_is_for_training_alone",
     [](auto& v, auto&) {
       v.training_start = true;
       v.armed.reset();
     },
     R::not_released},
    {"AUTH_008_late_at_training_too",
     [](auto& v, auto& s) {
       v.on_lab_machine = false;
       v.training_start = true;
       s.came_ns = 0;
     },
     R::late}};

class RemoteStartRule : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Rows, RemoteStartRule, testing::ValuesIn(kRows),
                         [](const testing::TestParamInfo<Row>& row) { return row.param.name; });

TEST_P(RemoteStartRule, Says) {
  RemoteStartView view = released();
  panel::RemoteStart start = kStart;
  GetParam().change(view, start);
  EXPECT_EQ(refusal_of(start, view), GetParam().expected);
}

TEST(RemoteStartRule, EveryRefusalHasASentenceInBothLanguages) {
  for (int i = 0; i <= static_cast<int>(R::release_over); ++i) {
    const Refusal text = text_of(static_cast<R>(i));
    EXPECT_TRUE(text.german.ends_with('.')) << i;
    EXPECT_TRUE(text.english.ends_with('.')) << i;
  }
}

}  // namespace
}  // namespace cnclab::lab
