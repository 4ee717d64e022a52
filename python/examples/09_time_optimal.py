"""The least time along a given curve: speed in the phase plane below what axes allow, with and without a limit of jerk."""

import numpy as np
from picture import BLUE, GREY, ORANGE, plt, save

import leadscrew

rng = np.random.default_rng(3)
points = np.cumsum(rng.uniform(-40, 40, (8, 3)), axis=0)
points -= points[0]
machine = leadscrew.Machine.mill3().changed(velocity=[200] * 3, acceleration=[1500] * 3, jerk=[40000] * 3, travel=[[-400, 400]] * 3)
loose = machine.changed(jerk=[1e7] * 3)

path = leadscrew.curve(points, degree=3, machine=machine)
planned, nearly = path.plan(), leadscrew.curve(points, degree=3, machine=loose).plan()
bound = path.check().bound_s
print(f"{planned.duration:.3f} s; with jerk hardly limited {nearly.duration:.3f} s; no less than {bound:.3f} s without a limit of it")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), gridspec_kw={"width_ratios": [1.3, 1]})
states = planned.at(np.linspace(0, planned.duration, 4000))
# Where all velocity is an axis' own, no speed is greater: its limit over the direction of the path.
moving = states["speed"] > 1e-3
along = np.abs(states["velocity"][moving][:, :3]) / states["speed"][moving][:, np.newaxis]
ceiling = np.min(machine.velocity / np.maximum(along, 1e-9), axis=1)
left.plot(states["path_length"][moving], ceiling, color=GREY, linewidth=0.9, label="limits of velocity")
for of, color, label in ((nearly, ORANGE, "jerk hardly limited"), (planned, BLUE, "jerk limited")):
    at = of.at(np.linspace(0, of.duration, 4000))
    left.plot(at["path_length"], at["speed"], color=color, linewidth=1, label=label)
left.set(title="Speed along the path", xlabel="path, mm", ylabel="mm/s", ylim=(0, 1.3 * ceiling.max()))
left.legend(loc="upper right", fontsize=8)

times = np.linspace(0, planned.duration, 4000)
at_limit = {name: np.abs(states[name][:, :3]) / getattr(machine, name) for name in ("velocity", "acceleration", "jerk")}
for row, (name, ratio) in enumerate(reversed(at_limit.items())):
    right.fill_between(times, row * 1.15, row * 1.15 + ratio.max(axis=1), color=(BLUE, ORANGE, GREY)[row], linewidth=0)
    right.text(0, row * 1.15 + 1.02, name, fontsize=8)
right.set(title="Nearest axis to its limit", xlabel="s", yticks=[0, 1, 1.15, 2.15, 2.3, 3.3], yticklabels=["0", "1"] * 3)
save(figure, __file__)
