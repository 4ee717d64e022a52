"""The same program on three machines: what the limits of each make of it."""

from picture import BLUE, GREEN, MACHINES, ORANGE, PROGRAMS, plt, save

import leadscrew

program = PROGRAMS / "09-butterfly.ngc"
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), gridspec_kw={"width_ratios": [2, 1]})
for row, (name, color) in enumerate((("mill3", BLUE), ("router3", ORANGE), ("heavy3", GREEN))):
    result = leadscrew.run(program, machine=MACHINES / f"{name}.toml")
    left.plot(result.time, result.words["feed"], color=color, linewidth=0.9, label=name)
    right.barh(row, result.time_s, color=color, height=0.6)
    right.barh(row, result.bound_s, color="white", alpha=0.45, height=0.6)
    right.text(result.time_s, row, f" {result.time_s:.2f} s", va="center")
    print(f"{name}: {result.time_s:.3f} s, at least {result.bound_s:.3f} s without a limit of jerk")
left.set(title="Feed; F6000 is 100 mm/s, and the rapid to the curve goes beyond the picture", xlabel="s", ylabel="mm/s", ylim=(0, 130))
left.legend(ncols=3, loc="upper right")
right.set(title="Time, and (light) its bound", yticks=range(3), yticklabels=["mill3", "router3", "heavy3"], xlabel="s")
right.invert_yaxis()
right.margins(x=0.25)
right.grid(axis="y", visible=False)
save(figure, __file__)
