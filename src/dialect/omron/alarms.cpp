#include "dialect/omron/alarms.hpp"

#include <array>

namespace kerf::omron {
namespace {

constexpr std::string_view kCode = "67990000H";
constexpr auto kWarning = Severity::warning;

constexpr std::array kCatalogue{
    // What keeps a program from being started.
    AlarmKind{kCode, "syntax", "Syntax error", "The text is no block and no program code.",
              "Correct the text where the mark stands; `kerf codes --dialect omron` lists every word."},
    AlarmKind{kCode, "unknown-word", "Unknown word", "No word of the controller begins like this.",
              "Write one of A B C F G I J K L M N P R S X Y Z, ta, td, ts or VA to VH, each with a number; a "
              "remark stands behind //."},
    AlarmKind{kCode, "variable", "No such variable",
              "There are the variables L0 to L255, Q0 to Q4095 and P0 to P32767.",
              "Write L, Q or P and a number within these ranges."},
    AlarmKind{kCode, "indirection", "Indirection not allowed here",
              "A variable in brackets gives the value of a word of a block and stands nowhere else.",
              "Write the variable itself, as in L0=Q1; in a word only its name between the brackets, as in "
              "X[L0]."},
    AlarmKind{
        kCode, "function", "Unknown function", "The controller has no function of this name.",
        "Use one of abs, acos, acosd, acosh, asin, asind, asinh, atan, atan2, atan2d, atand, atanh, cbrt, "
        "ceil, cos, cosd, cosh, exp, exp2, floor, int, isnan, log, log10, log2, pow, qnrt, qrrt, rint, sgn, "
        "sin, sind, sinh, sqrt, tan, tand, tanh."},
    AlarmKind{kCode, "truth-value", "Number and truth value mixed up",
              "A comparison gives a truth value, which no calculation takes, and a condition is no number.",
              "Compare numbers in conditions, as in if(L0==1), and assign numbers only."},
    AlarmKind{kCode, "nesting", "Nested too deeply",
              "Control statements or parentheses stand too deep inside of each "
              "other.",
              "Put the inner part into a subprogram, or its value into a variable."},
    AlarmKind{kCode, "block-skip", "Optional skip not allowed here",
              "A block that can be skipped begins with a slash and a constant from 1 to 31.",
              "Write /1 to /31 in front of a block of words."},
    AlarmKind{kCode, "block-length", "Block too long",
              "In intermediate code a block may have at most 1020 bytes, and kerf keeps 128 words of it.",
              "Split the block into several."},

    // What a block has wrong.
    AlarmKind{kCode, "unknown-code", "Unknown code", "The controller has no such G code.",
              "`kerf codes --dialect omron` lists every code."},
    AlarmKind{kCode, "m-code", "M code out of range", "M codes are integers from 0 to 191.",
              "Write M and a number from 0 to 191."},
    AlarmKind{kCode, "two-m-codes", "Two M codes in a block",
              "A block can command only one auxiliary function.",
              "Put the second M code into a block of its own."},
    AlarmKind{kCode, "m-code-words", "Words that do not belong to the M code",
              "VA to VH are arguments of an M code; M00, M01, M02, M30, M98 and M99 take none.",
              "Delete the arguments, or write the M code they are meant for."},
    AlarmKind{
        kCode, "conflicting-codes", "Conflicting G codes",
        "Two codes of one modal group, or two codes that both want the words of the block, stand together.",
        "Keep one of them, or put the second into a block of its own."},
    AlarmKind{kCode, "repeated-word", "Word written twice", "An address may stand only once in a block.",
              "Delete one of the two words."},
    AlarmKind{kCode, "unused-word", "Word without a code", "No code in force in this block takes the word.",
              "Delete the word, or write the code it is meant for."},
    AlarmKind{kCode, "no-axis", "No such axis", "The machine file has no axis of this name.",
              "Delete the word, or add an [axes] table for the axis to the machine file."},
    AlarmKind{kCode, "value-range", "Value out of range", "The value of the word is outside of its range.",
              "Write a value within the range that the message gives."},
    AlarmKind{kCode, "not-a-number", "Word without a value",
              "The variable behind the word holds no number, or an infinite one.",
              "Look for a division by zero, or a function outside of its domain, in front of this block."},
    AlarmKind{kCode, "missing-feed", "No feedrate", "A cutting move is commanded, and no F was ever written.",
              "Write F in the block or in front of it."},
    AlarmKind{kCode, "feed-range", "Feedrate out of range",
              "F must be above 0 and at most omron.maximum_feedrate.", "Write a feedrate within that range."},
    AlarmKind{kCode, "arc-words", "Arc without centre and radius", "An arc needs I, J, K or R.",
              "Write the centre from the start point, for example I10 J0, or the radius R."},
    AlarmKind{kCode, "arc-radius", "Arc cannot be made",
              "The radius is too small to reach the end, or the start or the end lies on the centre.",
              "Correct the end point, the radius or the centre; a full circle needs I, J or K."},
    AlarmKind{kCode, "arc-scaling", "Arc scaled to an ellipse",
              "The two axes of the plane have different magnifications, which would make the arc an ellipse.",
              "Give both axes of the plane the same magnification, with any sign."},
    AlarmKind{
        kCode, "cycle-active", "Word not allowed in a fixed cycle",
        "Between G74 or G84 and G80 only G74, G84, G98, G99 and positions may stand; G00 to G03 end the "
        "cycle.",
        "Write G80 in front of this block."},
    AlarmKind{kCode, "cycle-words", "Fixed cycle without levels",
              "The first block of a tapping cycle needs the Z point Z and the R point R.",
              "Write Z and R in the block with G74 or G84."},
    AlarmKind{kCode, "cycle-spindle", "Fixed cycle without spindle speed",
              "The spindle axis turns with Z at the pitch F / S, and S is missing or 0.",
              "Write S above 0 in the block or in front of it."},
    AlarmKind{kCode, "cycle-plane", "Fixed cycle in a rotated plane",
              "Tapping works along Z, and the rotation in force would tilt it.",
              "End the rotation with G69, or rotate in the plane G17."},
    AlarmKind{kCode, "compensation-start", "Radius compensation cannot start here",
              "The first move behind G41 or G42 must be a G01 at least as long as the radius of the tool.",
              "Put a straight move, longer than the tool's radius, in front of the contour."},
    AlarmKind{
        kCode, "compensation-end", "Radius compensation cannot end here",
        "The first move behind G40 must be straight and at least as long as the radius of the tool, and the "
        "program may not end before it.",
        "Put G40 and a straight move, longer than the tool's radius, behind the contour."},
    AlarmKind{
        kCode, "compensation-word", "Not allowed in radius compensation",
        "Between G41 or G42 and the move behind G40 there may be no G00, no other side, no change of "
        "the plane, the unit or the coordinate system, no stop, and no M code that waits for the end of "
        "a movement or has arguments.",
        "End the compensation with G40 and a move first; give the M code output timing 1 "
        "(omron.immediate_m_codes)."},
    AlarmKind{kCode, "compensation-radius", "Tool too large for an arc",
              "The tool runs inside of an arc whose radius is not larger than its own.",
              "Use a smaller tool, or put a straight move in place of the arc."},
    AlarmKind{kCode, "compensation-path", "Compensated paths do not meet",
              "Beside two neighbouring blocks there is no path for the tool.",
              "Use a smaller tool, or correct the end points of the blocks."},
    AlarmKind{
        kCode, "overcut", "Overcut", "The tool would cut into a block of the contour.",
        "Use a smaller tool, or set omron.overcut_operation_mode to \"prevention\", which leaves out blocks "
        "that cannot be cut where it finds a way."},
    AlarmKind{kCode, "dwell-words", "Dwell with two times",
              "A dwell has one time: F or X in seconds, or P in ms.", "Keep one of the words."},
    AlarmKind{kCode, "rotation-angle", "Rotation without angle", "G68 needs the angle R.",
              "Write R and an angle from -360 to 360 degrees."},
    AlarmKind{kCode, "rotation-plane", "Plane changed under rotation",
              "G17 to G19 cannot select another plane while G68 is in force.",
              "End the rotation with G69 first."},
    AlarmKind{kCode, "reference-point", "No such reference point",
              "G30 goes to the reference points P2, P3 and P4.",
              "Write P2, P3 or P4, or leave P out for the second one."},
    AlarmKind{kCode, "offset-active", "Compensation in force",
              "G28, G30 and G53 need tool length offset and tool radius compensation to be off.",
              "End them with G49 and G40 in front of this block."},
    AlarmKind{kCode, "over-travel", "Software stroke limit", "The move would leave the travel of an axis.",
              "Correct the target, the work coordinate system or axes.X.limits."},
    AlarmKind{kCode, "missing-program", "No such subprogram", "M98 calls a program that is not there.",
              "Put the program, named by its number as 1000.nc, into the folder of the main program or into "
              "--program-dir."},
    AlarmKind{
        kCode, "program-number", "Program number out of range",
        "M98 P calls subprograms 1000 to 9999 (1000 to 2999 of the engineering tool, 3000 to 9999 of the "
        "operator panel).",
        "Write P and a number from 1000 to 9999."},
    AlarmKind{kCode, "captured-position", "No such captured position",
              "The index of _CNC_CapturedPosition counts the motors of the coordinate system from 0, in the "
              "order of their numbers.",
              "Write an index from 0 to the number of motors less 1."},
    AlarmKind{
        kCode, "endless-loop", "Endless loop",
        "The program has jumped back, repeated and called so often that it counts as endless: a hundred "
        "million times, or ten million with moves or other actions between.",
        "Change a variable of the condition inside the loop, so that it comes to an end."},
    AlarmKind{kCode, "no-program-end", "No end of program",
              "The text ends without M30 or M02; kerf ends the program there.",
              "Write M30 in the last block.", kWarning},
};

}  // namespace

std::span<const AlarmKind> alarm_catalogue() {
  return kCatalogue;
}

const AlarmKind& alarm_kind(std::string_view detail) {
  return find_alarm(kCatalogue, detail);
}

}  // namespace kerf::omron
