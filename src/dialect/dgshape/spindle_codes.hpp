#pragma once
// The two-digit spindle speed codes (manual 2-4).

namespace kerf::dgshape {

/// Speed of code 01 to 98 in rpm: 20 steps to the decade in the preferred numbers R20, code 20 being 10 rpm.
/// Codes 00 and 99 mean the machine's minimum and maximum and are not asked for here.
double spindle_code_rpm(int code);

}  // namespace kerf::dgshape
