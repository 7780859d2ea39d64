#pragma once
// Blocks of a compensated contour as seen from one of them: which of them a way of the tool cuts into.
//
// Near a block is not yet in it: the tool crosses the run-on of a contour again on its run-off, and the
// tracks of a spiral lie closer together than the tool is wide. What tells them apart is how far the contour
// turns in between. Where a tool on the left of a block runs into a block ahead of it, that block crosses its
// way from right to left, so the contour has turned to the left by 0 to 180 degrees until there; a contour
// that comes back to its own beginning has turned once around more, or less.

#include <cstdint>

#include "toolpath/corner.hpp"

namespace kerf {

struct SeenBlock {
  OffsetSegment segment;
  double heading_deg = 0.0;  ///< at its start, counted on along the contour over whole turns
  std::uint32_t number = 0;  ///< Origin::block
  Vec2 middle;               ///< of a circle around it
  double reach_mm = 0.0;     ///< radius of that circle
};

/// A way of the tool's centre.
struct SeenWay {
  PlanarSegment path;
  double heading_deg = 0.0;  ///< at its start, counted as that of blocks
  Vec2 middle;
  double reach_mm = 0.0;
};

/// `heading_deg`: of the contour at the end of the block before.
SeenBlock seen_block(const OffsetSegment& segment, std::uint32_t number, double heading_deg);
double heading_at_end(const SeenBlock& block);

/// The round corner behind a block as a block of its own, of no size.
SeenBlock seen_corner(const SeenBlock& first, const Corner& corner);

/// How far the contour turns between two blocks; at an exact reversal away from the tool. Degrees, positive
/// to the left.
double turn_between(const OffsetSegment& first, const OffsetSegment& next);

/// The tool's way beside a block from one point to another.
SeenWay way_beside(const SeenBlock& block, Vec2 from, Vec2 to);
/// A part of the way around the corner behind a block.
SeenWay way_behind(const SeenBlock& block, const PlanarSegment& path);

/// Where a block stands in the program, seen from a way.
enum class Place : std::uint8_t { ahead, behind };

/// Whether the tool cuts into a block on its way.
bool cuts_into(const SeenWay& way, const SeenBlock& block, Place place);

/// Whether a block ahead takes the tool over where its path crosses that of another one: it crosses it
/// towards the tool's side.
bool takes_over(const SeenBlock& from, const SeenBlock& ahead, Vec2 at);

/// What outer corners before and behind a straight block add to the path beside it. mm
struct Extensions {
  double before_mm = 0.0;
  double behind_mm = 0.0;
};

/// Whether a point of the curve or line beside a block lies on the path itself, extensions included.
bool is_on_path(const SeenBlock& block, Vec2 point, const Extensions& extensions);

}  // namespace kerf
