(as FreeCAD writes)
(Post Processor: linuxcnc_post)
(Output Time:2026-03-02 10:14:31.120455)
(begin preamble)
G17 G54 G40 G49 G80 G90
G21
(begin operation: Fixture)
(machine units: mm/min)
G54
(finish operation: Fixture)
(begin operation: TC: 6mm end mill)
(machine units: mm/min)
(TC: 6mm end mill)
(begin toolchange)
M5
M6 T1
G43 H1
M3 S9000
(finish operation: TC: 6mm end mill)
(begin operation: Profile)
(machine units: mm/min)
(Profile)
(Compensated Tool Path. Diameter: 6.0)
G0 Z8.000
G0 X-3.000 Y12.000
G0 Z6.000
G1 X-3.000 Y12.000 Z-2.000 F200.000
G1 X-3.000 Y40.000 Z-2.000 F600.000
G2 X0.000 Y43.000 Z-2.000 I3.000 J0.000 F600.000
G1 X60.000 Y43.000 Z-2.000
G2 X63.000 Y40.000 Z-2.000 I0.000 J-3.000
G1 X63.000 Y0.000 Z-2.000
G2 X60.000 Y-3.000 Z-2.000 I-3.000 J0.000
G1 X0.000 Y-3.000 Z-2.000
G2 X-3.000 Y0.000 Z-2.000 I0.000 J3.000
G1 X-3.000 Y12.000 Z-2.000
G0 Z8.000
(finish operation: Profile)
(begin postamble)
M05
G17 G54 G90 G80 G40
M2
