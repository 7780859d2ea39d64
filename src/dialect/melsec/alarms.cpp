#include "dialect/melsec/alarms.hpp"

#include <array>

namespace kerf::melsec {
namespace {

constexpr std::string_view kConfiguration = "30FDH";
constexpr std::string_view kProgramFile = "1FC0H";
constexpr std::string_view kOperation = "1FC1H";
constexpr std::string_view kStop = "1FC2H";
constexpr std::string_view kProgram = "1FC3H";
constexpr std::string_view kOwn = "KERF";

// The manual names 1FC0H and 30FDH together for 0010H to 0042H. Its chapter 4 uses 30FDH for every parameter,
// chapter 5 1FC0H for the program file.
constexpr std::array kCatalogue{
    AlarmKind{kConfiguration, "0010H", "Base axis setting error",
              "The base axes I, J and K span the planes of the arcs, so each must be an axis of its own that "
              "the line has.",
              "Set melsec.system.base_axis_i, base_axis_j and base_axis_k to three different axes that have "
              "an [axes] table, or to 0."},
    AlarmKind{
        kConfiguration, "0011H", "Normal line control axis name error",
        "Normal line control is set to turn an axis that the line does not have.",
        "Set melsec.system.normal_line_axis to an axis of the machine, or to 0 for no normal line control."},
    AlarmKind{kConfiguration, "0012H", "Normal line control axis setting error",
              "The tool can be kept square to the path only by a rotary axis that is no base axis and may "
              "turn as fast as is asked of it.",
              "Choose a rotary axis that is no base axis as melsec.system.normal_line_axis, and keep "
              "melsec.system.normal_line_rotating_speed at or below that axis's max_feed, for example "
              "axes.C.max_feed."},
    AlarmKind{kConfiguration, "0013H", "Polar coordinate interpolation axis name error",
              "Polar coordinate interpolation needs one linear and one rotary axis, and one of the two is "
              "missing or not on the line.",
              "Set melsec.system.polar_linear_axis and melsec.system.polar_rotary_axis both to axes of the "
              "machine, or both to 0."},
    AlarmKind{kConfiguration, "0014H", "Polar coordinate interpolation axis setting error",
              "The two polar axes are of the wrong kind: the linear one must be a base axis, the rotary one "
              "neither a base axis nor the normal line control axis.",
              "Set melsec.system.polar_linear_axis to a linear base axis such as X, and "
              "melsec.system.polar_rotary_axis to a rotary axis used for nothing else, such as C."},
    AlarmKind{kConfiguration, "0015H", "High-accuracy control setting error",
              "The highest speed planned before interpolation is lower than the speed at which an axis is "
              "allowed to cut.",
              "Raise melsec.system.pre_accel_max_speed to at least the largest axes.X.max_feed and "
              "melsec.axis.X.high_accuracy_cutting_clamp_speed."},
    AlarmKind{kConfiguration, "0016H", "Macro control setting error",
              "The devices that hold the macro variables are too many, missing, beyond the end of the device "
              "range, or claimed twice.",
              "Keep melsec.system.common_all_points and common_system_points at 900 together, and give them "
              "and the 660 words of the local variables start devices (common_all_start_device, "
              "common_system_start_device, local_start_device) that do not overlap."},
    AlarmKind{kConfiguration, "0020H", "Axis No. setting error",
              "An axis has a number that no drive of the servo network answers to, or that another axis has "
              "already.",
              "Give every axis an axes.X.number of its own that belongs to a drive of the network."},
    AlarmKind{kConfiguration, "0021H", "Axis name error",
              "Two axes of one line carry the same letter, so a word such as X10. could mean either.",
              "Give each axis of the line a letter of its own, with one table such as [axes.X] for each."},
    AlarmKind{kConfiguration, "0022H", "Control unit error",
              "The unit does not suit the axis: a linear axis is controlled in mm and a rotary axis in "
              "degrees; inches are not possible.",
              "Set axes.C.type to rotary for an axis in degrees and axes.X.type to linear for one in mm."},
    AlarmKind{kConfiguration, "0023H", "Tandem function setting error",
              "An axis cannot follow its master: a slave axis is named U, V or W, has no other duty, and is "
              "of the same kind as a master that is no slave itself.",
              "Set melsec.axis.U.master_axis_name to an axis of the machine that follows no other, with the "
              "same axes.U.type and melsec.axis.U.rotation_axis_type, and keep the slave out of the base, "
              "normal line and polar axes."},
    AlarmKind{kConfiguration, "0024H", "Software limit setting error",
              "The lower software limit is not below the upper one, or a rotary axis that turns without end "
              "has two different limits.",
              "Write axes.X.limits with the smaller value first, and for a rotary axis with "
              "melsec.axis.C.rotation_axis_type 0 or 1 give the same value twice, for example [0.0, 0.0]."},
    AlarmKind{kProgramFile, "0040H", "G-code program file error",
              "The program file cannot be read, or what the controller keeps of it is damaged.",
              "Save the program to the controller again, and have the memory checked if the alarm returns."},
    AlarmKind{kProgramFile, "0041H", "G-code program capacity over",
              "A program file may have 512 Kbytes, and all program files together 2 Mbytes.",
              "Split the program into several called with M98, or delete programs that are no longer used."},
    AlarmKind{
        kProgramFile, "0042H", "G-code program format error",
        "The file does not begin and end with %, or a block begins with a character that can start no word "
        "or statement.",
        "Write % as the first and as the last line, and begin each block with a capital letter, # or [."},

    AlarmKind{
        kOperation, "0101H", "Stored stroke limit over",
        "An axis stands outside of its software limits when G-code control is requested.",
        "Move the axis back inside while G-code control is off, or correct axes.X.limits or axes.X.start."},
    AlarmKind{kOperation, "0102H", "No operation mode",
              "The line is under G-code control but has no mode in which it could execute a program.",
              "Turn the program operation mode (memory mode, Rq.3381) on before the start."},
    AlarmKind{
        kOperation, "0103H", "Block joint rotating stop during normal line control",
        "With normal line control of type II the tool would turn into the work: the turn between the two "
        "blocks goes the wrong way, or the tool sweeps more than the inside of the arc has room for.",
        "Round the corner with an arc larger than melsec.system.normal_line_radius, give the other side with "
        "G41.1 or G42.1, or raise melsec.system.normal_line_min_angle, and start again after a reset."},
    AlarmKind{kOperation, "0104H", "Reset processing",
              "The cycle start came while the controller was still carrying out a reset.",
              "Wait for the reset complete signal (St.3217) before the next cycle start."},
    AlarmKind{
        kOperation, "0111H", "External stop signal ON",
        "The stop input of an axis is on, and an axis that is told to stop cannot be under G-code control.",
        "Release the stop input, then request G-code control again (Rq.3376)."},
    AlarmKind{kOperation, "0112H", "Hardware stroke limit +",
              "An axis has run onto its upper limit switch, or the wire of the switch is broken.",
              "Jog the axis in its minus direction off the switch with G-code control off, then request "
              "G-code control again."},
    AlarmKind{kOperation, "0113H", "Hardware stroke limit -",
              "An axis has run onto its lower limit switch, or the wire of the switch is broken.",
              "Jog the axis in its plus direction off the switch with G-code control off, then request "
              "G-code control again."},
    AlarmKind{
        kOperation, "0114H", "PLC ready OFF",
        "The motion controller is not in RUN: its PLC ready flag or its preparation completion flag is off.",
        "Switch the motion controller to RUN, turn PLC ready (Rq.1120) on, and request G-code control "
        "again."},
    AlarmKind{
        kOperation, "0115H", "Start acceptance ON",
        "An axis of the line is still busy with another positioning job, such as jogging.",
        "Wait for the other movement to end (start accept flag St.1040 off), then request G-code control."},
    AlarmKind{kOperation, "0116H", "Home position return incomplete",
              "An axis does not know its machine coordinates because its home position was not established.",
              "Return the axis to its home position, then request G-code control."},
    AlarmKind{kOperation, "0117H", "Servo error detection signal ON",
              "The servo drive of an axis reports an error.",
              "Remove the cause that the drive shows, clear it with the servo error reset (Rq.1148), and "
              "request G-code control again."},
    AlarmKind{kOperation, "0118H", "Servo ready OFF",
              "The servo drive of an axis is not ready: it has no power, is still starting up, has an error, "
              "is not connected or is switched to servo off.",
              "Check the power and the cable of the drive and the servo off command (Rq.1155), and request "
              "G-code control when servo ready (St.1075) is on."},
    AlarmKind{kOperation, "0119H", "PLC ready ON at G-code control end",
              "PLC ready came back while G-code control was still coming to its end.",
              "Wait until G-code control is off on all lines (St.3208), then request it with PLC ready on."},

    AlarmKind{kStop, "0201H", "Reset command ON", "The cycle cannot start while the reset command is held.",
              "Turn the reset command (Rq.3380) off before the cycle start."},
    AlarmKind{kStop, "0202H", "Automatically operation pause (feed hold) ON",
              "The cycle cannot start while feed hold is on.",
              "Turn feed hold (Rq.3378) off, then give the cycle start again."},
    AlarmKind{kStop, "0203H", "No operation mode",
              "Cycle start was given, but no mode says what is to be executed.",
              "Turn the program operation mode (memory mode, Rq.3381) on, then give the cycle start."},
    AlarmKind{kStop, "0221H", "Stored stroke limit",
              "The move would take an axis past its software limit; all axes stop before it.",
              "Check the coordinates, the work coordinate system (offsets.G54.X) and axes.X.limits, and "
              "reset before the next start."},
    AlarmKind{kStop, "0222H", "Operation mode change",
              "The operation mode was taken away or changed while a program was running.",
              "Leave the program operation mode (memory mode, Rq.3381) on until the program has ended."},

    AlarmKind{
        kProgram, "0301H", "Cannot be pre-calculated",
        "The controller has to know the next moves in advance, and they lie further ahead than it can read.",
        "Put fewer blocks without movement, such as variables and dwells, between the moves, or cancel tool "
        "radius compensation (G40) before them."},
    AlarmKind{kProgram, "0302H", "Number of synchronization axis over",
              "The block moves more axes than the four that can move together; the normal line control axis "
              "counts as one.",
              "Split the move into blocks of at most four axes each."},
    AlarmKind{kProgram, "0303H", "Axis name setting error",
              "The word belongs to an axis that this machine does not have.",
              "Delete the word or correct its letter, or add the axis to the machine file, for example as "
              "[axes.W]."},
    AlarmKind{kProgram, "0304H", "Command disabled status",
              "Normal line control does not go together with the modal state: it cannot start in it, or the "
              "block would change what must stay as it is while it is on.",
              "Select the work coordinate system (G54 to G59, G52) before G41.1 or G42.1, and for "
              "high-accuracy control (G61.1) set melsec.system.per_axis_tolerable_acceleration to 1."},
    AlarmKind{kProgram, "0305H", "Incorrect address",
              "The letter is no address of this controller; lower-case letters are none, and a word cannot "
              "hold a variable definition.",
              "Write the address as a capital letter that `kerf codes --dialect melsec` lists, and set "
              "variables in a block of their own."},
    AlarmKind{kProgram, "0306H", "Format error",
              "The words of the block are known, but the form asks for something else or something more.",
              "Complete the block: an arc needs R or its centre with I, J, K, a function needs brackets, as "
              "in SIN[30.], and a comment needs a block of its own."},
    AlarmKind{
        kProgram, "0307H", "Incorrect G-code", "The controller has no such G code.",
        "Use a G code that `kerf codes --dialect melsec` lists; there are no fixed cycles, for example."},
    AlarmKind{kProgram, "0308H", "Command value over",
              "The number is smaller or larger than its address accepts.",
              "Correct the value, and check its decimal point: without one an X word counts in 0.0001 mm."},
    AlarmKind{kProgram, "0309H", "Program end error",
              "The program ran past its last block without M02 or M30, or its end was answered with FIN "
              "instead of a reset.",
              "End the main program with M02 or M30 and a subprogram with M99, and answer M02 and M30 with "
              "the reset command (Rq.3380)."},
    AlarmKind{kProgram, "030AH", "Helical operation disabled",
              "The arc block has a word for an axis outside of the selected plane, and the controller cuts "
              "no helix.",
              "Move that axis in a block of its own, or select the plane you mean with G17, G18 or G19."},
    AlarmKind{kProgram, "030DH", "No compensation number",
              "The compensation has no number yet, or its number is above 40.",
              "Write D with G41 and G42, H with G43 and G44, with a number from 1 to 40 whose amount stands "
              "in tools.N.radius or tools.N.length."},
    AlarmKind{kProgram, "030EH", "Calculation error",
              "The block wants axes in different units, mm and degrees, calculated together.",
              "Program the arc with axes of one unit, and turn the rotary axis in a block of its own."},
    AlarmKind{
        kProgram, "030FH", "G-code combination error",
        "Two G codes of the block cannot be executed in one block.",
        "Write the two G codes in blocks of their own, for example G04 in one block and G41 in the next."},
    AlarmKind{kProgram, "0310H", "Interpolation length over",
              "The path of the block is longer than the controller can count: 214748.3648 mm.",
              "Correct the end point or the radius, or divide the path among several blocks."},
    AlarmKind{kProgram, "0311H", "No F-command",
              "A cutting move (G01, G02, G03) needs a feed, and no F word was given yet.",
              "Give F in this block or before it, for example F300."},
    AlarmKind{kProgram, "0312H", "F-command value over",
              "The feed of F or ,F must be from 0.01 to 1000000 mm/min.",
              "Give a feed in mm/min within that range; axes.X.max_feed clamps it while cutting."},
    AlarmKind{kProgram, "0313H", "Arc radius difference over",
              "Start point, end point and centre or radius do not lie on one arc: the start and end radii "
              "differ too much, or R is too small to reach the end.",
              "Correct the end point, I, J, K or R; melsec.system.arc_deviation is the difference allowed."},
    AlarmKind{kProgram, "0314H", "Arc center calculation disabled",
              "No centre follows from the radius that R gives.",
              "Give R a value other than 0, or give the centre with I, J, K."},
    AlarmKind{
        kProgram, "0315H", "Tool radius compensation in arc modal",
        "Tool radius compensation can start and end in a straight move only, and G02 or G03 is in force.",
        "Write G01 or G00 with the G40, G41 or G42, as a straight lead-in or lead-out move."},
    AlarmKind{kProgram, "0316H", "Plane selection in tool radius compensation",
              "The plane cannot change while G41 or G42 is in force.",
              "Cancel with G40 and a straight move before G17, G18 or G19."},
    AlarmKind{kProgram, "0317H", "Plane selection error",
              "The selected plane does not have the two axes that the arc needs.",
              "Select the plane of the arc with G17, G18 or G19, and check melsec.system.base_axis_i, "
              "base_axis_j and base_axis_k."},
    AlarmKind{
        kProgram, "0318H", "Operation invalid",
        "The operation has no result for this value, like the square root of a negative number or TAN[90.].",
        "Keep the value within the range of the function, for example by testing it with IF before."},
    AlarmKind{kProgram, "0319H", "Zero ratio", "The expression divides by zero.",
              "Test the divisor with IF before the division or MOD, and check that its variable was set."},
    AlarmKind{kProgram, "031AH", "Decimal point command disabled", "This address takes an integer.",
              "Write the number without a decimal point; a dwell, for example, is P500 in milliseconds or "
              "X0.5 in seconds."},
    AlarmKind{kProgram, "031BH", "Normal line control axis error",
              "G41.1 and G42.1 have no axis to turn, because none is set.",
              "Set melsec.system.normal_line_axis to a rotary axis, for example C, or delete the G code."},
    AlarmKind{kProgram, "031CH", "Plane selection in normal line control",
              "The plane cannot change while normal line control is on.",
              "Select the plane before G41.1 or G42.1, or write G40.1 before G17, G18 or G19."},
    AlarmKind{kProgram, "031DH", "No intersection",
              "The offset paths of two neighbouring blocks do not meet, so tool radius compensation finds no "
              "corner.",
              "Use a smaller tool (tools.N.radius), change the contour at this corner, or review "
              "melsec.work.interference_check."},
    AlarmKind{
        kProgram, "031EH", "Compensation interference error",
        "The tool is too large for the contour: with tool radius compensation it would cut into a "
        "neighbouring block.",
        "Use a smaller tool (tools.N.radius) or a wider contour. With melsec.work.interference_check = "
        "\"avoid\" the controller goes round such places where it finds a way; with \"invalid\" it checks "
        "nothing."},
    AlarmKind{kProgram, "031FH", "No program No.",
              "There is no program with this number, or it was still being loaded at the cycle start.",
              "Correct the number, or store the program as O and three digits with the ending .gcd, for "
              "example O077.gcd."},
    AlarmKind{kProgram, "0320H", "No sequence No.",
              "The program has no block with the sequence number that is to be jumped to or started from.",
              "Write N and this number at the start of the block that is meant, or correct the number."},
    AlarmKind{kProgram, "0321H", "No block No.",
              "The program is shorter than the block number it is to start from.",
              "Give a start block number (Cd.3322) that the program has."},
    AlarmKind{kProgram, "0322H", "Incorrect G-code (polar coordinate interpolation)",
              "This G code cannot be used while polar coordinate interpolation is on.",
              "Write G13.1 before it, or move it in front of G12.1."},
    AlarmKind{
        kProgram, "0323H", "Incorrect axis command (polar coordinate interpolation)",
        "Polar coordinate interpolation moves its two axes and the one across their plane, and no other.",
        "Delete the word, or move that axis before G12.1 or after G13.1."},
    AlarmKind{kProgram, "0324H", "Incorrect modal (polar coordinate interpolation)",
              "Polar coordinate interpolation cannot be switched in this modal state, or automatic corner "
              "override is wanted while it runs with tool radius compensation.",
              "Cancel normal line control (G40.1), tool radius compensation (G40), coordinate rotation (G69) "
              "and G62 before, and for G61.1 set melsec.system.per_axis_tolerable_acceleration to 1."},
    AlarmKind{
        kProgram, "0325H", "Polar coordinate interpolation axis error",
        "G12.1 has no axes to work with, because none are set.",
        "Set melsec.system.polar_linear_axis and melsec.system.polar_rotary_axis, for example to X and C."},
    AlarmKind{kProgram, "0326H", "Plane selection in coordinate rotation",
              "The plane cannot change while coordinates are rotated.",
              "Select the plane before G68, or write G69 before G17, G18 or G19."},
    AlarmKind{kProgram, "0327H", "Incremental value command after coordinate rotation",
              "The first move after G68 or G69 must say where to go in absolute coordinates, because the "
              "rotation has changed what the present position is.",
              "Write G90 in the first block with a move after G68 or G69."},
    AlarmKind{kProgram, "0328H", "Number of sub/macro program repetitions over",
              "L of M98 and G65 is from 0 to 9999.",
              "Write L0 to L9999, or call the program again in another block."},
    AlarmKind{kProgram, "0329H", "Sub/macro program depth over",
              "Programs may call each other to a depth of ten.",
              "Call the inner program from a shallower level, or write its blocks in place of the call; a "
              "program that calls itself must stop doing so."},
    AlarmKind{kProgram, "032AH", "No variable number",
              "There is no variable with this number: it was not allocated, or it is no positive integer.",
              "Use #1 to #33 with melsec.system.local_start_device set, or #100 upward within "
              "common_system_points and common_all_points of melsec.system."},
    AlarmKind{kProgram, "032BH", "No = in variable definition",
              "A block that begins with a variable must set it.",
              "Write an = behind the variable, for example #100 = 5."},
    AlarmKind{kProgram, "032CH", "Operation command/control command format error",
              "The block mixes a calculation or a branch or loop statement with other words.",
              "Write variables, IF and WHILE statements in blocks of their own, and the moves in others."},
    AlarmKind{kProgram, "032DH", "Bracket depth over", "Brackets may be nested five deep in a block.",
              "Put a part of the expression into a variable in a block before."},
    AlarmKind{kProgram, "032EH", "Bracket number unmatched", "The block has more [ than ], or more ] than [.",
              "Add the missing bracket, or delete the one too many."},
    AlarmKind{kProgram, "032FH", "IF depth over", "IF statements may be nested ten deep.",
              "Join conditions with AND and OR, or move inner IF statements into a subprogram."},
    AlarmKind{kProgram, "0330H", "IF statement unmatched",
              "An IF that spans several blocks has no ENDIF, or THEN, ELSE or ENDIF stands without an IF.",
              "Close each such IF with ENDIF in the same program, and write an IF in front of each THEN, "
              "ELSE and ENDIF."},
    AlarmKind{kProgram, "0331H", "IF statement error",
              "IF needs its condition in brackets and behind it THEN, ELSE or GOTO.",
              "Write it as in IF [#100 EQ 0] GOTO 20 or IF [#100 EQ 0] THEN #101 = 5."},
    AlarmKind{kProgram, "0332H", "WHILE statement error",
              "WHILE needs its condition in brackets, and the number behind DO must be from 1 to 127.",
              "Write it as in WHILE [#100 LT 3] DO1."},
    AlarmKind{kProgram, "0333H", "DO-END depth over", "Loops with DO and END may be nested 27 deep.",
              "Close inner loops before others open, or move them into a subprogram."},
    AlarmKind{kProgram, "0334H", "DO-END unmatched",
              "A DO has no END with the same number, or an END has no DO.",
              "Write END with the number of its DO behind the last block of the loop."},
    AlarmKind{kProgram, "0335H", "Macro call - depth over",
              "Macro programs may call each other with G65 to a depth of four, since there are local "
              "variables for no more.",
              "Call one of the programs with M98 instead, which opens no new set of local variables, or "
              "write its blocks in place of the call."},
    AlarmKind{kProgram, "0336H", "Macro argument - number of groups over",
              "A macro call with arguments of type II takes A, B, C and at most ten groups of I, J and K.",
              "Pass the further values in common variables, set before the call, for example #100 = 5."},

    AlarmKind{
        kOwn, "endless-loop", "Endless loop",
        "The program has jumped back, repeated and called so often that it counts as endless: a hundred "
        "million times, or ten million with moves or other actions between.",
        "Change a variable of the condition inside the loop, or correct the GOTO, so that the loop "
        "comes to an end."},
    AlarmKind{kOwn, "block-too-long", "Too many words in a block",
              "The block has more than the 128 words that kerf keeps of a block.",
              "Split the block into several."},
    AlarmKind{kOwn, "bad-character", "Character that is no word",
              "Outside of comments no block may hold this character.",
              "Delete the character, or put the remark into parentheses at the start of a block of its own."},
};
static_assert(kCatalogue.size() == 85 + 3);

}  // namespace

std::span<const AlarmKind> alarm_catalogue() {
  return kCatalogue;
}

const AlarmKind& alarm_kind(std::string_view detail) {
  return find_alarm(kCatalogue, detail);
}

}  // namespace kerf::melsec
