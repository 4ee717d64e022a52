%
(Header)
(as gcodetools writes)
(header of the house)
M3
(Header end.)
G21 (All units in mm)

(Start cutting path id: path10)
(Change tool to Default tool)

G00 Z5.000000
G00 X14.285714 Y22.101010

G01 Z-1.000000 F100.0(Penetrate)
G02 X18.123456 Y25.654321 Z-1.000000 I3.900000 J-0.360000 F400.000000
G01 X30.500000 Y25.654321 Z-1.000000
G03 X33.036230 Y28.190551 Z-1.000000 I0.000000 J2.536230
G01 X14.285714 Y22.101010 Z-1.000000
G00 Z5.000000

(End cutting path id: path10)

(Footer)
M5
G00 X0.0000 Y0.0000
M2
(footer of the house)
(end)
%
