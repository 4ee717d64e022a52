( as pcb2gcode writes )
( plain G-code )

( two drills )
G94 (Millimeters per minute feed rate.)
G21 (Units == Millimeters.)

G90 (Absolute coordinates.)
G00 S20000 (RPM spindle speed.)
G64 P0.01000 (set maximum deviation from commanded toolpath)
G01 F240.00000 (Feedrate.)

G00 Z12.00000 (Retract to tool change height)
T0
M5 (Spindle stop.)
G04 P1.00000 (Wait for spindle to stop)
(MSG, Change tool bit to cutter diameter 0.20000mm)
M6 (Tool change.)
M0 (Temporary machine stop.)
M3 (Spindle on clockwise.)
G04 P1.00000 (Wait for spindle to get up to speed)
G00 Z2.00000 ( retract )
G00 X3.41000 Y7.72000 ( rapid move to begin. )
G01 Z-0.06000 F120.00000 ( plunge. )
G04 P0 ( no blend here )
G01 X3.62000 Y7.90000 F240.00000
G01 X5.10000 Y7.90000
G01 X5.32000 Y8.05000
G01 X5.32000 Y11.40000
G01 X3.41000 Y11.40000
G01 X3.41000 Y7.72000
G04 P0 ( no blend here )
G00 Z2.000 ( retract )
G00 Z35.00000 ( retract )
M5 (Spindle off.)
G04 P1.00000
M9 (Coolant off.)
M2 (Program end.)
