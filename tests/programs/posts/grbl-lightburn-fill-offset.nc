; LightBurn 1.4.00
; GRBL device profile, absolute coords
; Bounds: X10 Y10 to X30 Y12
G00 G17 G40 G21 G54
G90
M4
; Scan @ 3000 mm/min, 40% power
M8
G0 X9.5Y10
; Layer C00
M4
G1 X10S0F3000
X20S400
X30S0
X30.5
G0 Y10.1
G1 X30S0
X10S400
M9
G1 S0
M5
G90
; return to user-defined finish pos
G0 X0 Y0
M2
