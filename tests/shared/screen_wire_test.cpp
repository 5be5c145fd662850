// Screen differences on the wire: round trips, and what a hostile server may send (SEC-006).
#include "shared/screen_wire.hpp"

#include <cnclab/v1/screen.pb.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

namespace cnclab {
namespace {

v1::Span* add_row(v1::ScreenUpdate& update, std::uint32_t index, const std::string& text, std::uint32_t attribute = 0) {
  v1::Row* const row = update.add_rows();
  row->set_index(index);
  v1::Span* const span = row->add_spans();
  span->set_text(text);
  span->set_attribute(attribute);
  return span;
}

TEST(ScreenWire, OnlyChangedRowsTravel) {
  Screen old_screen, new_screen;
  new_screen.write(4, 10, "AUTOMAT", Attribute::inverse);
  v1::ScreenUpdate update;
  write_rows(old_screen, new_screen, update);
  ASSERT_EQ(update.rows_size(), 1);
  EXPECT_EQ(update.rows(0).index(), 4U);
  ASSERT_EQ(update.rows(0).spans_size(), 3) << "blanks, the inverse word, blanks";
  EXPECT_EQ(update.rows(0).spans(1).text(), "AUTOMAT");
  write_rows(new_screen, new_screen, update);
  EXPECT_EQ(update.rows_size(), 0);
}

TEST(ScreenWire, APartOfARowBringsOnlyTheCellsThatDiffer) {
  Screen old_screen, new_screen;
  old_screen.write(3, 51, "X  +0085.000");
  new_screen.write(3, 51, "X  +0085.120");
  v1::ScreenUpdate update;
  write_rows(old_screen, new_screen, update, RowForm::changed_part);
  ASSERT_EQ(update.rows_size(), 1);
  EXPECT_EQ(update.rows(0).first_column(), 60U);
  ASSERT_EQ(update.rows(0).spans_size(), 1);
  EXPECT_EQ(update.rows(0).spans(0).text(), "12");
  EXPECT_EQ(apply_rows(old_screen, update), new_screen);
}

TEST(ScreenWire, RefusesWhatDoesNotFitAndNamesIt) {
  struct Case {
    const char* name;
    std::function<void(v1::ScreenUpdate&)> build;
    const char* named;
  };
  const Case cases[] = {
      {"row 99", [](auto& u) { add_row(u, 99, std::string(80, ' ')); }, "row 99"},
      {"row 24", [](auto& u) { add_row(u, 24, std::string(80, ' ')); }, "row 24"},
      {"81 columns", [](auto& u) { add_row(u, 0, std::string(81, 'x')); }, "longer than 80"},
      {"79 columns", [](auto& u) { add_row(u, 0, std::string(79, 'x')); }, "79 columns"},
      {"two spans of 81 in all",
       [](auto& u) {
         add_row(u, 3, std::string(80, 'x'));
         u.mutable_rows(0)->add_spans()->set_text("y");
       },
       "row 3"},
      {"no spans", [](auto& u) { u.add_rows()->set_index(2); }, "0 columns"},
      {"attribute 4", [](auto& u) { add_row(u, 0, std::string(80, 'x'), 4); }, "attribute 4"},
      {"attribute 2^32-1", [](auto& u) { add_row(u, 0, std::string(80, 'x'), 0xFFFFFFFFU); }, "attribute"},
      {"80 bytes, 40 characters",
       [](auto& u) {
         std::string text;
         for (int i = 0; i < 40; ++i) text += "ä";
         add_row(u, 0, text);
       },
       "40 columns"},
      {"a part without cells",
       [](auto& u) {
         u.add_rows()->set_index(7);
         u.mutable_rows(0)->set_first_column(80);
       },
       "row 7"},
      {"a part behind the end",
       [](auto& u) {
         add_row(u, 8, "x");
         u.mutable_rows(0)->set_first_column(80);
       },
       "row 8"},
      {"a part that begins nowhere",
       [](auto& u) {
         add_row(u, 9, "x");
         u.mutable_rows(0)->set_first_column(0xFFFFFFFFU);
       },
       "row 9"},
  };
  Screen base;
  base.write(0, 0, "stays");
  for (const Case& c : cases) {
    v1::ScreenUpdate update;
    c.build(update);
    const auto applied = apply_rows(base, update);
    ASSERT_FALSE(applied) << c.name;
    EXPECT_NE(applied.error().find(c.named), std::string::npos) << c.name << ": " << applied.error();
  }
}

TEST(ScreenWire, ControlCharactersNeverReachATerminal) {
  v1::ScreenUpdate update;
  add_row(update, 0, "\x1B[2J\n\x7F\xC2\x9B" + std::string(73, 'x'));
  const auto applied = apply_rows(Screen(), update);
  ASSERT_TRUE(applied) << applied.error();
  for (const int column : {0, 4, 5, 6}) EXPECT_EQ(applied->at(0, column).code, U'\uFFFD') << column;
  EXPECT_EQ(applied->at(0, 1).code, U'[');
}

rc::Gen<Screen> any_screen() {
  const auto cell = rc::gen::build<Cell>(
      rc::gen::set(&Cell::code, rc::gen::element(U' ', U'A', U'7', U'ä', U'□', U'→', U'│', U'⠿', U'\U0001D400')),
      rc::gen::set(&Cell::attribute,
                   rc::gen::element(Attribute::normal, Attribute::inverse, Attribute::bold, Attribute::dim)));
  const auto placed = rc::gen::tuple(rc::gen::inRange(0, 24), rc::gen::inRange(0, 80), cell);
  return rc::gen::map(rc::gen::container<std::vector<std::tuple<int, int, Cell>>>(placed), [](const auto& cells) {
    Screen screen;
    for (const auto& [row, column, content] : cells) screen.put(row, column, content);
    return screen;
  });
}

RC_GTEST_PROP(ScreenWire, ADifferenceAppliedGivesTheNewerScreen, ()) {
  const Screen older = *any_screen();
  const Screen newer = *any_screen();
  v1::ScreenUpdate sent;
  write_rows(older, newer, sent, *rc::gen::element(RowForm::whole, RowForm::changed_part));
  v1::ScreenUpdate received;
  RC_ASSERT(received.ParseFromString(sent.SerializeAsString()));
  const auto applied = apply_rows(older, received);
  RC_ASSERT(applied.has_value());
  RC_ASSERT(*applied == newer);
}

RC_GTEST_PROP(ScreenWire, ArbitraryBytesAreRefusedOrGiveAScreen, (const std::string& bytes)) {
  v1::ScreenUpdate update;
  if (!update.ParseFromString(bytes)) return;
  const auto applied = apply_rows(Screen(), update);
  if (applied) {
    for (int row = 0; row < Screen::kRows; ++row) RC_ASSERT(from_utf8(applied->text(row)).size() == 80U);
  } else {
    RC_ASSERT(!applied.error().empty());
  }
}

}  // namespace
}  // namespace cnclab
