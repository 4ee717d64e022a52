( centre of a bore, by four touches; a point on the surface for each of a grid )
G21 G90 G17 G94 G54
#<reach> = 20
#<feed> = 120
G0 X0 Y0
G0 Z-6
G38.2 X#<reach> F#<feed>
#101 = #5061
G0 X0
G38.2 X[0-#<reach>] F#<feed>
#102 = #5061
G0 X0
G38.2 Y#<reach> F#<feed>
#103 = #5062
G0 Y0
G38.2 Y[0-#<reach>] F#<feed>
#104 = #5062
G0 X[[#101+#102]/2] Y[[#103+#104]/2]
G10 L20 P1 X0 Y0
G0 Z10
(PROBEOPEN grid.txt)
#1 = 0
o200 while [#1 LT 3]
  #2 = 0
  o210 while [#2 LT 3]
    G0 X[#1*10] Y[#2*10]
    G38.3 Z-10 F#<feed>
    o220 if [#5070 EQ 1]
      (DEBUG,surface at %.3f#5063)
    o220 endif
    G0 Z10
    #2 = [#2+1]
  o210 endwhile
  #1 = [#1+1]
o200 endwhile
(PROBECLOSE)
M2
