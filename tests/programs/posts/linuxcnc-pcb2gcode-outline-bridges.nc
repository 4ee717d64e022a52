( pcb2gcode 2.5.0 )
( Software-independent Gcode )
G94 ( Millimeters per minute feed rate. )
G21 ( Units == Millimeters. )
G90 ( Absolute coordinates. )
G64 P0.01000 ( set maximum deviation from commanded toolpath )
G01 F600.00000 ( Feedrate. )
M3 S12000 ( Spindle on clockwise. )
G04 P1.00000 ( Wait for spindle to get up to speed )
G00 X-1.00000 Y-1.00000 ( rapid move to begin. )
G01 Z-0.60000 F60.00000
G04 P0 ( dwell for no time -- G64 should not smooth over this point )
G01 F600.00000
X20.00000
G00 Z-0.30000
G01 X22.00000
G01 Z-0.60000 F60.00000
G01 F600.00000
X41.00000
Y31.00000
X-1.00000
Y-1.00000
G00 Z30.000 ( retract )
M5 ( Spindle off. )
G04 P1.000000
M9 ( Coolant off. )
M2 ( Program end. )
