;Fusion 360 CAM
; Posts processor: MPCNC.cps
; Tool : T1 flat end mill D=3.175
G90
G21
M84 S0
G92 X0 Y0 Z0
M117 Starting operation
G0 Z15 F300
M0 Attach spindle and press the button
M3 S12000
G4 P2000
; Operation : 2D Pocket2
G0 X12.4 Y8.1 F2500
G0 Z5 F300
G1 Z-0.5 F100
G1 X22.4 F600
G2 X24.4 Y10.1 I0 J2 F600
G1 Y20
G1 X12.4
G1 Y8.1
G0 Z15 F300
M400
M5
G0 X0 Y0 F2500
M117 Job end
M300 S440 P200
