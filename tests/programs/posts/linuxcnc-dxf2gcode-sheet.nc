(as dxf2gcode writes)
(Created from file: sheet.dxf)
(Time: Mon Jan 12 09:31:20 2026)
G21 (Unit in mm)
G90 (Absolute distance mode)
G64 P0.01 (Exact Path 0.001 tol.)
G17
G40
G49
(* LAYER: cut *)
T1 M6
S6000

(* SHAPE Nr: 0 *)
G0 X  0.000 Y -5.000
M3 M8
G0 Z  3.000
F150
G1 Z -1.500
F400
G1 X  0.000 Y  0.000
G1 X 40.000 Y  0.000
G3 X 45.000 Y  5.000 I  0.000 J  5.000
G1 X 45.000 Y 25.000
G1 X  0.000 Y 25.000
G1 X  0.000 Y  0.000
F150
G1 Z  3.000
G0 Z 15.000
M9 M5

G0 X0.000 Y0.000
M2 (Program end)
