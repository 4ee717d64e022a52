%
; tool 1 is a 3 mm end mill
G21 G90 G64 P0.05
#<depth> = -1.5
#<safe> = 4
#<n> = 4

o<square> sub
  G0 X#1 Y#2
  G1 Z#<_depth> F150
  G1 X[#1 + #3] F500
  G1 Y[#2 + #3]
  G1 X#1
  G1 Y#2
  G0 Z4
o<square> endsub

#<_depth> = #<depth>
T1 M6
M3 S8000
G0 Z#<safe>
#<i> = 0
o100 while [#<i> lt #<n>]
  o<square> call [#<i> * 15] [5] [10]
  #<i> = [#<i> + 1]
o100 endwhile
o200 if [#<n> gt 2]
  G0 X0 Y0
o200 else
  G0 X5 Y5
o200 endif
o300 repeat [3]
  G91 G1 X1 F200
o300 endrepeat
G90
M5
M2
%
