(tool setter at the corner of the table, 19.3 mm high)
G21 G90 G94
G53 G0 Z-5
G53 G0 X-3 Y-3
M0 (clip on)
G38.2 Z-80 F150
G91
G0 Z2
G38.2 Z-5 F25
G10 L20 P1 Z19.3
G0 Z5
G90
M0 (clip off)
G0 X0 Y0
M3 S10000
G1 Z-0.5 F100
G1 X20 F400
M5
M30
