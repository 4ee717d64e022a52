"""From state to state and through waypoints, as fast as velocity, acceleration and jerk of each axis allow, with no program."""

import numpy as np
from picture import BLUE, GREEN, ORANGE, plt, save

import leadscrew

machine = leadscrew.Machine.mill3().changed(velocity=[200, 200, 100], acceleration=[1500, 1500, 1000], jerk=[20000, 20000, 15000])
points = [[0, 0, 0], [60, 20, 5], [80, 70, 10], [20, 80, 10], [0, 40, 0]]

stopping = leadscrew.waypoints(points, stops=True, machine=machine).plan()
smooth = leadscrew.waypoints(points, tolerance=2, machine=machine).plan()
print(f"with a stop at each {stopping.duration:.3f} s, within 2 mm of them {smooth.duration:.3f} s")

figure = plt.figure(figsize=(9, 4.6))
grid = figure.add_gridspec(4, 2, width_ratios=[1, 1.5])
path = figure.add_subplot(grid[:, 0])
for planned, color, label in ((stopping, BLUE, "a stop at each"), (smooth, ORANGE, "within 2 mm")):
    states = planned.at(np.linspace(0, planned.duration, 1000))
    path.plot(states["position"][:, 0], states["position"][:, 1], color=color, label=label)
path.plot(*np.array(points)[:, :2].T, "o", color="black", markersize=3)
path.set(aspect="equal", title="Path", xlabel="X, mm", ylabel="Y, mm")
path.legend(loc="center")

times = np.linspace(0, smooth.duration, 2000)
states = smooth.at(times)
for row, (name, unit) in enumerate((("position", "mm"), ("velocity", "mm/s"), ("acceleration", "mm/s²"), ("jerk", "mm/s³"))):
    axes = figure.add_subplot(grid[row, 1])
    for column, color in ((0, BLUE), (1, ORANGE), (2, GREEN)):
        axes.plot(times, states[name][:, column], color=color, linewidth=0.9, label="XYZ"[column])
    if row > 0:
        for side in (-1, 1):
            axes.axhline(side * getattr(machine, name)[0], color="black", linewidth=0.6, linestyle=":")
    axes.set_ylabel(f"{name}\n{unit}", fontsize=8)
    if row < 3:
        axes.tick_params(labelbottom=False)
    if row == 0:
        axes.set_title("Within 2 mm; dotted: limits of X and Y")
        axes.legend(ncols=3, fontsize=8, loc="upper right")
axes.set_xlabel("s")
figure.align_ylabels()
save(figure, __file__)
