#include "dialect/dgshape/alarms.hpp"

#include <array>

namespace kerf::dgshape {
namespace {

constexpr std::string_view kCode = "DGS";
constexpr auto kWarning = Severity::warning;

constexpr std::array kCatalogue{
    AlarmKind{kCode, "no-data-start", "No data start",
              "The data has no block that consists of % alone, so the machine does not execute it.",
              "Put a line with nothing but % in front of the first block."},
    AlarmKind{kCode, "data-start", "Words beside %", "A block with % must hold nothing else.",
              "Write % alone on its line and the other words on the next."},
    AlarmKind{kCode, "program-number", "Program number not allowed here",
              "A program number is an integer of at most eight digits, alone in its block.",
              "Write O and up to eight digits alone on the line behind the first %."},
    AlarmKind{kCode, "second-program-number", "Second program number",
              "A program may have only one program number.", "Delete this O word, or split the file in two."},
    AlarmKind{kCode, "sequence-number", "Sequence number not allowed",
              "A sequence number is an integer of at most eight digits at the start of its block.",
              "Write N and up to eight digits as the first word of the block."},
    AlarmKind{kCode, "unknown-code", "Unknown code", "The controller has no such word.",
              "`kerf codes --dialect dgshape` lists every code the controller knows."},
    AlarmKind{kCode, "bad-character", "Character that is no word",
              "Outside of comments only address letters, numbers, / and parentheses may stand in a block.",
              "Delete the character, or put the remark into parentheses."},
    AlarmKind{kCode, "bad-number", "Word without a number",
              "An address letter needs a number right behind it.",
              "Write the number behind the letter, for example X10.0."},
    AlarmKind{
        kCode, "line-end", "Line end that is no end of block",
        "A block ends with a line feed, or a carriage return and a line feed; a carriage return alone is no "
        "end of block.",
        "Save the file with line ends LF (Unix) or CR LF (Windows)."},
    AlarmKind{kCode, "comment-open", "Comment not closed", "A comment must close with ) in its own block.",
              "Add the missing ) at the end of the comment."},
    AlarmKind{kCode, "block-skip", "Slash inside a block",
              "An optional block skip stands at the start of the block.",
              "Move the / in front of the first word (behind a sequence number is fine too)."},
    AlarmKind{kCode, "block-too-long", "Too many words in a block",
              "The block has more words than the controller takes in one block.",
              "Split the block into several."},
    AlarmKind{kCode, "value-range", "Value out of range",
              "The number is larger than the word accepts: eight digits without a decimal point, 99999.999 "
              "with one "
              "(9999.9999 for lengths and feeds in inches).",
              "Correct the value."},
    AlarmKind{kCode, "decimal-point", "Decimal point not allowed", "This word takes an integer.",
              "Write the number without a decimal point."},
    AlarmKind{kCode, "repeated-word", "Word given twice",
              "Only G and M words may appear more than once in a block.",
              "Keep one of the two words, or split the block."},
    AlarmKind{kCode, "unused-word", "Word without a code",
              "No code of the block takes this word, so the controller cannot know what it means.",
              "Delete the word, or add the code it belongs to."},
    AlarmKind{kCode, "missing-word", "Word missing", "The code needs another word.", "Add the missing word."},
    AlarmKind{kCode, "conflicting-codes", "Codes that exclude each other",
              "Two codes of the block want the same words or the same moment.",
              "Write them in blocks of their own."},
    AlarmKind{kCode, "stands-alone", "Must stand alone",
              "M00, M01, M02 and M30 must be alone in their block.",
              "Move the word into a block of its own."},
    AlarmKind{kCode, "unit-change", "Unit changed in mid-program",
              "G20 or G21 belongs at the start of the program, before any coordinate setting or motion; the "
              "unit may "
              "not change afterwards.",
              "Give G20 or G21 once, in one of the first blocks."},
    AlarmKind{kCode, "no-rotary-unit", "No rotary axis",
              "The machine has no rotary axis unit, so there is no A axis.",
              "Delete the A word, or set dgshape.rotary_unit = true."},
    AlarmKind{kCode, "no-feed", "No feed rate",
              "A cutting move needs a feed rate, and no F word was given yet.",
              "Give F in this block or before, for example F300.0."},
    AlarmKind{kCode, "no-tool-changer", "No tool changer",
              "Tool selection and tool-length offset work only on machines with an automatic tool changer.",
              "Delete the word, or set dgshape.tool_changer = true."},
    AlarmKind{kCode, "no-equipment", "Equipment not fitted",
              "The machine is not equipped for this function; the word is ignored.",
              "Delete the word, or enable the equipment in the machine file.", kWarning},
    AlarmKind{kCode, "tool-number", "No such stocker", "The magazine has no such stocker.",
              "Use a stocker number the magazine has, or 0 to put the tool back."},
    AlarmKind{kCode, "tool-word", "M06 and T belong together",
              "M06 needs exactly one T in the same block, and T is allowed only with M06.",
              "Write them together, for example M06T2."},
    AlarmKind{kCode, "offset-number", "No such tool-diameter offset",
              "The offset number is not one of the machine's tool-diameter offsets.",
              "Use a number from 1 to dgshape.offset_numbers."},
    AlarmKind{kCode, "length-number", "No such tool-length offset",
              "The offset number is not one of the machine's tool-length offsets.",
              "Use a number from 1 to dgshape.length_numbers, or 0 to cancel."},
    AlarmKind{kCode, "coordinate-number", "No such coordinate system",
              "P of G10L2 is 0 (EXOFS) or 1 to 6 (G54 to G59).", "Use P0 to P6."},
    AlarmKind{kCode, "data-words", "Words do not fit G10",
              "G10 has two forms: G10L2P..X..Y..Z..A.. for coordinate systems and G10P..R.. for "
              "tool-diameter offsets.",
              "Write one of the two forms."},
    AlarmKind{kCode, "arc-words", "Arc not defined",
              "An arc needs either its centre (I, J, K) or its radius (R), not both and not neither.",
              "Give the centre as the distance from the start point, or the radius."},
    AlarmKind{kCode, "arc-axis", "A in an arc", "Circular interpolation cannot move the A axis.",
              "Move A in a block of its own."},
    AlarmKind{
        kCode, "arc-radius", "Arc does not reach its end",
        "The start and the end of the arc are not on one circle, or the radius is too small to reach the "
        "end.",
        "Correct the end point, the centre or the radius; dgshape.arc_tolerance is the difference allowed."},
    AlarmKind{kCode, "centre-word", "Centre word of another plane",
              "G17 takes I and J, G18 takes I and K, G19 takes J and K.",
              "Delete the word, or select the plane you mean."},
    AlarmKind{kCode, "spindle-stopped", "Spindle is not rotating",
              "The block must not run while the spindle stands still.",
              "Start the spindle with S and M03 before."},
    AlarmKind{kCode, "cycle-axis", "A in a fixed cycle", "Fixed cycles use X, Y and Z only.",
              "Move A in a block of its own before the cycle."},
    AlarmKind{kCode, "cycle-plane", "Fixed cycle in another plane",
              "Fixed cycles drill along Z in the X-Y plane only.", "Select G17 before the cycle."},
    AlarmKind{kCode, "cycle-levels", "Hole bottom above point R",
              "The bottom of the hole must not lie above point R.",
              "Check Z and R, and whether G90 or G91 is in force."},
    AlarmKind{kCode, "repeat-count", "Repetitions out of range",
              "K of a fixed cycle is an integer from 0 to 9999.", "Use 0 to 9999, or several blocks."},
    AlarmKind{kCode, "cycle-steps", "Too many steps in a fixed cycle",
              "A block of G83 may make 100 000 steps, its repetitions taken together.",
              "Give Q a larger step, for example Q1.0; without a decimal point Q counts thousandths."},
    AlarmKind{kCode, "offset-plane", "Tool-diameter offset needs the X-Y plane",
              "Tool-diameter offset works in the X-Y plane (G17) only.",
              "Select G17 before G41 or G42, and cancel the offset with G40 before G18 or G19."},
    AlarmKind{kCode, "offset-start-arc", "Tool-diameter offset started on an arc",
              "Tool-diameter offset must start with a straight move (G00 or G01).",
              "Put a straight lead-in move with G41 or G42 in front of the arc."},
    AlarmKind{kCode, "offset-end-arc", "Tool-diameter offset ended on an arc",
              "Tool-diameter offset must end with a straight move (G00 or G01).",
              "Write G40 with a straight lead-out move behind the arc."},
    AlarmKind{
        kCode, "offset-active", "Not allowed during tool-diameter offset",
        "Coordinate settings, fixed cycles, scaling, G28 and G53 are errors while G41 or G42 is in force.",
        "Cancel the offset with G40 and a straight move first."},
    AlarmKind{kCode, "offset-change", "Tool-diameter offset changed in use",
              "The offset number and the side cannot change while the offset is in force.",
              "Cancel with G40, then give G41 or G42 again with the new number."},
    AlarmKind{kCode, "corner-arc", "G39 without tool-diameter offset",
              "Corner-offset circular interpolation works only while G41 or G42 is in force.",
              "Start the offset before, or delete G39."},
    AlarmKind{kCode, "inner-arc-radius", "Arc smaller than the tool",
              "The inner side of an arc is smaller than the tool-diameter offset.",
              "Use a smaller tool, or a larger radius in the contour."},
    AlarmKind{kCode, "no-crossover", "No crossover point",
              "The offset paths of two neighbouring blocks do not meet.",
              "Use a smaller offset, or change the contour at this corner."},
    AlarmKind{kCode, "g53-incremental", "G53 in incremental programming",
              "G53 takes absolute machine coordinates and must be given in G90.", "Add G90 to the block."},
    AlarmKind{kCode, "reference-axis", "A in G28", "G28 cannot move the A axis.",
              "Delete the A word and move A with G00 or G53."},
    AlarmKind{kCode, "rapid-axes", "Too many axes at once",
              "The machine cannot move so many axes together in rapid feed.",
              "Split the move into two blocks, or raise dgshape.rapid_axes."},
    AlarmKind{kCode, "over-travel", "Over-travel", "The move would leave the machine's range of travel.",
              "Check the coordinates, the work offsets and the machine's limits."},
    AlarmKind{kCode, "spindle-range", "Spindle speed out of range", "A spindle speed cannot be negative.",
              "Give a positive spindle speed."},
    AlarmKind{kCode, "feed-range", "Feed rate out of range", "A feed rate cannot be negative.",
              "Give a positive feed rate."},
    AlarmKind{kCode, "no-program-end", "Program end missing",
              "The data ended without M02 or M30; the machine stops here.",
              "End the program with M02 or M30.", kWarning},
    AlarmKind{kCode, "spindle-off", "Cutting with the spindle stopped",
              "The tool cuts while the spindle stands still: G01, G02 and G03 do not start it.",
              "Start the spindle with S and M03 before the first cut.", kWarning},
};

}  // namespace

std::span<const AlarmKind> alarm_catalogue() {
  return kCatalogue;
}

const AlarmKind& alarm_kind(std::string_view detail) {
  return find_alarm(kCatalogue, detail);
}

const AlarmKind& syntax_alarm_kind(SyntaxFault fault) {
  switch (fault) {
    case SyntaxFault::none:
      break;
    case SyntaxFault::no_data_start:
      return alarm_kind("no-data-start");
    case SyntaxFault::data_mark:
      return alarm_kind("data-start");
    case SyntaxFault::bad_character:
      return alarm_kind("bad-character");
    case SyntaxFault::letter_in_number:
    case SyntaxFault::bad_number:
      return alarm_kind("bad-number");
    case SyntaxFault::line_end:
      return alarm_kind("line-end");
    case SyntaxFault::comment_open:
      return alarm_kind("comment-open");
    case SyntaxFault::block_skip:
      return alarm_kind("block-skip");
    case SyntaxFault::block_too_long:
      return alarm_kind("block-too-long");
  }
  return alarm_kind("bad-character");
}

}  // namespace kerf::dgshape
