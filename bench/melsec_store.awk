# Writes a store of MELSEC programs into `folder`: O001 calls four subprograms of 19,000 blocks of three axes with four
# decimals, which is what the controller's 2 MB hold, thirteen times.
BEGIN {
  for (number = 2; number <= 5; ++number) {
    name = sprintf("%s/O%03d.gcd", folder, number)
    print "%" >name
    for (i = 0; i < 19000; ++i) {
      t = ((number - 2) * 19000 + i) * 0.001
      printf "X%.4fY%.4fZ%.4f\n", 50 + 40 * sin(t), 50 + 40 * cos(1.3 * t), -5 + 4 * sin(7 * t) >name
    }
    print "M99\n%" >name
    close(name)
  }
  name = folder "/O001.gcd"
  print "%\nG90G17G54\nM03\nG00X50.Y50.Z0.\nG01F3000." >name
  print "WHILE [#100 LT 13] DO1\nM98P2\nM98P3\nM98P4\nM98P5\n#100=#100+1\nEND1\nM05\nM02\n%" >name
}
