// EDIT-033: every block that the control has can be keyed in word by word, is stored as keyed in and listed as BLK
// says.
#include <gtest/gtest.h>

#include "bench.hpp"
#include "language/screen_form.hpp"

namespace cnclab::panel {
namespace {

using language::Address;
using language::Function;

/// A value that every check lets pass, as it is typed.
std::string value_for(Address address) {
  switch (address) {
    case Address::X:
    case Address::Y:
    case Address::I:
    case Address::J:
      return "12.5";
    case Address::Q:  // cycles work downwards
    case Address::Z:
      return "-3.25";
    case Address::M:
      return "05";
    case Address::operand:
      return "07";
    case Address::T:
    case Address::W:
    case Address::N:
    case Address::P:
    case Address::V:
      return "2";
    case Address::D:
    case Address::F:
    case Address::S:
    case Address::H:
      return "90";
    case Address::K:
    case Address::L:
    case Address::R:
    case Address::U:
    case Address::value:
      return "3.25";
  }
  return "";
}

std::int32_t stored_value(Address address) {
  const std::string typed = value_for(address);
  const bool in_mm = language::format_of(address).kind == language::WordFormat::Kind::millimetres;
  return static_cast<std::int32_t>(std::stod(typed) * (in_mm ? 1000 : 1));
}

std::string two_digits(int code) { return (code < 10 ? "0" : "") + std::to_string(code); }

/// The program's first block chooses the plane that the form belongs to.
std::string tape_with_plane(language::Plane plane) {
  return "P0001N001G" + std::to_string(17 + static_cast<int>(plane)) + "%";
}

TEST(BlockForms, EDIT_030_033_EveryFormIsKeyedInStoredAndListed) {
  int forms = 0;
  for (const language::BlockForm& form : language::all_forms()) {
    if (form.function.kind == Function::Kind::tool) continue;
    SCOPED_TRACE(std::string(form.german) + " " + std::to_string(form.function.code) + " plane " +
                 std::to_string(static_cast<int>(form.plane)));
    const bool is_parametric = form.function.kind == Function::Kind::parametric;
    Bench bench({.tape = tape_with_plane(form.plane)});
    bench.keys("EINGABE ENTER ENTER");
    if (is_parametric) bench.keys("DOWN");
    bench.type(two_digits(form.function.code));
    bench.keys("ENTER");
    language::Block expected{.number = 2, .function = form.function};
    const bool is_slot = form.function.code == 84 && !is_parametric;  // exactly one of X and Y is not 0 (DEC-53)
    for (const Address address : form.words) {
      const bool is_zero = is_slot && address == Address::Y;
      bench.type(is_zero ? "0" : value_for(address));
      bench.keys("ENTER");
      expected.words.push_back({address, false, is_zero ? 0 : stored_value(address)});
    }
    bench.keys("EINGABE");
    const language::Program* program = bench.control.memory().find(1);
    ASSERT_EQ(program->blocks.size(), 2U) << bench.picture();
    EXPECT_EQ(program->blocks.back(), expected);
    EXPECT_EQ(bench.monitor(4), language::block_line(expected, form.plane, language::Tongue::german));
    ++forms;
  }
  EXPECT_GT(forms, 60);
}

TEST(BlockForms, MODEL_001_002_TheReducedModelHasItsTwelveFunctionsAlone) {
  std::string known;
  for (int code = 0; code < 100; ++code) {
    Bench::Setup setup;
    setup.settings.vocabulary.model = language::Model::cnc3250;
    Bench bench(setup);
    bench.keys("EINGABE ENTER ENTER");
    bench.type(two_digits(code));
    bench.keys("ENTER");
    if (bench.monitor(15).empty())
      known += two_digits(code) + " ";
    else
      EXPECT_EQ(bench.monitor(15), "Funktion nicht vorgesehen");
  }
  EXPECT_EQ(known, "00 01 04 11 12 20 22 68 69 74 75 91 ");
}

TEST(BlockForms, BLK_201_D_02_FunctionsOfTheFullModel) {
  const auto known_with = [](bool planned) {
    std::string known;
    for (int code = 0; code < 100; ++code) {
      Bench::Setup setup;
      setup.settings.vocabulary.planned_functions = planned;
      Bench bench(setup);
      bench.keys("EINGABE ENTER ENTER");
      bench.type(two_digits(code));
      bench.keys("ENTER");
      if (bench.monitor(15).empty()) known += two_digits(code) + " ";
    }
    return known;
  };
  EXPECT_EQ(known_with(true),
            "00 01 02 03 04 05 06 07 08 10 11 12 17 18 19 20 21 22 23 40 41 42 43 44 45 46 61 62 63 64 65 66 68 69 74 "
            "75 81 82 83 84 85 86 90 91 ");
  EXPECT_EQ(known_with(false),
            "00 01 02 03 04 07 08 11 12 17 18 19 20 21 22 23 40 41 42 43 44 45 46 68 69 74 75 90 91 ");
}

TEST(Overview, D_32_EightPerLineInStorageOrderPagingWithDown) {
  std::string tape;
  for (int number = 200; number > 100; --number) tape += "P0" + std::to_string(number) + "N001G90";
  Bench bench({.tape = tape + "%"});
  bench.keys("EINGABE CLEAR DOWN");
  EXPECT_EQ(bench.monitor(3), "P0200   P0199   P0198   P0197   P0196   P0195   P0194   P0193");
  EXPECT_EQ(bench.monitor(12), "P0128   P0127   P0126   P0125   P0124   P0123   P0122   P0121");
  bench.keys("DOWN");
  EXPECT_EQ(bench.monitor(3), "P0120   P0119   P0118   P0117   P0116   P0115   P0114   P0113");
  EXPECT_EQ(bench.monitor(6), "");
  bench.keys("DOWN");
  EXPECT_EQ(bench.monitor(3).substr(0, 5), "P0200") << "and round again";
}

}  // namespace
}  // namespace cnclab::panel
