"""A surface from an array of points: its curvature, passes of a ball over it, and the program that machines it."""

import numpy as np
from picture import BLUE, ORANGE, TREE, plt, save

import leadscrew

x, y = np.meshgrid(np.linspace(0, 60, 7), np.linspace(0, 40, 6), indexing="ij")
surface = leadscrew.Surface(np.stack([x, y, 6 * np.sin(x / 18) * np.cos(y / 20) - 8], axis=2))
u, v = np.meshgrid(np.linspace(0, 1, 121), np.linspace(0, 1, 81), indexing="ij")
found = surface.evaluate(u, v)
greatest = np.abs(found["curvature"]).max(axis=2)
print(f"sharpest radius {1 / greatest.max():.1f} mm")

passes = surface.passes(radius=5, scallop=0.02)
tips = np.concatenate([each["tip"] for each in passes])
print(f"{sum(not each['is_link'] for each in passes)} passes, ridges of 20 µm")

# The same as one block, by the machine's own reader: it makes the passes while it moves.
program = "G21 G90 G94\nT4 M6\n" + surface.blocks(1) + "G0 Z20\nG6.5 D1 H0.02 Z20 F3000\nG0 Z20\nM2\n"
result = leadscrew.run(program, tools=TREE / "examples" / "tools.tbl")
print(f"{result.time_s:.1f} s at 50 mm/s, at least {result.bound_s:.1f} s")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
filled = left.contourf(found["position"][..., 0], found["position"][..., 1], greatest, 12, cmap="viridis")
figure.colorbar(filled, ax=left, label="1/mm", shrink=0.85)
left.grid(False)
left.set(aspect="equal", title="Greatest curvature", xlabel="X, mm", ylabel="Y, mm")
for each in passes:
    right.plot(each["tip"][:, 0], each["tip"][:, 1], color=ORANGE if each["is_link"] else BLUE, linewidth=0.7)
right.set(aspect="equal", title="Tip of a ball of radius 5 mm; links orange", xlabel="X, mm", ylabel="Y, mm")
save(figure, __file__)
