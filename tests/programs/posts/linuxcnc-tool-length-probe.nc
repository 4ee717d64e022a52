( length of each tool on a plate at the machine's X-40 Y-40, 12.5 mm high )
#<_plate> = 12.5
#<fast> = 300
#<slow> = 40
o100 sub
  T#1 M6
  G49
  G53 G0 Z0
  G53 G0 X-40 Y-40
  G38.2 Z-90 F#<_fast_feed>
  G91 G0 Z2
  G38.2 Z-5 F[#<_fast_feed>/8]
  G90
  o110 if [#5070 EQ 0]
    (ABORT,tool %d#1 touched nothing)
  o110 endif
  #[200+#1] = [#5063-#<_plate>]
  G53 G0 Z0
o100 endsub

G21 G90 G17 G40 G49
#<_fast_feed> = #<fast>
o100 call [1]
o100 call [2]
T1 M6
G43.1 Z#201
G0 X0 Y0
M3 S3000
G0 Z20
G1 Z-1 F100
G1 X10 F300
G0 Z20
M5
M2
