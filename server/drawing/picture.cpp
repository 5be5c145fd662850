// How each style looks.
#include "drawing/picture.hpp"

#include <array>

namespace cnclab::drawing {

namespace {

constexpr std::uint32_t kInk = 0x222222, kPaper = 0xFFFFFF, kEdge = 0xA89C80;

constexpr std::array<Look, kStyles> kLooks{
    {{.name = "title", .fill = kInk, .font_px = 24, .is_bold = true},
     {.name = "label", .fill = kInk, .font_px = 14},
     {.name = "mark", .fill = kInk, .font_px = 15, .is_bold = true},
     {.name = "script", .fill = kInk, .font_px = 10, .is_monospaced = true},
     {.name = "inverse", .fill = kPaper, .font_px = 10, .is_monospaced = true},
     {.name = "frame", .stroke = kInk, .width_px = 1},
     {.name = "tick", .stroke = 0xBBBBBB, .width_px = 0.6},
     {.name = "dot", .fill = kInk},
     {.name = "workpiece", .fill = 0xE8E2D4, .stroke = kEdge, .width_px = 1},
     {.name = "shade1", .fill = 0xD0C8B4},
     {.name = "shade2", .fill = 0xB8AE96},
     {.name = "shade3", .fill = 0x9C917A},
     {.name = "shade4", .fill = 0x7E7460},
     {.name = "edge", .stroke = kEdge, .width_px = 1},
     {.name = "contour", .stroke = kInk, .width_px = 3.2, .has_round_joins = true},
     {.name = "feed", .stroke = 0x0B4F9E, .width_px = 2, .has_round_joins = true},
     {.name = "rapid", .stroke = 0xC04000, .width_px = 1.4, .dash_px = 7, .gap_px = 5},
     {.name = "start", .fill = 0x1A7F37},
     {.name = "end", .stroke = 0xA40E26, .width_px = 2.5},
     {.name = "ink", .fill = kInk},
     {.name = "line", .stroke = kInk, .width_px = 0.8}}};

}  // namespace

const Look& look_of(Style style) { return kLooks[static_cast<std::size_t>(style)]; }

}  // namespace cnclab::drawing
