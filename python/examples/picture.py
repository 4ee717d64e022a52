"""How the examples draw, and where their pictures go: beside them, or into the folder that is given."""

import io
import pathlib
import sys

import matplotlib
from PIL import Image

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of what draws)

TREE = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = TREE / "examples"
MACHINES = TREE / "machines"

BLUE, ORANGE, GREEN, RED, GREY = "#1f6fb4", "#e07b00", "#2c8a3e", "#c03028", "#8a8a8a"

plt.rcParams.update({
    "figure.dpi": 80, "savefig.dpi": 80, "font.size": 9, "axes.grid": True, "grid.color": "#e4e4e4",
    "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.2, "legend.frameon": False,
    "axes.titlesize": 10, "figure.constrained_layout.use": True,
})


def save(figure, script):
    """Writes NAME.png of the script NAME.py."""
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(script).resolve().parent
    path = folder / (pathlib.Path(script).stem + ".png")
    drawn = io.BytesIO()
    figure.savefig(drawn)
    Image.open(drawn).convert("RGB").quantize(160).save(path, optimize=True)
    print(path.name)
