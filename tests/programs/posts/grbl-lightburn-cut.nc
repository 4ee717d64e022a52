; as LightBurn writes
; GRBL device profile, absolute coords
; Bounds: X10 Y12 to X60 Y44
G00 G17 G40 G21 G54
G90
M4
; Cut @ 900 mm/min, 65% power
M8
G0 X10Y12
; Layer C00
G1 X60S650F900
G1 Y44
G1 X10
G1 Y12
M9
G1 S0
M5
G90
; return to user-defined finish pos
G0 X0 Y0
M2
