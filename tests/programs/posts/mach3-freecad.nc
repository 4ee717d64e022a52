(as FreeCAD writes)
(Post Processor: mach3_mach4_post)
(begin preamble)
G17 G54 G40 G49 G80 G90
G21
(begin operation: Fixture)
G54
(begin operation: TC: 6 mm)
(TC: 6 mm)
(begin toolchange)
M5
M6 T1
G43 H1
M3 S8000
(begin operation: Pocket)
G0 Z6.000
G0 X15.000 Y15.000
G0 Z4.000
G1 Z-1.500 F120.000
G1 X25.000 Y15.000 F480.000
G2 X25.000 Y15.000 I-5.000 J0.000 K0.000 F480.000
G0 Z6.000
G98 G81 X40.000 Y20.000 Z-3.000 F100.000 R2.000
G80
(begin postamble)
M05
G17 G54 G90 G80 G40
M30
