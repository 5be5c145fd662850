// A key that orders something from the machine counts as handled when the machine has taken it; what TEACH IN drives is
// recorded. The beat is real here, the lab's clock stands still: nothing but the change itself can bring a screen.
#include <gtest/gtest.h>

#include <chrono>

#include "small_lab.hpp"

namespace cnclab::lab {
namespace {

class MachineAnswer : public testing::Test, protected SmallLab {
 protected:
  MachineAnswer() { log_in(eva_, "eva", 7); }

  /// Polls until `condition`; false when that was not enough.
  bool poll_until(const std::function<bool()>& condition) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition() && std::chrono::steady_clock::now() < limit) {
      poll();
      look(eva_);
    }
    return condition();
  }
  /// Struck one behind the other, as fast as they come; then all of them have been handled.
  void keys(std::initializer_list<Key> struck) {
    for (const Key key : struck) strike(eva_, key);
    ASSERT_TRUE(poll_until([this] { return eva_.handled == eva_.number; }));
  }
  /// As `keys`, where the last of them is stored before it is handled.
  void store_keys(std::initializer_list<Key> struck) {
    for (const Key key : struck) strike(eva_, key);
    settle_until([this] {
      poll();
      look(eva_);
      return eva_.handled == eva_.number;
    });
  }
  [[nodiscard]] bool shows(const std::string& text) const {
    for (int row = 0; row < Screen::kRows; ++row)
      if (desk().view.screen.text(row).contains(text)) return true;
    return false;
  }
  [[nodiscard]] const Desk& desk() const { return *eva_.visit->desk; }
  [[nodiscard]] bool is_at_rest() const {
    return !desk().control.is_running() && !desk().training()->snapshot().started;
  }

  std::vector<db::RunRecord> runs() {
    std::vector<db::RunRecord> runs;
    with_database([&runs](db::Database& database) { runs = database.runs(database.person("eva")->id); });
    return runs;
  }

  Caller eva_ = call();
};

TEST_F(MachineAnswer, AHandledKeysLampStandsOnTheScreenAndTwoInARowSwitchTwice) {
  keys({Key::HAND});
  for (int i = 0; i < 10; ++i) {
    keys({Key::KUEHLMITTEL});
    EXPECT_TRUE(shows("KUEHLM.  ●")) << i;
    keys({Key::FRAESER, Key::FRAESER, Key::FRAESER});
    EXPECT_TRUE(shows("SPINDEL  ↻")) << i;
    keys({Key::FRAESER, Key::KUEHLMITTEL, Key::FRAESER, Key::FRAESER});
    EXPECT_TRUE(shows("SPINDEL  ○")) << i;
    EXPECT_TRUE(shows("KUEHLM.  ○")) << i;
  }
}

TEST_F(MachineAnswer, LampsFollowTheMachineWithoutAKey) {
  keys({Key::HAND, Key::FRAESER});
  ASSERT_TRUE(shows("SPINDEL  ↻"));
  desk().training()->stop(machine::StopCause::machine_halt);
  EXPECT_TRUE(poll_until([this] { return shows("SPINDEL  ○"); }));
}

TEST_F(MachineAnswer, AFunctionOfHandeingabeWithoutAWayIsOverWhenItsStartIsHandled) {
  keys({Key::HANDEINGABE, Key::D1, Key::D8, Key::START, Key::D9, Key::D0, Key::START, Key::D1, Key::D9, Key::START});
  EXPECT_TRUE(shows("G19")) << "no key was lost behind a START";
  EXPECT_TRUE(shows("G90"));
}

TEST_F(MachineAnswer, DEC_39_ResetActsThroughTheLabsMenu) {
  keys({Key::HAND, Key::FRAESER, Key::PLUS_X, Key::START});
  ASSERT_TRUE(poll_until([this] { return desk().training()->snapshot().istwert_mm[0] > 1; }));
  keys({Key::LABOR});
  ASSERT_TRUE(desk().labor);
  keys({Key::RESET});
  EXPECT_FALSE(desk().labor);
  EXPECT_EQ(desk().control.mode(), panel::Mode::menu);
  EXPECT_TRUE(poll_until([this] { return is_at_rest(); }));
  EXPECT_TRUE(shows("SPINDEL  ○"));
}

