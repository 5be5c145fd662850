// How exactly a contour is known: all tolerances of length, each with its reason. Nothing else decides what is equal.
#pragma once

namespace cnclab::geometry {

/// Ends that agree within this are the same point, mm: a nanometre. Arithmetic loses less, at any travel.
inline constexpr double kSamePoint_mm = 1e-6;

/// How far the two radii of an arc may differ, mm (D-55): coordinates are printed rounded to 1/1000 or 1/100, so that
/// arcs and the lines that touch them fit no better than this. The contour is known no better either: between the
/// elements of rounded coordinates a bend that opens no more than this is none.
inline constexpr double kArcTolerance_mm = 0.020;

/// What rounding to the increment of 0.001 leaves unknown of a contour, mm: the start and the centre of an arc are each
/// off by half of one in both axes, so its radius by up to 1.414 µm. What stays below this is no cut and no missing
/// room. It is less than the smallest step of any machine, and holds the steps in which spirals are taken too.
inline constexpr double kRounded_mm = 0.0015;

/// A joint beside a spiral need be no more exact, mm: a share of `kRounded_mm` that leaves room for all else.
inline constexpr double kExactJoint_mm = kRounded_mm / 6;

}  // namespace cnclab::geometry
