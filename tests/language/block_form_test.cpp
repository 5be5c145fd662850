// Every row of section BLK and PAR: the empty block line of each function is the manual's structure line.
#include "language/block_form.hpp"

#include <gtest/gtest.h>

#include <set>

#include "language/screen_form.hpp"
#include "tape_block.hpp"

namespace cnclab::language {
namespace {

using Kind = Function::Kind;

struct FormRow {
  std::string_view id;
  Function function;
  Plane plane;
  std::string_view line;  ///< with block number 1 and nothing filled in (SCR-012 to SCR-014, D-21)
};

constexpr FormRow kRows[] = {
    {"BLK-100 G00", {Kind::g, 0}, Plane::xy, "N001 G00 X.....,... Y.....,... Z.....,... (EILGANG)"},
    {"BLK-101 G01", {Kind::g, 1}, Plane::xy, "N001 G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-102 G02 G17", {Kind::g, 2}, Plane::xy, "N001 G02 X.....,... Y.....,... I.....,... J.....,..."},
    {"BLK-102 G02 G18", {Kind::g, 2}, Plane::xz, "N001 G02 X.....,... Z.....,... I.....,... K.....,..."},
    {"BLK-102 G02 G19", {Kind::g, 2}, Plane::yz, "N001 G02 Y.....,... Z.....,... J.....,... K.....,..."},
    {"BLK-103 G03 G17", {Kind::g, 3}, Plane::xy, "N001 G03 X.....,... Y.....,... I.....,... J.....,..."},
    {"BLK-103 G03 G18", {Kind::g, 3}, Plane::xz, "N001 G03 X.....,... Z.....,... I.....,... K.....,..."},
    {"BLK-103 G03 G19", {Kind::g, 3}, Plane::yz, "N001 G03 Y.....,... Z.....,... J.....,... K.....,..."},
    {"BLK-104 G04", {Kind::g, 4}, Plane::xy, "N001 G04 (VERWEILZEIT ZEHNTELSEK.) H...."},
    {"BLK-105 G05 G17", {Kind::g, 5}, Plane::xy, "N001 G05 X.....,... Y.....,... R.....,... F.... S.... T.. M.."},
    {"BLK-105 G05 G18", {Kind::g, 5}, Plane::xz, "N001 G05 X.....,... R.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-105 G05 G19", {Kind::g, 5}, Plane::yz, "N001 G05 R.....,... Y.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-106 G06 G17", {Kind::g, 6}, Plane::xy, "N001 G06 X.....,... Y.....,... R.....,... F.... S.... T.. M.."},
    {"BLK-106 G06 G18", {Kind::g, 6}, Plane::xz, "N001 G06 X.....,... R.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-106 G06 G19", {Kind::g, 6}, Plane::yz, "N001 G06 R.....,... Y.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-107 G07", {Kind::g, 7}, Plane::xy, "N001 G07 X.....,... Y.....,... I.....,... J.....,... Z.....,..."},
    {"BLK-108 G08", {Kind::g, 8}, Plane::xy, "N001 G08 X.....,... Y.....,... I.....,... J.....,... Z.....,..."},
    {"BLK-110 G10", {Kind::g, 10}, Plane::xy, "N001 G10 (ECKE ABRUNDEN MIT) R.....,..."},
    {"BLK-111 G11", {Kind::g, 11}, Plane::xy, "N001 G11 (ZUSATZFUNKTION) F.... S.... T.. M.."},
    {"BLK-112 G12", {Kind::g, 12}, Plane::xy, "N001 G12 (VIERTE ACHSE) U.....,..."},
    {"BLK-117 G17", {Kind::g, 17}, Plane::xy, "N001 G17 (KREISEBENE XY)"},
    {"BLK-118 G18", {Kind::g, 18}, Plane::xy, "N001 G18 (KREISEBENE XZ)"},
    {"BLK-119 G19", {Kind::g, 19}, Plane::xy, "N001 G19 (KREISEBENE YZ)"},
    {"BLK-120 G20", {Kind::g, 20}, Plane::xy, "N001 G20 (SPRUNG PROGRAMM) P.... N..."},
    {"BLK-121 G21", {Kind::g, 21}, Plane::xy, "N001 G21 (SPRUNG PROGRAMM) P.... N..."},
    {"BLK-122 G22", {Kind::g, 22}, Plane::xy, "N001 G22 (AUFRUF PROGRAMM) P.... N... W.."},
    {"BLK-123 G23", {Kind::g, 23}, Plane::xy, "N001 G23 (AUFRUF PROGRAMM) P.... N... W.."},
    {"BLK-140 G40", {Kind::g, 40}, Plane::xy, "N001 G40 (RADIUSKOMPENSATION AUS)"},
    {"BLK-141 G41", {Kind::g, 41}, Plane::xy, "N001 G41 (RADIUSKOMPENSATION LINKS)"},
    {"BLK-142 G42", {Kind::g, 42}, Plane::xy, "N001 G42 (RADIUSKOMPENSATION RECHTS)"},
    {"BLK-143 G43", {Kind::g, 43}, Plane::xy, "N001 G43 (RADIUSKOMPENSATION PLUS)"},
    {"BLK-144 G44", {Kind::g, 44}, Plane::xy, "N001 G44 (RADIUSKOMPENSATION MINUS)"},
    {"BLK-145 G45", {Kind::g, 45}, Plane::xy, "N001 G45 (LÄNGENKOMPENSATION AUS)"},
    {"BLK-146 G46", {Kind::g, 46}, Plane::xy, "N001 G46 (LÄNGENKOMPENSATION AN)"},
    {"BLK-161 G61", {Kind::g, 61}, Plane::xy, "N001 G61 X.....,... Y.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-161 G62 G17", {Kind::g, 62}, Plane::xy, "N001 G62 X.....,... Y.....,... I.....,... J.....,..."},
    {"BLK-161 G62 G18", {Kind::g, 62}, Plane::xz, "N001 G62 X.....,... Z.....,... I.....,... K.....,..."},
    {"BLK-161 G62 G19", {Kind::g, 62}, Plane::yz, "N001 G62 Y.....,... Z.....,... J.....,... K.....,..."},
    {"BLK-161 G63 G17", {Kind::g, 63}, Plane::xy, "N001 G63 X.....,... Y.....,... I.....,... J.....,..."},
    {"BLK-161 G63 G18", {Kind::g, 63}, Plane::xz, "N001 G63 X.....,... Z.....,... I.....,... K.....,..."},
    {"BLK-161 G63 G19", {Kind::g, 63}, Plane::yz, "N001 G63 Y.....,... Z.....,... J.....,... K.....,..."},
    {"BLK-161 G64", {Kind::g, 64}, Plane::xy, "N001 G64 (VERWEILZEIT ZEHNTELSEK.) H...."},
    {"BLK-161 G65 G17", {Kind::g, 65}, Plane::xy, "N001 G65 X.....,... Y.....,... R.....,... F.... S.... T.. M.."},
    {"BLK-161 G65 G18", {Kind::g, 65}, Plane::xz, "N001 G65 X.....,... R.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-161 G65 G19", {Kind::g, 65}, Plane::yz, "N001 G65 R.....,... Y.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-161 G66 G17", {Kind::g, 66}, Plane::xy, "N001 G66 X.....,... Y.....,... R.....,... F.... S.... T.. M.."},
    {"BLK-161 G66 G18", {Kind::g, 66}, Plane::xz, "N001 G66 X.....,... R.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-161 G66 G19", {Kind::g, 66}, Plane::yz, "N001 G66 R.....,... Y.....,... Z.....,... F.... S.... T.. M.."},
    {"BLK-168 G68", {Kind::g, 68}, Plane::xy, "N001 G68 X.....,... Y.....,... Z.....,... (ISTWERT SETZEN)"},
    {"BLK-169 G69", {Kind::g, 69}, Plane::xy, "N001 G69 X.....,... Y.....,... Z.....,... (REFERENZPUNKT FAHREN)"},
    {"BLK-174 G74", {Kind::g, 74}, Plane::xy, "N001 G74 (SKALENFAKTOR AUS)"},
    {"BLK-175 G75", {Kind::g, 75}, Plane::xy, "N001 G75 X.....,... Y.....,... Z.....,... F.... (SKALENFAKTOR)"},
    {"BLK-181 G81", {Kind::g, 81}, Plane::xy, "N001 G81 X.....,... Y.....,... Z.....,... Q.....,... V... H...."},
    {"BLK-181 G82", {Kind::g, 82}, Plane::xy, "N001 G82 X.....,... Y.....,... Z.....,... Q.....,... V... H...."},
    {"BLK-181 G83", {Kind::g, 83}, Plane::xy, "N001 G83 X.....,... Y.....,... Z.....,... Q.....,... V... H...."},
    {"BLK-181 G84", {Kind::g, 84}, Plane::xy, "N001 G84 X.....,... Y.....,... Z.....,... Q.....,... V... H...."},
    {"BLK-181 G85", {Kind::g, 85}, Plane::xy, "N001 G85 X.....,... Y.....,... Z.....,... Q.....,... V... H...."},
    {"DEC-03 G86", {Kind::g, 86}, Plane::xy, "N001 G86 R.....,... D... W.. Z.....,... Q.....,... V... H...."},
    {"BLK-190 G90", {Kind::g, 90}, Plane::xy, "N001 G90 (ABSOLUTMASS)"},
    {"BLK-191 G91", {Kind::g, 91}, Plane::xy, "N001 G91 (KETTENMASS)"},
    {"PAR-010 ↓00", {Kind::parametric, 0}, Plane::xy, "N001 ↓00          #.. = .....,..."},
    {"PAR-011 ↓01", {Kind::parametric, 1}, Plane::xy, "N001 ↓01          #.. = #.. + #.."},
    {"PAR-012 ↓02", {Kind::parametric, 2}, Plane::xy, "N001 ↓02          #.. = #.. - #.."},
    {"PAR-013 ↓03", {Kind::parametric, 3}, Plane::xy, "N001 ↓03          #.. = #.. * #.."},
    {"PAR-014 ↓04", {Kind::parametric, 4}, Plane::xy, "N001 ↓04          #.. = #.. / #.."},
    {"PAR-015 ↓10", {Kind::parametric, 10}, Plane::xy, "N001 ↓10          #.. = COPY #.."},
    {"PAR-016 ↓11", {Kind::parametric, 11}, Plane::xy, "N001 ↓11          #.. = INC #.."},
    {"PAR-017 ↓12", {Kind::parametric, 12}, Plane::xy, "N001 ↓12          #.. = DEC #.."},
    {"PAR-018 ↓13", {Kind::parametric, 13}, Plane::xy, "N001 ↓13          #.. = CPL #.."},
    {"PAR-019 ↓14", {Kind::parametric, 14}, Plane::xy, "N001 ↓14          #.. = ABS #.."},
    {"PAR-020 ↓15", {Kind::parametric, 15}, Plane::xy, "N001 ↓15          #.. = SQRT #.."},
    {"PAR-021 ↓16", {Kind::parametric, 16}, Plane::xy, "N001 ↓16          #.. = SIN #.."},
    {"PAR-022 ↓17", {Kind::parametric, 17}, Plane::xy, "N001 ↓17          #.. = COS #.."},
    {"PAR-023 ↓50", {Kind::parametric, 50}, Plane::xy, "N001 ↓50 (JUMP ZER TO) N..."},
    {"PAR-024 ↓51", {Kind::parametric, 51}, Plane::xy, "N001 ↓51 (JUMP POS TO) N..."},
    {"PAR-025 ↓52", {Kind::parametric, 52}, Plane::xy, "N001 ↓52 (JUMP NEG TO) N..."},
    {"PAR-026 ↓53", {Kind::parametric, 53}, Plane::xy, "N001 ↓53 (JUMP TO) N..."},
    {"PAR-027 ↓54", {Kind::parametric, 54}, Plane::xy, "N001 ↓54 (JUMP C TO) N..."},
    {"D-50 tool row", {Kind::tool, 0}, Plane::xy, "T001 R.....,... L.....,..."},
};

TEST(BlockForm, EveryFunctionHasTheManualsStructureLine_BLK_100_to_195) {
  for (const FormRow& row : kRows) {
    SCOPED_TRACE(row.id);
    ASSERT_NE(find_form(row.function, row.plane, {}), nullptr);
    EXPECT_EQ(block_line({.number = 1, .function = row.function}, row.plane, Tongue::german), row.line);
  }
}

TEST(BlockForm, TableHoldsTheseFunctionsAndNoOthers_BLK_201_PAR_033) {
  EXPECT_EQ(all_forms().size(), std::size(kRows));
  std::set<int> g_codes, parametric_codes;
  for (const FormRow& row : kRows) {
    if (row.function.kind == Kind::g) g_codes.insert(row.function.code);
    if (row.function.kind == Kind::parametric) parametric_codes.insert(row.function.code);
  }
  for (int code = 0; code < 256; ++code) {
    SCOPED_TRACE(code);
    const auto byte = static_cast<std::uint8_t>(code);
    EXPECT_EQ(find_form({Kind::g, byte}, Plane::xy, {}) != nullptr, g_codes.contains(code));
    EXPECT_EQ(find_form({Kind::parametric, byte}, Plane::xy, {}) != nullptr, parametric_codes.contains(code));
  }
}

TEST(BlockForm, ReducedModelHasItsTwelveFunctionsOnly_MODEL_001_002_006) {
  const std::set<int> expected{0, 1, 4, 11, 12, 20, 22, 68, 69, 74, 75, 91};
  const Vocabulary reduced{.model = Model::cnc3250};
  for (int code = 0; code < 100; ++code) {
    SCOPED_TRACE(code);
    const auto byte = static_cast<std::uint8_t>(code);
    EXPECT_EQ(find_form({Kind::g, byte}, Plane::xy, reduced) != nullptr, expected.contains(code));
    EXPECT_EQ(find_form({Kind::parametric, byte}, Plane::xy, reduced), nullptr);
  }
}

TEST(BlockForm, PlannedFunctionsCanBeSwitchedOff_BLK_200_DEC_03) {
  const std::set<int> planned{5, 6, 10, 61, 62, 63, 64, 65, 66, 81, 82, 83, 84, 85, 86};
  const Vocabulary without{.planned_functions = false};
  for (const FormRow& row : kRows) {
    SCOPED_TRACE(row.id);
    const bool is_planned = (row.function.kind == Kind::g && planned.contains(row.function.code)) ||
                            row.function == Function{Kind::parametric, 15};
    EXPECT_EQ(find_form(row.function, row.plane, without) == nullptr, is_planned);
  }
}

TEST(BlockForm, OnlyArcsDependOnThePlane_D_54) {
  const std::set<int> arcs{2, 3, 5, 6, 62, 63, 65, 66};
  for (const FormRow& row : kRows) {
    SCOPED_TRACE(row.id);
    EXPECT_EQ(is_plane_dependent(row.function), row.function.kind == Kind::g && arcs.contains(row.function.code));
  }
}

TEST(BlockForm, WordsTellThePlaneWhereTheyFitOneOnly_D_54) {
  struct Row {
    std::string_view text;
    Plane fallback, expected;
  };
  constexpr Row kPlaneRows[] = {
      {"N001G02X+1Y+1I+1J+1", Plane::yz, Plane::xy}, {"N001G02X+1Z+1I+1K+1", Plane::xy, Plane::xz},
      {"N001G03Y+1Z+1J+1K+1", Plane::xy, Plane::yz}, {"N001G05X+1R+1Z+1", Plane::xy, Plane::xz},
      {"N001G02X+1", Plane::xz, Plane::xz},          {"N001G02X+1", Plane::yz, Plane::xy},
      {"N001G01X+1Y+1Z+1", Plane::yz, Plane::yz},
  };
  for (const Row& row : kPlaneRows)
    EXPECT_EQ(plane_of_words(tape_block(row.text), row.fallback), row.expected) << row.text;
}

TEST(BlockForm, KnownMFunctions_M_000_to_M_098) {
  std::set<int> known{0, 1, 2, 3, 4, 5, 8, 9, 12, 13, 14, 15, 16, 20, 21, 22, 23, 24};
  for (const int group : {40, 50, 60, 70, 80, 90})
    for (int line = 0; line <= 8; ++line) known.insert(group + line);
  for (int code = -1; code <= 100; ++code) EXPECT_EQ(is_known_m(code), known.contains(code)) << code;
}

TEST(BlockForm, EnglishTextsStandInTheSamePlaceAndFitTheMonitor_SCR_008_051) {
  for (const BlockForm& form : all_forms()) {
    const Block block{.number = 999, .function = form.function};
    const std::string line = block_line(block, form.plane, Tongue::english);
    SCOPED_TRACE(line);
    EXPECT_LE(columns_of(line), 64);
    EXPECT_EQ(form.english.empty(), form.german.empty());
    const bool has_text = line.find('(' + std::string(form.english) + ')') != std::string::npos;
    EXPECT_EQ(has_text, form.text_place != TextPlace::none);
  }
}

}  // namespace
}  // namespace cnclab::language
