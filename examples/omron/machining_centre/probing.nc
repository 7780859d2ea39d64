// Finds the corner of a part with the touch probe and engraves a frame beside its edges.
// machine.toml says where the simulated part stands.
G17 G21 G64 G90 F1500
L10=50 L11=3             // length of the probe, radius of its ball, mm
G53 Z0
G00 X120 Y100

// top: the end of the probe
G00 Z-40
G31 Z-80
L2=_CNC_CapturedPosition(2)-L10
G91 G00 Z5
G90

// left side, 8 mm below the top
L5=L2+L10-8
G00 X80
Z[L5]
G31 X110
L0=_CNC_CapturedPosition(0)+L11
G00 X80
G53 Z0

// front
G00 X120 Y60
Z[L5]
G31 Y90
L1=_CNC_CapturedPosition(1)+L11
G00 Y60
G53 Z0

M101 VA[L0] VB[L1] VC[L2]  // for the sequence program

// the corner found is zero from here on
G52 X[L0] Y[L1] Z[L2]
M100 VA1
S6000 M03
G43 G00 X5 Y5
Z3
G01 Z-0.5 F300
X65 F1500
Y45
X5
Y5
G00 Z3
G49
M05
G52
G53 Z0
M30
