"""Interpolators of reference pulses on one arc: the steps that each takes, and how far they are off the circle."""

import numpy as np
from picture import BLUE, GREEN, GREY, ORANGE, RED, plt, save

import leadscrew

figure = plt.figure(figsize=(9, 4.4))
grid = figure.add_gridspec(4, 2, width_ratios=[1, 1.2])
left = figure.add_subplot(grid[:, 0])
angles = np.linspace(0, np.pi / 2, 200)
left.plot(12 * np.cos(angles), 12 * np.sin(angles), color=GREY, linewidth=4, alpha=0.4)
for row, (method, color) in enumerate((("point-comparison", BLUE), ("dda", ORANGE), ("min-error", GREEN), ("koren", RED))):
    small = leadscrew.pulse_arc((12, 0), (0, 12), method=method)
    places = np.vstack([[12, 0], small.places]) + 0.06 * row  # beside one another
    left.plot(*places.T, "o-", color=color, markersize=2.5, linewidth=1, label=method)

    pulses = leadscrew.pulse_arc((60, 0), (0, 60), method=method)
    errors = np.hypot(*pulses.places.T) - 60
    right = figure.add_subplot(grid[row, 1])
    right.plot(np.degrees(np.arctan2(pulses.column("Y"), pulses.column("X"))), errors, color=color, linewidth=0.8)
    right.set(ylim=(-1.4, 1.4), yticks=[-1, 0, 1], xticks=range(0, 91, 15), ylabel="BLU")
    right.text(0, 0.82, f" {method}: {pulses.figures['max_error']:.2f} at most", transform=right.transAxes, fontsize=8)
    if row == 0:
        right.set_title("Distance from a circle of radius 60")
    if row < 3:
        right.tick_params(labelbottom=False)
    print(f"{method}: {pulses.figures['clocks']} clocks, {pulses.figures['pulses']} with a pulse, "
          f"{pulses.figures['max_error']:.2f} BLU off at most")
right.set_xlabel("degrees")
left.set(aspect="equal", title="A radius of 12", xlabel="X, BLU", ylabel="Y, BLU")
left.legend(loc="lower left", fontsize=8)
save(figure, __file__)
