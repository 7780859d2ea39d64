# Writes a program of `blocks` linear blocks of three axes with four decimals, with every coordinate changing in every
# block, that kerf (as DGSHAPE) and LinuxCNC both read.
BEGIN {
  print "%"
  print "G21G90G17G54"
  print "S8000M03"
  print "G00X50.0Y50.0Z0"
  print "G01F3000.0"
  for (i = 0; i < blocks; ++i) {
    t = i * 0.001
    printf "X%.4fY%.4fZ%.4f\n", 50 + 40 * sin(t), 50 + 40 * cos(1.3 * t), -5 + 4 * sin(7 * t)
  }
  print "M05"
  print "M02"
  print "%"
}
