// Half a leaf along X, from the root to the tip.
G90 G00 X10 Y0
Z2
G01 Z-1 F300
G03 X40 Y0 R25 F1200
G00 Z2
M99
