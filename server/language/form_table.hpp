// The rows behind block_form.hpp: word formats (BLK-002 to BLK-016) and block forms (BLK-100 to BLK-195, PAR, CYC).
// Private to this folder.
#pragma once

#include "language/block_form.hpp"

namespace cnclab::language {

/// Unsigned words have the digits they are shown with; mm words ±4 digits and 3 decimals (BLK-005).
inline constexpr WordFormat millimetre_format(Address address, bool takes_parameter = true) {
  return {address, WordFormat::Kind::millimetres, 7, -kLargestWord_um, kLargestWord_um, takes_parameter, 4};
}

inline constexpr WordFormat digit_format(Address address, int digits, std::int64_t least, std::int64_t most,
                                         int cost_bytes, bool takes_parameter = true) {
  return {address, WordFormat::Kind::digits, digits, least, most, takes_parameter, cost_bytes};
}

inline constexpr WordFormat kFormats[] = {
    millimetre_format(Address::X),
    millimetre_format(Address::Y),
    millimetre_format(Address::Z),
    millimetre_format(Address::I),
    millimetre_format(Address::J),
    millimetre_format(Address::K),
    millimetre_format(Address::U),
    millimetre_format(Address::R),
    millimetre_format(Address::L),
    millimetre_format(Address::Q),
    millimetre_format(Address::value, false),
    digit_format(Address::F, 4, 1, 9999, 2),             // BLK-009; F0000 refused (D-46)
    digit_format(Address::S, 4, 1, 9999, 2),             // BLK-010; S0000 refused (D-46)
    digit_format(Address::H, 4, 0, 9999, 2),             // BLK-013; H0000 only in cycles (DEC-53)
    digit_format(Address::P, 4, 0, 9999, 2),             // BLK-007
    digit_format(Address::N, 3, 1, 999, 2),              // BLK-006
    digit_format(Address::V, 3, 1, 999, 2),              // BLK-015, D-88: whole mm, positive
    digit_format(Address::D, 3, 0, 359, 2),              // DEC-03, DEC-54
    digit_format(Address::W, 2, 0, 99, 1),               // BLK-014
    digit_format(Address::T, 2, 1, 99, 1, false),        // BLK-011, PAR-003
    digit_format(Address::M, 2, 0, 99, 1, false),        // BLK-012, PAR-003
    digit_format(Address::operand, 2, 0, 69, 1, false),  // BLK-016; the number is the parameter's
};

namespace words {
using enum Address;
inline constexpr Address kAxes[] = {X, Y, Z};
inline constexpr Address kLine[] = {X, Y, Z, F, S, T, M};
inline constexpr Address kArcXy[] = {X, Y, I, J};
inline constexpr Address kArcXz[] = {X, Z, I, K};
inline constexpr Address kArcYz[] = {Y, Z, J, K};
inline constexpr Address kRadiusXy[] = {X, Y, R, F, S, T, M};
inline constexpr Address kRadiusXz[] = {X, R, Z, F, S, T, M};
inline constexpr Address kRadiusYz[] = {R, Y, Z, F, S, T, M};
inline constexpr Address kHelix[] = {X, Y, I, J, Z};
inline constexpr Address kDwell[] = {H};
inline constexpr Address kRounding[] = {R};
inline constexpr Address kAuxiliary[] = {F, S, T, M};
inline constexpr Address kFourthAxis[] = {U};
inline constexpr Address kJump[] = {P, N};
inline constexpr Address kCall[] = {P, N, W};
inline constexpr Address kScale[] = {X, Y, Z, F};
inline constexpr Address kCycle[] = {X, Y, Z, Q, V, H};
inline constexpr Address kHoleCircle[] = {R, D, W, Z, Q, V, H};
inline constexpr Address kDrillNeeds[] = {Z, V, H};
inline constexpr Address kDeepDrillNeeds[] = {Z, Q, V, H};
inline constexpr Address kMillNeeds[] = {X, Y, Z, Q, V};  // H is ignored (D-84, D-85)
inline constexpr Address kHoleCircleNeeds[] = {R, D, W, Z, V, H};
inline constexpr Address kAssign[] = {operand, value};
inline constexpr Address kTwoOperands[] = {operand, operand};
inline constexpr Address kThreeOperands[] = {operand, operand, operand};
inline constexpr Address kJumpHere[] = {N};
inline constexpr Address kTool[] = {R, L};
}  // namespace words

/// The columns of a row that most functions share.
struct FormTraits {
  TextPlace text_place = TextPlace::none;
  Needed needed = Needed::nothing;
  bool is_planned = false;
  bool on_3250 = false;
};

using FormWords = std::span<const Address>;

inline constexpr BlockForm g_form(std::uint8_t code, FormWords words, std::string_view german, std::string_view english,
                                  FormTraits traits) {
  return {{Function::Kind::g, code}, words,         german, english, traits.text_place, traits.needed, {},
          traits.is_planned,         traits.on_3250};
}

inline constexpr BlockForm plane_form(std::uint8_t code, Plane plane, FormWords words, Needed needed, bool is_planned) {
  BlockForm form = g_form(code, words, "", "", {.needed = needed, .is_planned = is_planned});
  form.is_for_one_plane = true;
  form.plane = plane;
  return form;
}

inline constexpr BlockForm cycle_form(std::uint8_t code, FormWords words, FormWords required) {
  BlockForm form = g_form(code, words, "", "", {.needed = Needed::cycle, .is_planned = true});
  form.required_words = required;
  return form;
}

/// Calculations show their operator between the operands, jumps a text; neither differs between the languages.
inline constexpr BlockForm parametric_form(std::uint8_t code, FormWords words, std::string_view text,
                                           TextPlace place = TextPlace::none, bool is_planned = false) {
  return {{Function::Kind::parametric, code}, words, text, text, place, Needed::all, {}, is_planned, false};
}

inline constexpr TextPlace kBefore = TextPlace::before_words;
inline constexpr TextPlace kAfter = TextPlace::after_words;
inline constexpr bool kPlanned = true;
inline constexpr FormTraits kSwitch{.text_place = kAfter};

inline constexpr BlockForm kForms[] = {
    g_form(0, words::kAxes, "EILGANG", "RAPID", {.text_place = kAfter, .needed = Needed::any_axis, .on_3250 = true}),
    g_form(1, words::kLine, "", "", {.needed = Needed::any_word, .on_3250 = true}),
    plane_form(2, Plane::xy, words::kArcXy, Needed::all, false),
    plane_form(2, Plane::xz, words::kArcXz, Needed::all, false),
    plane_form(2, Plane::yz, words::kArcYz, Needed::all, false),
    plane_form(3, Plane::xy, words::kArcXy, Needed::all, false),
    plane_form(3, Plane::xz, words::kArcXz, Needed::all, false),
    plane_form(3, Plane::yz, words::kArcYz, Needed::all, false),
    g_form(4, words::kDwell, "VERWEILZEIT ZEHNTELSEK.", "DWELL 1/10 SEC",
           {.text_place = kBefore, .needed = Needed::all, .on_3250 = true}),
    plane_form(5, Plane::xy, words::kRadiusXy, Needed::two_axes_and_radius, kPlanned),
    plane_form(5, Plane::xz, words::kRadiusXz, Needed::two_axes_and_radius, kPlanned),
    plane_form(5, Plane::yz, words::kRadiusYz, Needed::two_axes_and_radius, kPlanned),
    plane_form(6, Plane::xy, words::kRadiusXy, Needed::two_axes_and_radius, kPlanned),
    plane_form(6, Plane::xz, words::kRadiusXz, Needed::two_axes_and_radius, kPlanned),
    plane_form(6, Plane::yz, words::kRadiusYz, Needed::two_axes_and_radius, kPlanned),
    g_form(7, words::kHelix, "", "", {.needed = Needed::all}),
    g_form(8, words::kHelix, "", "", {.needed = Needed::all}),
    g_form(10, words::kRounding, "ECKE ABRUNDEN MIT", "ROUND CORNER WITH",
           {.text_place = kBefore, .needed = Needed::all, .is_planned = true}),
    g_form(11, words::kAuxiliary, "ZUSATZFUNKTION", "AUXILIARY FUNCTION",
           {.text_place = kBefore, .needed = Needed::any_word, .on_3250 = true}),
    g_form(12, words::kFourthAxis, "VIERTE ACHSE", "FOURTH AXIS",
           {.text_place = kBefore, .needed = Needed::all, .on_3250 = true}),
    g_form(17, {}, "KREISEBENE XY", "PLANE XY", kSwitch),
    g_form(18, {}, "KREISEBENE XZ", "PLANE XZ", kSwitch),
    g_form(19, {}, "KREISEBENE YZ", "PLANE YZ", kSwitch),
    g_form(20, words::kJump, "SPRUNG PROGRAMM", "JUMP TO PROGRAM",
           {.text_place = kBefore, .needed = Needed::all, .on_3250 = true}),
    g_form(21, words::kJump, "SPRUNG PROGRAMM", "JUMP TO PROGRAM", {.text_place = kBefore, .needed = Needed::all}),
    g_form(22, words::kCall, "AUFRUF PROGRAMM", "CALL PROGRAM",
           {.text_place = kBefore, .needed = Needed::all, .on_3250 = true}),
    g_form(23, words::kCall, "AUFRUF PROGRAMM", "CALL PROGRAM", {.text_place = kBefore, .needed = Needed::all}),
    g_form(40, {}, "RADIUSKOMPENSATION AUS", "RADIUS COMPENSATION OFF", kSwitch),
    g_form(41, {}, "RADIUSKOMPENSATION LINKS", "RADIUS COMPENSATION LEFT", kSwitch),
    g_form(42, {}, "RADIUSKOMPENSATION RECHTS", "RADIUS COMPENSATION RIGHT", kSwitch),
    g_form(43, {}, "RADIUSKOMPENSATION PLUS", "RADIUS COMPENSATION PLUS", kSwitch),
    g_form(44, {}, "RADIUSKOMPENSATION MINUS", "RADIUS COMPENSATION MINUS", kSwitch),
    g_form(45, {}, "LÄNGENKOMPENSATION AUS", "LENGTH COMPENSATION OFF", kSwitch),
    g_form(46, {}, "LÄNGENKOMPENSATION AN", "LENGTH COMPENSATION ON", kSwitch),
    g_form(61, words::kLine, "", "", {.needed = Needed::any_word, .is_planned = true}),
    plane_form(62, Plane::xy, words::kArcXy, Needed::all, kPlanned),
    plane_form(62, Plane::xz, words::kArcXz, Needed::all, kPlanned),
    plane_form(62, Plane::yz, words::kArcYz, Needed::all, kPlanned),
    plane_form(63, Plane::xy, words::kArcXy, Needed::all, kPlanned),
    plane_form(63, Plane::xz, words::kArcXz, Needed::all, kPlanned),
    plane_form(63, Plane::yz, words::kArcYz, Needed::all, kPlanned),
    g_form(64, words::kDwell, "VERWEILZEIT ZEHNTELSEK.", "DWELL 1/10 SEC",
           {.text_place = kBefore, .needed = Needed::all, .is_planned = true}),
    plane_form(65, Plane::xy, words::kRadiusXy, Needed::two_axes_and_radius, kPlanned),
    plane_form(65, Plane::xz, words::kRadiusXz, Needed::two_axes_and_radius, kPlanned),
    plane_form(65, Plane::yz, words::kRadiusYz, Needed::two_axes_and_radius, kPlanned),
    plane_form(66, Plane::xy, words::kRadiusXy, Needed::two_axes_and_radius, kPlanned),
    plane_form(66, Plane::xz, words::kRadiusXz, Needed::two_axes_and_radius, kPlanned),
    plane_form(66, Plane::yz, words::kRadiusYz, Needed::two_axes_and_radius, kPlanned),
    g_form(68, words::kAxes, "ISTWERT SETZEN", "SET POSITION",
           {.text_place = kAfter, .needed = Needed::any_axis, .on_3250 = true}),
    g_form(69, words::kAxes, "REFERENZPUNKT FAHREN", "GO TO REFERENCE",
           {.text_place = kAfter, .needed = Needed::any_axis, .on_3250 = true}),
    g_form(74, {}, "SKALENFAKTOR AUS", "SCALE FACTOR OFF", {.text_place = kAfter, .on_3250 = true}),
    g_form(75, words::kScale, "SKALENFAKTOR", "SCALE FACTOR",
           {.text_place = kAfter, .needed = Needed::any_axis, .on_3250 = true}),
    cycle_form(81, words::kCycle, words::kDrillNeeds),
    cycle_form(82, words::kCycle, words::kDeepDrillNeeds),
    cycle_form(83, words::kCycle, words::kDrillNeeds),
    cycle_form(84, words::kCycle, words::kMillNeeds),
    cycle_form(85, words::kCycle, words::kMillNeeds),
    cycle_form(86, words::kHoleCircle, words::kHoleCircleNeeds),
    g_form(90, {}, "ABSOLUTMASS", "ABSOLUTE", kSwitch),
    g_form(91, {}, "KETTENMASS", "INCREMENTAL", {.text_place = kAfter, .on_3250 = true}),
    parametric_form(0, words::kAssign, ""),
    parametric_form(1, words::kThreeOperands, "+"),
    parametric_form(2, words::kThreeOperands, "-"),
    parametric_form(3, words::kThreeOperands, "*"),
    parametric_form(4, words::kThreeOperands, "/"),
    parametric_form(10, words::kTwoOperands, "COPY"),
    parametric_form(11, words::kTwoOperands, "INC"),
    parametric_form(12, words::kTwoOperands, "DEC"),
    parametric_form(13, words::kTwoOperands, "CPL"),
    parametric_form(14, words::kTwoOperands, "ABS"),
    parametric_form(15, words::kTwoOperands, "SQRT", TextPlace::none, kPlanned),
    parametric_form(16, words::kTwoOperands, "SIN"),
    parametric_form(17, words::kTwoOperands, "COS"),
    parametric_form(50, words::kJumpHere, "JUMP ZER TO", kBefore),
    parametric_form(51, words::kJumpHere, "JUMP POS TO", kBefore),
    parametric_form(52, words::kJumpHere, "JUMP NEG TO", kBefore),
    parametric_form(53, words::kJumpHere, "JUMP TO", kBefore),
    parametric_form(54, words::kJumpHere, "JUMP C TO", kBefore),
    // P0000 exists on both models; on the 3250 it is without effect (MODEL-009).
    {{Function::Kind::tool, 0}, words::kTool, "", "", TextPlace::none, Needed::any_word, {}, false, true},
};

}  // namespace cnclab::language
