(AS FLATCAM WRITES)

(Name: board_iso_combined_cnc)
(Type: G-code from Geometry)
(Units: MM)

(Created on Saturday, 14 February 2026 at 11:02)

(TOOL DIAMETER: 0.1 mm)
(Feedrate_XY: 120.0 mm/min)
(Z_Cut: -0.05 mm)
(Preprocessor Geometry: default)

(X range:    1.9000 ...   21.4000  mm)
(Spindle Speed: 12000 RPM)

G21
G90
G94


G01 F120.00


M5             
G00 Z15.0000
G00 X0.0000 Y0.0000                
T1
M6    
(MSG, Change to Tool Dia = 0.1000)
M0
G00 Z15.0000
        
M03 S12000
G01 F120.00
G00 X1.9000 Y3.1000
G01 F60.00
G01 Z-0.0500
G01 F120.00
G01 X2.4000 Y3.6000
G01 X2.4000 Y9.8000
G01 X21.4000 Y9.8000
G01 X1.9000 Y3.1000
G00 Z2.0000
M05
G00 Z2.0000
G00 Z15.00
G00 X0.0 Y0.0
M2
