%
o1500
(bobcad-cam)
n10 g0 g17 g40 g49 g80 g90
n20 g20
n30 t1 m6
n40 g0 g54 x.5 y.5 s4000 m3
n50 g43 h1 z1. m8
n60 z.1
n70 g1 z-.2 f15.
n80 g1 x1.5 f30.
n90 g3 x1.5 y1. i0. j.25
n100 g0 z1.
n110 m9
n120 m5
n130 g28 g91 z0.
n140 g90
n150 m30
%
