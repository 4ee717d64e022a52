"""A part program as motion: its path by speed, and each axis over time beside its limits."""

import numpy as np
from matplotlib.collections import LineCollection
from picture import BLUE, ORANGE, PROGRAMS, plt, save

import leadscrew

result = leadscrew.run(PROGRAMS / "09-butterfly.ngc")
print(f"{result.time_s:.3f} s for {result.length_mm:.1f} mm, no farther than {result.deviation_mm * 1e3:.3f} µm from the program")

words = result.words
places = words["position"][:, :2]
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.2), gridspec_kw={"width_ratios": [1, 1.25]})

path = LineCollection(np.stack([places[:-1], places[1:]], axis=1), array=words["feed"][1:], cmap="viridis", linewidth=2)
left.add_collection(path)
left.autoscale()
path.set_clim(0, 100)  # the feed of the curve; the rapid to it is faster
left.set(aspect="equal", title="Path by feed", xlabel="X, mm", ylabel="Y, mm")
figure.colorbar(path, ax=left, label="mm/s", shrink=0.7, extend="max")

for order, name in enumerate(["velocity", "acceleration", "jerk"], start=1):
    ratio = np.abs(result.derivative(order)) / getattr(result.machine, name)
    offset = 3 - order
    for column, color in ((0, BLUE), (1, ORANGE)):
        right.plot(result.time, offset * 1.2 + ratio[:, column], color=color, linewidth=0.7,
                   label="XY"[column] if order == 1 else None)
    right.axhline(offset * 1.2 + 1, color="black", linewidth=0.6, linestyle=":")
    right.text(result.time[-1], offset * 1.2 + 1.02, f"limit of {name}", ha="right", va="bottom", fontsize=8)
right.set(title="Each axis over its limit", xlabel="s", ylim=(-0.1, 3.85), yticks=[0, 1, 1.2, 2.2, 2.4, 3.4], yticklabels=["0", "1"] * 3)
right.legend(loc="upper center", ncols=2)
save(figure, __file__)
