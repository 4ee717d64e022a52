"""A logged trace against the program and the machine: the referee says how far it was off, where, and what it exceeded."""

import numpy as np
from picture import BLUE, GREY, RED, plt, save

import leadscrew

program = leadscrew.Program(text="G21 G90 G94 G64 P0.01\nG1 X10 F3000\nY10\nX0\nY0\nM2\n")
result = program.run()

# As a controller with a lag of 15 ms logs it, which loses 40 steps of X on its way back: here made of the words, in
# practice np.loadtxt().
logged = np.concatenate([result.positions, np.repeat(result.positions[-1:], 100, axis=0)])
for i in range(1, len(logged)):
    logged[i] = logged[i - 1] + (logged[i] - logged[i - 1]) * (1 - np.exp(-result.machine.period / 0.015))
half = int(np.argmax(result.words["line"] == 4)) + 100
logged[half:, 0] += 0.04 * np.clip(np.arange(len(logged) - half) / 20, 0, 1)

clean, verdict = program.verify(result.words), program.verify(logged)
print(f"words: {clean.deviation_mm * 1e3:.3f} µm, {clean.violation_count} objections")
print(f"logged: {verdict.deviation_mm * 1e3:.1f} µm of {verdict.tolerance_mm * 1e3:.0f}, {verdict.violation_count} objections, such as")
for each in verdict.violations[:3]:
    print(f"  {each['t']:.3f} s, line {each['line']}: {each['what']} {each['value']:.4g}, limit {each['limit']:.4g}")

beyond = [each for each in verdict.violations if each["what"] == "deviation"]
times = np.array([each["t"] for each in beyond])

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), gridspec_kw={"width_ratios": [1, 1.3]})
left.plot(result.positions[:, 0], result.positions[:, 1], color=GREY, linewidth=4, alpha=0.5, label="words")
left.plot(logged[:, 0], logged[:, 1], color=BLUE, label="logged")
places = logged[np.round(times / result.machine.period).astype(int)]
left.plot(places[:, 0], places[:, 1], "o", color=RED, markersize=3, label="beyond the tolerance")
left.set(aspect="equal", title="The corner at X0 Y10", xlabel="X, mm", ylabel="Y, mm", xlim=(-0.2, 0.6), ylim=(9.5, 10.3))
left.legend(loc="lower right")
right.plot(times, [each["value"] * 1e3 for each in beyond], "o", color=RED, markersize=2)
right.axhline(verdict.tolerance_mm * 1e3, color="black", linewidth=0.6, linestyle=":")
right.text(0.65, verdict.tolerance_mm * 1e3 + 1, "tolerance", fontsize=8)
right.set(title="Objections: distance from the program", xlabel="s", ylabel="µm", ylim=(0, None))
save(figure, __file__)
