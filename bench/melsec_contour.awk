# Writes MELSEC programs into `folder`: O006 goes along a wavy circle in four subprograms of 19,000 blocks of two axes
# with four decimals, thirteen times; O007 does the same with tool radius compensation on its outside.
BEGIN {
  turns = 30
  for (number = 2; number <= 5; ++number) {
    name = sprintf("%s/O%03d.gcd", folder, number)
    print "%" >name
    for (i = 1; i <= 19000; ++i) {
      t = ((number - 2) * 19000 + i) / 76000 * turns * 2 * atan2(0, -1)
      radius = 40 + 2 * sin(9 * t)
      printf "X%.4fY%.4f\n", radius * cos(t), radius * sin(t) >name
    }
    print "M99\n%" >name
    close(name)
  }
  for (number = 6; number <= 7; ++number) {
    name = sprintf("%s/O%03d.gcd", folder, number)
    print "%\nG90G17G54\nG00X40.Y-10.\nG01F3000." >name
    print (number == 7 ? "G42D01X40.Y0." : "X40.Y0.") >name
    print "WHILE [#100 LT 13] DO1\nM98P2\nM98P3\nM98P4\nM98P5\n#100=#100+1\nEND1" >name
    print (number == 7 ? "G40X40.Y10." : "X40.Y10.") "\nM02\n%" >name
    close(name)
  }
}
