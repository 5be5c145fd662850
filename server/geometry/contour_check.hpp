// Does the way of the tool's centre cut into another part of its own contour?
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/path_stages.hpp"
#include "geometry/plane_piece.hpp"

namespace cnclab::geometry {

/// The gouge check of whole chains, from the entry to the exit of one G41 or G42, both of them included.
///
/// `PathStages` tells it what it does, the owner reads the findings. Joints are right by construction (see
/// `ContourOffset`); what only the whole chain shows is a way that returns beside an earlier wall, or a pocket that is
/// too narrow between elements that are not neighbours.
///
/// A finding is a way that comes closer to a contour element than the tool's radius less `kRounded_mm`, and less
/// what the two radii of an arc of the chain are apart (D-55): the contour is known no better. No finding are:
///   - elements whose ranges along the normal do not overlap (passes at another depth); entry and exit as far as they
///     lie above the element: what stands below is not cut (the normal points along the tool);
///   - run-in and run-out: if one of the first three elements begins where one of the last three ends (within the arc
///     tolerance, as in G-024), the contour is closed: it is what lies between; what comes before and behind is air to
///     the ways (EX-080: N010 runs on past the corner where N006 began).
///
/// Entry and exit keep the same distance. So an entry to a closed contour begins on the tool's side of its first wall,
/// beyond the line on which the tool will run; nearer it would take the finished corner off, from the wrong side it
/// would cross a wall (COMP-007). An open contour has no neighbour at its free ends: where it begins and ends it is led
/// out of the workpiece, and a tool standing there may touch it. Of its first walls the entry, of its last ones the
/// exit is given what lies within the tool's radius of that end, however many blocks it is written in, and nothing
/// more.
///
/// Memory: that of one chain, about 400 bytes per element. Time: n·log n for chains that stay near themselves.
class ContourCheck {
 public:
  /// Findings kept per chain; one for each pair of blocks, with the smallest distance.
  static constexpr std::size_t kMostFindings = 20;

  /// A chain begins with the way that enters it, from where the tool stands to beside the first element. An open one is
  /// dropped.
  void begin(Plane plane, double radius_mm, SourceBlock source, const Line& entry);
  /// The next element of the programmed contour (corners already rounded), followed by the ways that machine it.
  void add_contour(SourceBlock source, const PathElement& element);
  void add_path(SourceBlock source, const PathElement& way);
  /// The arc about the corner ahead of the newest element.
  void add_corner(SourceBlock source, const Arc& corner);
  /// The chain is complete: works out its findings. Without a chain: nothing.
  void end();
  /// The way that leaves the chain that has ended last. Another way between the two: nothing is looked at.
  void add_exit(SourceBlock source, const Line& exit);
  /// Ends the part of the chain that is known by now, and goes on with an empty one: for chains too long to be kept.
  void split();
  /// Has a chain begun that is not complete yet?
  [[nodiscard]] bool is_open() const { return is_open_; }

  /// … too_close of all chains so far: `block` comes closer to `other` than the tool's radius.
  [[nodiscard]] const std::vector<StageFault>& findings() const { return findings_; }

 private:
  /// A piece of contour element number `element`, from 1, or of the way beside it; 0 is a corner.
  struct Placed {
    PlanePiece piece;
    std::uint32_t element = 0;
    SourceBlock source;
  };

  /// The entry or exit of a chain.
  struct Passage {
    StageFault::Kind kind{};
    SourceBlock source;
    Line line;
    std::uint32_t element = 0;  ///< the one that it leads to or comes from; 0: of another part
  };

  void append(SourceBlock source, const PathElement& element, std::uint32_t number, std::vector<Placed>& pieces);
  void keep_closed_part();
  static void drop_repeated(std::vector<Placed>& pieces);
  void plant_tree();
  void compare(const Placed& way, const Placed& wall);
  void look_round(const Passage& passage);
  void look_at(const Passage& passage, const Placed& wall);
  [[nodiscard]] std::optional<PlanePiece> counted_part(const Passage& passage, const Placed& wall) const;
  void note(StageFault::Kind kind, SourceBlock way, SourceBlock wall, double found_mm);

  Plane plane_ = Plane::xy;
  double radius_mm_ = 0;
  bool is_open_ = false;
  bool is_closed_ = false;    ///< the contour, once it is complete
  bool awaits_exit_ = false;  ///< a chain has ended, its walls are in the tree
  Passage entry_;
  std::uint32_t elements_ = 0;       ///< of the contour so far
  double tolerance_mm_ = 0;          ///< what is no finding, see above
  std::vector<PlaneVector> joints_;  ///< where each element begins, and where the newest ends
  std::vector<Placed> contour_, ways_;
  std::vector<PlanePiece> pieces_;  ///< of the newest element
  std::vector<PieceBox> boxes_;     ///< of contour_, once it is complete
  PieceTree tree_;                  ///< over boxes_
  std::size_t first_of_chain_ = 0;  ///< in findings_
  std::vector<StageFault> findings_;
};

}  // namespace cnclab::geometry
