"""The part programs that leadscrew and its peers are compared on."""
import dataclasses
import math
import pathlib

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


@dataclasses.dataclass
class Program:
    name: str  # of its file
    title: str  # in the table
    text: str
    start: tuple = (0, 0)  # X and Y in mm, where the machine stands before it


def lines(points, tolerance, decimals=9):
    """G1 from point to point, in mm, at 100 mm/s."""
    blocks = "".join(f"G1 X{x:.{decimals}f} Y{y:.{decimals}f}\n" for x, y in points)
    return f"G21 G90 G17 G94 G64 P{tolerance}\nF6000\n{blocks}M2\n"


def cubic(count):
    """x = 20 u, y = -50 u^3 + 80 u^2 - 10 u at u = 1/count … 1."""
    return [(20 * u, ((-50 * u + 80) * u - 10) * u) for u in (i / count for i in range(1, count + 1))]


def circle(radius, count):
    """Counterclockwise from (radius, 0), where it ends too."""
    angles = (2 * math.pi * i / count for i in range(1, count + 1))
    return [(radius * math.cos(a), radius * math.sin(a)) for a in angles]


def programs():
    return [
        Program("cubic-92", "cubic, 92 lines", lines(cubic(92), 0.01)),
        Program("cubic-1000", "cubic, 1000 lines", lines(cubic(1000), 0.01)),
        Program("cubic-rounded", "the same to 1 µm", lines(cubic(1000), 0.005, decimals=3)),
        Program("collinear", "5000 collinear lines", lines([(i / 100, 0) for i in range(1, 5001)], 0.01)),
        Program("square", "10 mm square", lines([(10, 0), (10, 10), (0, 10), (0, 0)], 0.01)),
        Program("circle", "circle, 2000 lines", lines(circle(10, 2000), 0.01), start=(10, 0)),
        Program("finishing", "05-finishing.ngc", (EXAMPLES / "05-finishing.ngc").read_text()),
    ]
