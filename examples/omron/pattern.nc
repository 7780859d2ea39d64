// A leaf, mirrored and turned: subprogram 1000 draws it, this program places it.
G17 G21 G64 G90 F1200
G00 X0 Y0 Z5
S8000 M03
L0=0
while(L0<360){
  G68 X0 Y0 R[L0]
  M98 P1000
  G51.1 Y0
  M98 P1000
  G50.1
  L0=L0+60
}
G69
G00 X0 Y0 Z5
M05
M30
