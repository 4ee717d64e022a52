"""A path of the tool's tip and its direction, as arrays, in five axes: over a dome, the tool normal to it."""

import numpy as np
from picture import BLUE, MACHINES, ORANGE, plt, save

import leadscrew

machine = leadscrew.Machine.load(MACHINES / "table-table-ac.toml")

# A spiral down a dome of radius 60 mm: from 15 to 45 degrees off its pole, twice around.
turn = np.linspace(0, 4 * np.pi, 400)
polar = np.radians(np.linspace(15, 45, turn.size))
normals = np.stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)], axis=1)
tips = 60 * normals - [0, 0, 60]

program = leadscrew.tool_path(tips, normals, feed=50, tolerance=0.01, orientation_tolerance=0.1, machine=machine)
result = program.run()
print(f"{result.time_s:.2f} s; the tip is within {result.tip['deviation_mm'] * 1e3:.2f} µm, the direction within "
      f"{result.tip['orientation_deviation_deg']:.4f} degrees")

led_tips, led_directions = machine.forward(result.words)
figure = plt.figure(figsize=(9, 4.2))
left = figure.add_subplot(1, 2, 1, projection="3d")
left.plot(*led_tips.T, color=BLUE, linewidth=0.9)
left.quiver(*led_tips[::150].T, *(12 * led_directions[::150].T), color=ORANGE, linewidth=0.7, arrow_length_ratio=0)
left.set(title="Tip and direction of the tool", xlabel="X, mm", ylabel="Y, mm")
left.set(xticks=[-40, 0, 40], yticks=[-40, 0, 40], zticks=[-15, 0])
left.set_box_aspect((1, 1, 0.55))
left.set_zlim(led_tips[:, 2].min(), led_tips[:, 2].max() + 12)

right = figure.add_subplot(1, 2, 2)
ratios = np.abs(result.derivative(1)) / machine.velocity
for column, letter in enumerate(machine.axes):
    right.plot(result.time, ratios[:, column], linewidth=0.9, label=letter)
right.set(title="Velocity of each axis over its limit", xlabel="s", ylim=(0, None))
right.legend(ncols=5, loc="upper center")
right.set_ylim(top=right.get_ylim()[1] * 1.12)
save(figure, __file__)
