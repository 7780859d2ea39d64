// A lattice of crosses, made with loops and variables: P0 columns, P1 rows, P2 mm apart.
G17 G21 G64 G90
P0=6 P1=4 P2=15
L0=3            // half the length of an arm, mm
G00 X0 Y0 Z5
S8000 M03
L2=0
while(L2<P1){
  L1=0
  while(L1<P0){
    // every other row runs back, so that the ways between stay short
    if (L2%2==0) L3=L1*P2 else L3=(P0-1-L1)*P2
    L4=L2*P2
    L5=L3-L0 L6=L3+L0 L7=L4-L0 L8=L4+L0
    G00 X[L5] Y[L4]
    G01 Z-0.5 F200
    X[L6] F800
    G00 Z2
    X[L3] Y[L7]
    G01 Z-0.5 F200
    Y[L8] F800
    G00 Z2
    L1=L1+1
  }
  L2=L2+1
}
G00 Z5
M05
G28 X0 Y0
M30
