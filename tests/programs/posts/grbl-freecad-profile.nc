(as FreeCAD writes)
(Post Processor: grbl_post)
(Output Time:2026-02-20 16:40:00.010203)
(Begin preamble)
G17 G90
G21
(Begin operation: TC: 3 mm Endmill)
(Path: TC: 3 mm Endmill)
(TC: 3 mm Endmill)
(Begin toolchange)
( M6 T1 )
M3 S10000
(Finish operation: TC: 3 mm Endmill)
(Begin operation: Profile)
(Path: Profile)
G0 Z5.000 
G0 X-1.500 Y5.000 
G0 Z3.000 
G1 Z-1.000 F100.000 
G1 Y15.000 F300.000
G2 X0.000 Y16.500 I1.500 J0.000 K0.000 F300.000
G1 X20.000 
G0 Z5.000 
(Finish operation: Profile)
(Begin postamble)
M5
G17 G90
M2
