"""What a program waits for: the time that its blocks take beyond their feed words, by cause and by place."""

import numpy as np
from matplotlib.collections import LineCollection
from picture import BLUE, PROGRAMS, plt, save

import leadscrew

result = leadscrew.run(PROGRAMS / "01-plate.ngc", tools=PROGRAMS / "tools.tbl")
blocks = result.blocks
lost = blocks["seconds"] - blocks["least_seconds"]
print(f"{result.time_s:.2f} s, of them {lost.sum():.2f} s beyond what the feed words ask")
for i in np.argsort(lost)[:-4:-1]:
    print(f"  line {blocks['line'][i]}: {lost[i]:.3f} s, {blocks['cause'][i]}")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4))
greatest = [each for each in result.losses if each["s"] > 0.005]
bars = left.barh([each["cause"] for each in greatest], [each["s"] for each in greatest], color=BLUE, height=0.6)
left.bar_label(bars, fmt=" %.2f s", fontsize=8)
left.invert_yaxis()
left.margins(x=0.2)
left.grid(axis="y", visible=False)
left.set(title="Time lost, by cause", xlabel="s")

words = result.words
share = np.zeros(int(words["line"].max()) + 1)
np.add.at(share, blocks["line"], lost)
words = words[::20]
places = words["position"][:, :2]
by_line = share[words["line"][1:]]
order = np.argsort(by_line, kind="stable")  # the dearest on top
path = LineCollection(np.stack([places[:-1], places[1:]], axis=1)[order], array=by_line[order], cmap="inferno_r", linewidth=2)
right.add_collection(path)
right.autoscale()
right.set(aspect="equal", title="and by line of the program", xlabel="X, mm", ylabel="Y, mm")
figure.colorbar(path, ax=right, label="s lost by the line", shrink=0.8)
save(figure, __file__)
