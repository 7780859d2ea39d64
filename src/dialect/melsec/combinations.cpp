#include "dialect/melsec/combinations.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace kerf::melsec {
namespace {

constexpr CodeSet all_of(std::initializer_list<CodeNumber> codes) {
  CodeSet set = 0;
  for (const CodeNumber number : codes) set |= set_of(number);
  return set;
}

constexpr CodeSet kArcs = all_of({code(2), code(3)});
constexpr CodeSet kPlanes = all_of({code(17), code(18), code(19)});
constexpr CodeSet kRadiusOn = all_of({code(41), code(42)});
constexpr CodeSet kRadius = kRadiusOn | set_of(code(40));
constexpr CodeSet kLength = all_of({code(43), code(44), code(49)});
constexpr CodeSet kSystems = all_of({code(54), code(55), code(56), code(57), code(58), code(59)});
constexpr CodeSet kNormalOn = all_of({code(41, 1), code(42, 1)});
constexpr CodeSet kNormal = kNormalOn | set_of(code(40, 1));
constexpr CodeSet kRotationOn = set_of(code(68));
constexpr CodeSet kRotation = kRotationOn | set_of(code(69));
constexpr CodeSet kPolarOn = set_of(code(12, 1));
constexpr CodeSet kPolar = kPolarOn | set_of(code(13, 1));
constexpr CodeSet kHighAccuracy = set_of(code(61, 1));
constexpr CodeSet kCorners = all_of({code(38), code(39)});
constexpr CodeSet kEverything = (CodeSet{1} << kGCodes.size()) - 1;

// Where the printed tables contradict themselves, docs/decisions.md says which cell was taken.
constexpr std::array kInBlock{
    Combination{kPolar, kRotationOn, "0324H"},
    Combination{kPolar, kEverything & ~kPolar & ~kRotationOn, "0306H"},
    Combination{all_of({code(4), code(52), code(53)}), kRadius | kLength | kRotation, "030FH"},
    Combination{kRadius, kArcs, "0315H"},
    Combination{set_of(code(38)), kArcs, "0306H"},
    Combination{kCorners, kPlanes, "0316H"},
    Combination{kPlanes, set_of(code(69)), "0326H"},
};

constexpr std::array kInModal{
    Combination{kPlanes, kRadiusOn, "0316H"},
    Combination{kPlanes, kNormalOn, "031CH"},
    Combination{kPlanes, kRotationOn, "0326H"},
    Combination{set_of(code(52)) | kSystems, kNormalOn, "0304H"},
    Combination{kNormal, kHighAccuracy, "0304H", true},
    Combination{kHighAccuracy, kNormalOn, "0304H", true},
    Combination{kRadius, kArcs, "0315H"},
    Combination{set_of(code(38)), kArcs, "0306H"},
    Combination{set_of(code(62)), kPolarOn, "0324H", false, kRadiusOn},
    Combination{all_of({code(52), code(53), code(62)}) | kPlanes | kLength | kSystems | kNormal |
                    kRotationOn | kPolarOn,
                kPolarOn, "0322H"},
    Combination{kHighAccuracy, kPolarOn, "0322H", true},
    Combination{kPolar, kRadiusOn | kNormalOn | kRotationOn | set_of(code(62)), "0324H"},
    Combination{kPolar, kHighAccuracy, "0324H", true},
};

}  // namespace

Combination refused_in_block(CodeSet codes) {
  const auto* const found = std::find_if(kInBlock.begin(), kInBlock.end(), [&](const Combination& rule) {
    return (codes & rule.commanded) != 0 && (codes & rule.against) != 0;
  });
  return found == kInBlock.end() ? Combination{} : *found;
}

Combination refused_in_modal(CodeSet codes, CodeSet in_force, bool axis_tolerance) {
  const auto* const found = std::find_if(kInModal.begin(), kInModal.end(), [&](const Combination& rule) {
    if (rule.allowed_with_axis_tolerance && axis_tolerance) return false;
    if (rule.also != 0 && (in_force & rule.also) == 0) return false;
    return (codes & rule.commanded) != 0 && (in_force & rule.against) != 0;
  });
  return found == kInModal.end() ? Combination{} : *found;
}

}  // namespace kerf::melsec
