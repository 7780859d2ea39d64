#pragma once
// Interference of the tool radius compensation: points of two neighbouring corners between which the tool
// would run back along the block that joins them (MELSEC 6.4, interference check).

#include <cstdint>
#include <optional>

#include "toolpath/corner.hpp"

namespace kerf {

inline constexpr double kBack = 1e-6;  ///< mm; a way back that rounding may make

/// How far a segment goes on from one point to another, less than 0 when it runs back. mm
double advance_along(const OffsetSegment& segment, Vec2 from, Vec2 to);

enum class Interference : std::uint8_t {
  none,
  partly,  ///< the points that interfered are gone
  wholly,  ///< so would be all points of a corner: the corners are left as they were
};

/// Whether the tool keeps out of a block on a way: to 0.0005 mm, and to what the arcs are out of round.
bool keeps_clear(const OffsetSegment& block, const PlanarSegment& way);

/// The blocks on both sides of a segment, as far as the tool has to keep out of them.
struct Neighbours {
  const OffsetSegment* before = nullptr;
  const OffsetSegment* behind = nullptr;
};

/// Looks at the corner where a segment begins and at the one where it ends. From the outermost points
/// inwards, the first pair whose way runs against the segment and all points inside of it are removed; where
/// one corner has more points than the other, its inner ones first. More are removed while the straight way
/// that is left would cut into the segment itself or into its neighbours. Points that the program commands
/// stay.
Interference remove_interference(Corner& begin, const OffsetSegment& segment, Corner& end,
                                 const Neighbours& neighbours);

/// Where the path beside the segment before meets that beside the segment behind; nothing when they do not
/// meet, or only before their starts or behind their ends. `from` is where the tool enters the first.
std::optional<Vec2> avoiding_point(const OffsetSegment& before, Vec2 from, const OffsetSegment& behind);

}  // namespace kerf
