;FLAVOR:Marlin
;TIME:431
;Filament used: 0.12m
;Layer height: 0.2
;MINX:80
;as Cura writes
M140 S50
M105
M190 S50
M104 S200
M105
M109 S200
M82 ;absolute extrusion mode
; start of a bed printer
G92 E0 ; Reset Extruder
G28 ; Home all axes
G1 Z2.0 F3000 ; lift the nozzle off the bed
G1 X0.1 Y20 Z0.3 F5000.0 ; Move to start position
G1 X0.1 Y200.0 Z0.3 F1500.0 E15 ; Draw the first line
G1 X0.4 Y200.0 Z0.3 F5000.0 ; Move to side a little
G1 X0.4 Y20 Z0.3 F1500.0 E30 ; Draw the second line
G92 E0 ; Reset Extruder
G1 F2700 E-5
;LAYER_COUNT:2
;LAYER:0
M107
G0 F6000 X101.2 Y98.7 Z0.2
;TYPE:WALL-INNER
G1 F2700 E0
G1 F1200 X110.2 Y98.7 E0.29
G1 X110.2 Y108.7 E0.62
G0 F6000 X112 Y110
M106 S85
;LAYER:1
G0 Z0.4
G1 X101.2 E0.9
;TIME_ELAPSED:30.1
M140 S0
G91 ;Relative positioning
G1 E-2 F2700 ;Retract a bit
G1 E-2 Z0.2 F2400 ;Retract and raise Z
G90 ;Absolute positioning
G1 X0 Y220 ;Present print
M106 S0 ;Turn-off fan
M104 S0 ;Turn-off hotend
M84 X Y E ;Disable all steppers but Z
M82 ;absolute extrusion mode
M104 S0
;End of Gcode
