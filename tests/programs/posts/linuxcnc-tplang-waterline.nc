(DynPath waterline)
G0 G21 G17 G90 G40 G49 G80
G64 P.02 Q.01
T12 M6
G43 H12
G54
M3 S18000
M8
g0 x1.5 y-.25
z5.
g1 z0 f500
x1.7 y-.2 z-.01
x1.9 y-.1 z-.02
x2.1 y.1 z-.03
x2.3 y.4 z-.05
x2.4 y.8 z-.08
g0 z5.
m9
m5
g49
m30
