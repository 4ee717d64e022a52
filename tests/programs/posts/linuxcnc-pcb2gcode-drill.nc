( as pcb2gcode writes )
( two drills )
( Bit sizes: [0.8mm] [1mm] )

G94       (Millimeters per minute feed rate.)
G21       (Units == Millimeters.)
G91.1     (Incremental arc distance mode.)
G90       (Absolute coordinates.)
G00 S18000     (RPM spindle speed.)

G00 Z30.00000 (Retract)
T1
M5      (Spindle stop.)
G04 P1.00000
(MSG, Change tool bit to drill size 0.8mm)
M6      (Tool change.)
M0      (Temporary machine stop.)
M3      (Spindle on clockwise.)
G0 Z2.00000
G04 P1.00000

G81 R2.00000 Z-2.00000 F120.00000 X4.06400 Y3.55600
X4.06400 Y6.09600
X4.06400 Y8.63600
X11.68400 Y8.63600

G00 Z30.00000 (Retract)
T2
M5      (Spindle stop.)
(MSG, Change tool bit to drill size 1mm)
M6
M0
M3
G0 Z2.00000
G81 R2.00000 Z-2.00000 F120.00000 X20.32000 Y3.55600
X22.86000 Y3.55600
G80
G00 Z30.000 ( All done -- retract )

M5      (Spindle off.)
G04 P1.00000
M9
M2
