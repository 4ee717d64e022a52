(Filename: PANEL)
(Post processor: Mach3 router.scpost)
(Date: 12/02/2026)
G21 (Units: Metric)
G53 G90 G91.1 G40
F1
S500
(Part: Panel)
(Operation: Outside Offset, 0, T6: Drill, 3 mm Deep)
M06 T6  (End mill, 6mm diameter)
G43 H6
M03 S12000
G00 Z5.0000
X22.0000 Y27.5000
Z0.5000
G01 Z-3.0000 F300.0
G03 X25.0000 Y24.5000 I3.0000 J0.0000 F1200.0
G01 X75.0000
Y74.5000
X22.0000
Y27.5000
G00 Z5.0000
M05 M30
