(touch plate, then a row of points in the digitize log)
G21 G90 G17 G40 G49 G80
#101 = 19.05 (plate)
F120
G31 Z-50
#102 = #2002
G0 Z[#102+2]
F30
G31 Z-50
G92 Z#101
G0 Z30
G31 X30 F200
#103 = #2000
G0 X[#103-5]
G92.1
M30
