// A plate with right-handed threads in rows and on a circle, and a left-handed one in the middle.
// The tap turns with Z: F / S = 1 mm, the pitch of M6.
P0=3 P1=4 P2=20          // rows, threads in a row, distance
G17 G21 G64 G54
M100 VA2
S400 F400
G90 G43 G00 X-20 Y0
Z10
L0=0
while(L0<P0){
  // R and Z count from where the tool stands; G99 stays at R between the threads
  G91 G99 G84 X[P2] Y0 Z-15 R-8 P200 K[P1]
  G80
  G90
  L1=(L0+1)*P2
  G00 Z10
  X-20 Y[L1]
  L0=L0+1
}

// six on a circle around X30 Y90; G98 clears the hub
G00 Z25
L2=0
while(L2<360){
  L3=30+22*cosd(L2) L4=90+22*sind(L2)
  G98 G84 X[L3] Y[L4] Z-12 R2 P200
  G80
  L2=L2+60
}

M100 VA3
G43
G98 G74 X30 Y90 Z-2 R12 P200
G80
G49
G53 Z0
M30
