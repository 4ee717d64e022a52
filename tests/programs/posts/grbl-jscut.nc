; Work area:    Min X: -1.00 mm
; Material: pine
G21         ; Set units to mm
G90         ; Absolute positioning
G1 Z2.54 F2540      ; Move to clearance level

;
; Operation:    0
; Name:         
; Type:         Pocket
; Paths:        1
; Direction:    Conventional
; Cut Depth:    1.5
; Pass Depth:   1.5
; Plunge rate:  127
; Cut rate:     1016
;

; Path 0
; Rapid to initial position
G1 X12.7000 Y3.3000 F2540
G1 Z0.0000
; plunge
G1 Z-1.5000 F127
; cut
G1 X12.7000 Y9.1000 F1016
G1 X6.1000 Y9.1000
G1 X6.1000 Y3.3000
G1 X12.7000 Y3.3000
; Retract
G1 Z2.5400 F2540
M2
