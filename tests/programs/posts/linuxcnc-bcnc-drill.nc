(Created by bCNC)
(Block-name: Header)
M3
S12000
G4 P3
(Block-name: drill)
G0 Z3
G0 X10 Y10
G1 Z-1 F100
G0 Z3
(Block-name: Footer)
M5
G0 X0 Y0
M2