// DEC-59: keys that the control never sees come between C and →, too.
TEST_F(MachineAnswer, DEC_59_TheLabsKeysEndWhatCHasBegun) {
  store_keys({Key::EINGABE, Key::ENTER, Key::ENTER, Key::D0, Key::D0, Key::ENTER, Key::D1, Key::D0, Key::EINGABE});
  keys({Key::MENU, Key::SPEICHER_LOESCHEN});
  keys({Key::CLEAR, Key::MELDUNG, Key::MELDUNG, Key::ENTER});
  keys({Key::CLEAR, Key::LABOR, Key::LABOR, Key::ENTER});
  keys({Key::CLEAR, Key::MASCHINE_HALT, Key::MASCHINE_HALT, Key::ENTER});
  EXPECT_EQ(desk().control.memory().programs().size(), 1U);
  store_keys({Key::CLEAR, Key::ENTER});
  EXPECT_TRUE(desk().control.memory().programs().empty());
}

// interfaces.md section 3: `key 2`, then `screen`. The lab's clock stands still, so no tick of it brings the picture.
TEST_F(MachineAnswer, AViewOfGrafikStandsOnTheScreenWhenItsKeyIsHandled) {
  store_keys({Key::EINGABE, Key::ENTER, Key::ENTER, Key::D0, Key::D0, Key::ENTER, Key::D1, Key::D0, Key::EINGABE});
  keys({Key::MENU, Key::GRAFIK, Key::ENTER, Key::START});
  ASSERT_TRUE(poll_until([this] { return shows("100 %  X-Y "); }));
  for (int i = 0; i < 5; ++i) {
    keys({Key::D2});
    EXPECT_TRUE(shows("100 %  X-Z ")) << i;
    keys({Key::D1});
    EXPECT_TRUE(shows("100 %  X-Y ")) << i;
  }
  keys({Key::EINZELSATZ, Key::START});
  EXPECT_TRUE(shows("P0001 N001 100 %  X-Y ")) << "the step is played when START is handled";
}

TEST_F(MachineAnswer, STO_007_TeachInIsRecordedOnTheTrainingMachineAndPlayedAgain) {
  keys({Key::HAND, Key::MINUS_Y, Key::START, Key::STOP});
  ASSERT_TRUE(poll_until([this] { return is_at_rest(); }));
  keys({Key::MENU, Key::TEACH_IN, Key::ENTER, Key::PLUS_X, Key::START});
  ASSERT_TRUE(poll_until([this] { return desk().training()->snapshot().istwert_mm[0] > 1; }));
  keys({Key::STOP});
  ASSERT_TRUE(poll_until([this] { return is_at_rest(); }));
  poll();
  const std::vector<db::RunRecord> recorded = runs();
  ASSERT_EQ(recorded.size(), 1U) << "HANDBETRIEB on the training machine is none";
  EXPECT_EQ(recorded[0].machine, "training");
  EXPECT_EQ(recorded[0].program, 1);
  EXPECT_EQ(recorded[0].ended, "stop");
  EXPECT_GT(recorded[0].ticks, 20);
  Caller console = call(v1::CLIENT_KIND_INSTRUCTOR);
  log_in(console, "lehrer", 0);
  v1::InstructorRequest request;
  request.mutable_run_replay()->set_run(static_cast<std::uint32_t>(recorded[0].id));
  const v1::InstructorAnswer answer = ask(console, request);
  ASSERT_EQ(answer.items_size(), 1) << answer.error();
  EXPECT_TRUE(answer.items(0).replay().same()) << answer.items(0).replay().detail();
}

}  // namespace
}  // namespace cnclab::lab
