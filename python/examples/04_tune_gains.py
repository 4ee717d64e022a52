"""Simulated loops: how far slides leave the path at each position gain, with and without feed-forward."""

import numpy as np
from picture import BLUE, GREEN, ORANGE, RED, plt, save

import leadscrew

PROGRAM = "G21 G90 G94 G64 P0.005\nG1 X30 F6000\nG2 X60 Y30 I0 J30\nG1 Y60\nX0\nY0\nM2\n"
machine = leadscrew.Machine.mill3()
gains = np.geomspace(10, 200, 9)

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
for forward, color in ((0, BLUE), (0.9, ORANGE), (1, GREEN)):
    errors = []
    for gain in gains:
        tuned = machine.with_loops(controller="cascade", position_gain=gain, velocity_forward=forward,
                                   acceleration_forward=forward)
        simulation = leadscrew.simulate(PROGRAM, machine=tuned)
        errors.append(simulation.contour["max_mm"] * 1e3)
        if gain in (gains[2], gains[-1]) and forward == 0:
            actual = simulation.rows["actual"]
            right.plot(actual[:, 0], actual[:, 1], color=RED if gain == gains[2] else BLUE, label=f"Kv = {gain:.0f} 1/s")
            asked = simulation.rows["position"]
    left.loglog(gains, errors, "o-", color=color, markersize=3, label=f"{forward:.0%} fed forward")
    print(f"{forward:.0%} fed forward: {min(errors):.2f} µm at best, Kv = {gains[int(np.argmin(errors))]:.0f} 1/s")
left.axhline(machine.tolerance * 1e3, color="black", linewidth=0.6, linestyle=":")
left.text(gains[0], machine.tolerance * 1e3 * 1.08, "tolerance", fontsize=8)
left.set(title="Greatest distance from the path", xlabel="position gain Kv, 1/s", ylabel="µm")
left.legend()
right.plot(asked[:, 0], asked[:, 1], color="black", linewidth=0.7, label="words")
right.set(aspect="equal", title="The corner at X60 Y60, nothing fed forward", xlabel="X, mm", ylabel="Y, mm",
          xlim=(58.6, 60.3), ylim=(58.6, 60.3))
right.legend(loc="lower left")
save(figure, __file__)
