; as PrusaSlicer writes

; external perimeters extrusion width = 0.45mm
M73 P0 R12
M201 X1000 Y1000 Z200 E5000 ; sets maximum accelerations, mm/sec^2
M203 X200 Y200 Z12 E120 ; sets maximum feedrates, mm / sec
M204 P1250 R1250 T1250 ; sets acceleration (P, T) and retract acceleration (R), mm/sec^2
M205 X8.00 Y8.00 Z0.40 E4.50 ; sets the jerk limits, mm/sec
M205 S0 T0 ; sets the minimum extruding and travel feed rate, mm/sec
M107
;TYPE:Custom
G90 ; use absolute coordinates
M83 ; extruder relative mode
M104 S215 ; set extruder temp
M140 S60 ; set bed temp
M190 S60 ; wait for bed temp
M109 S215 ; wait for extruder temp
G28 W ; home all without mesh bed level
G29 ; mesh bed leveling
G92 E0
G21 ; set units to millimeters
G90 ; use absolute coordinates
M83 ; use relative distances for extrusion
;LAYER_CHANGE
;Z:0.2
;HEIGHT:0.2
G1 Z.2 F9000
G1 X50.5 Y50.5
G1 E.8 F2100
;TYPE:Perimeter
G1 F1200
G1 X70.5 Y50.5 E.6272
G1 X70.5 Y70.5 E.6272
G1 X50.5 Y70.5 E.6272
G1 X50.5 Y50.5 E.6272
G1 E-.8 F2100
M106 S255
G1 Z.6 F9000
M107
M104 S0 ; turn off temperature
M140 S0
G1 X0 Y200 F3000
M84 ; disable motors
M73 P100 R0
; filament used [mm] = 2.51
