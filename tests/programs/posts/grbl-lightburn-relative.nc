; as LightBurn writes
; GRBL-M3 device profile, current position
; Bounds: X0 Y0 to X20 Y10
G00 G17 G40 G21 G54
G91
M3
; Scan @ 3000 mm/min, 20% power
M8
G0X0Y0
G91
; Layer C01
G1X2.5F3000S0
G1X15S200
G1X2.5S0
G0Y.1
G1X-2.5S0
G1X-15S180
G1X-2.5S0
M9
G1S0
M5
G90
M2
