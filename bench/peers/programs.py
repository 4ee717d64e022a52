"""The part programs that leadscrew and its peers are compared on."""
import dataclasses
import math
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"


@dataclasses.dataclass
class Program:
    name: str  # of its file
    title: str  # in the table
    text: str
    start: tuple = (0, 0)  # X and Y in mm, where the machine stands before it; or X Y Z A C, mm and degrees
    peer_text: str = ""  # for LinuxCNC, where that is another
    peer_start: tuple = ()  # in its coordinates, where those are others


@dataclasses.dataclass
class Machine:
    """One for both."""

    configuration: str  # of LinuxCNC: an .ini and a .hal of this name
    letters: str  # of its axes, in the order of start
    options: list  # for leadscrew
    told: str  # above the table


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


def program_of(blocks, tolerance=0.01, feed=6000):
    """These blocks, from G21 to M2."""
    return f"G21 G90 G17 G94 G64 P{tolerance}\nF{feed}\n" + "".join(block + "\n" for block in blocks) + "M2\n"


def line_to(x, y, more=""):
    return f"G1 X{x:.4f} Y{y:.4f}{more}"


def corners():
    """A staircase of right angles, then a fan of corners that turn ever more sharply, 8 mm between them."""
    blocks, x, y, direction = [], 0.0, 0.0, 0.0
    for k in range(60):
        x, y = (x + 8, y) if k % 2 == 0 else (x, y + 8)
        blocks.append(line_to(x, y))
    for k in range(1, 35):
        direction += math.radians(5 * k) * (-1) ** k
        x, y = x + 8 * math.cos(direction), y - 8 * abs(math.sin(direction))
        blocks.append(line_to(x, y))
    return program_of(blocks)


def zigzag():
    """Teeth of 0.5 mm to 6 mm."""
    blocks, x = [], 0.0
    for k in range(240):
        x += 0.5 + 0.01 * k
        blocks.append(line_to(x, 0 if k % 2 else 0.5 + k / 44))
    return program_of(blocks)


def engraving():
    """Letters of the size of a name plate: short curves in lines of about 0.15 mm, the pen lifted between them."""
    blocks = ["G0 Z1"]
    for letter in range(24):
        left, low = 7 * (letter % 8), 10 * (letter // 8)
        # Lissajous figures of two small frequencies: loops, cusps and crossings, as script has them.
        across, up, shift = 1 + letter % 3, 2 + letter % 4, 0.4 + 0.3 * letter
        points = [(left + 2.5 + 2.2 * math.sin(across * u + shift), low + 4 + 3.5 * math.sin(up * u))
                  for u in (2 * math.pi * i / 160 for i in range(161))]
        blocks += [f"G0 X{points[0][0]:.3f} Y{points[0][1]:.3f}", "G1 Z-0.2 F600", "F2400"]
        blocks += [f"G1 X{x:.3f} Y{y:.3f}" for x, y in points[1:]] + ["G0 Z1"]
    return program_of(blocks, tolerance=0.005, feed=2400)


def small_arcs():
    """A scalloped edge: half circles of 0.5 mm to 2 mm radius, outside and inside in turn."""
    blocks, x = [], 0.0
    for k in range(200):
        radius = 0.5 + 1.5 * (k * 7 % 20) / 19
        x += 2 * radius
        blocks.append(f"G{2 + k % 2} X{x:.4f} Y0 I{radius:.4f} J0")
    return program_of(blocks)


def random_walk(turn, seed):
    """1500 lines of 0.05 mm to 2 mm that turn by up to `turn` radians each."""
    random = Random(seed)
    blocks, x, y, direction = [], 0.0, 0.0, 0.0
    for _ in range(1500):
        direction += turn * random.next()
        if abs(x) > 150 or abs(y) > 150:
            direction = math.atan2(-y, -x)
        length = 0.05 * 40 ** (0.5 + 0.5 * random.next())
        x, y = x + length * math.cos(direction), y + length * math.sin(direction)
        blocks.append(line_to(x, y))
    return program_of(blocks)


class Random:
    """Numbers between -1 and 1, the same wherever this runs."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 11) / 2**52 - 1


def raster():
    """40 rows of 60 mm, 0.5 mm apart; half circles lead from row to row."""
    blocks = []
    for row in range(40):
        there = 60 if row % 2 == 0 else 0
        blocks += [line_to(there, 0.5 * row), f"G{3 if row % 2 == 0 else 2} X{there} Y{0.5 * (row + 1):.4f} I0 J0.25"]
    return program_of(blocks)


def laser_raster():
    """A picture of 20 rows: lines of 0.2 mm, each with a power of its own; 3 mm beyond the picture to turn round."""
    blocks = []
    for row in range(20):
        places = [0.2 * column for column in range(1, 201)]
        if row % 2:
            places = [40 - place for place in places]
        begin, end = (-3, 43) if row % 2 == 0 else (43, -3)
        y = 0.2 * row
        blocks += [f"S0 G1 X{begin} Y{y:.2f}"] + [f"S{(7 * row + 13 * k) % 255} G1 X{place:.2f} Y{y:.2f}"
                                                 for k, place in enumerate(places)] + [f"S0 G1 X{end} Y{y:.2f}"]
    return program_of(blocks, tolerance=0.02, feed=9000)


def pocket():
    """Rounded rectangles one in the other, 1.5 mm apart, with corners of 1.5 mm radius and more; down at each."""
    blocks = []
    for ring in range(12):
        half_x, half_y, radius = 6 + 1.5 * ring, 4 + 1.5 * ring, 1.5 + 0.5 * ring
        blocks.append(line_to(0, -half_y))
        for sx, sy in ((1, -1), (1, 1), (-1, 1), (-1, -1)):
            if sx * sy < 0:  # along X, then round to Y
                blocks += [line_to(sx * (half_x - radius), sy * half_y),
                           f"G3 X{sx * half_x:.4f} Y{sy * (half_y - radius):.4f} I0 J{-sy * radius:.4f}"]
            else:
                blocks += [line_to(sx * half_x, sy * (half_y - radius)),
                           f"G3 X{sx * (half_x - radius):.4f} Y{sy * half_y:.4f} I{-sx * radius:.4f} J0"]
        blocks.append(line_to(0, -half_y))
    return program_of(blocks)


def spiral():
    """Outwards by 1 mm a turn in lines of 0.3 mm or so, 15 turns."""
    blocks, angle = [], 0.0
    while angle < 30 * math.pi:
        radius = 1 + angle / (2 * math.pi)
        angle += 0.3 / radius
        radius = 1 + angle / (2 * math.pi)
        blocks.append(line_to(radius * math.cos(angle) - 1, radius * math.sin(angle)))
    return program_of(blocks)


def slots():
    """Slots with round ends, side by side: down into each, round it twice, up and on to the next."""
    blocks = ["G0 Z2"]
    for k in range(15):
        x, length, radius = 8 * k, 10 + k, 1 + 0.1 * k
        blocks += [f"G0 X{x - radius:.4f} Y0", "G1 Z-1 F1200", "F6000"]
        for _ in range(2):
            blocks += [line_to(x - radius, length), f"G2 X{x + radius:.4f} Y{length} I{radius:.4f} J0",
                       line_to(x + radius, 0), f"G2 X{x - radius:.4f} Y0 I{-radius:.4f} J0"]
        blocks.append("G0 Z2")
    return program_of(blocks)


def axes_of(x, y, z, a, c):
    """Of machines/table-table-ac.toml, while the tip is there: C about x = y = 0, then A about y = 0, z = -50."""
    turn, tilt = math.radians(c), math.radians(a)
    x, y = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
    y, z = y * math.cos(tilt) - (z + 50) * math.sin(tilt), y * math.sin(tilt) + (z + 50) * math.cos(tilt) - 50
    return (x, y, z, a, c)


def five_axes(name, tip):
    """An example from where its tip is told on: tool centre point control is on from the start in LinuxCNC, which knows
    neither E nor this tool."""
    text = (EXAMPLES / f"{name}.ngc").read_text()
    blocks = [line for line in text.splitlines() if not line.startswith(("G0 A", "G43.4", "T1"))]
    body = "\n".join(blocks) + "\n"
    peer = re.sub(r"^(G21.*|)G64 P(\S+) E\S+", r"\1G64 P\2", body, flags=re.MULTILINE)
    return Program(name, f"{name}.ngc", "G43.4\n" + body, axes_of(*tip), peer, tip)


def five_axis_programs():
    return [five_axes("12-hemisphere", (40, 0, 5, 75, 75)), five_axes("13-blade", (43.378, 6.707, 40, 29.787, -36.111))]


def machines():
    """Each with its programs."""
    return [
        (Machine("linuxcnc", "XY", [], "each axis 200 mm/s, 1000 mm/s², 20000 mm/s³"), programs()),
        (Machine("five-axes", "XYZAC", ["--machine", ROOT / "machines" / "table-table-ac.toml"],
                 "five axes of machines/table-table-ac.toml, X Y Z 60000 mm/s³, A 30000°/s³, C 60000°/s³; deviation of the tip"),
         five_axis_programs()),
    ]


def programs():
    return [
        Program("cubic-92", "cubic, 92 lines", lines(cubic(92), 0.01)),
        Program("cubic-1000", "cubic, 1000 lines", lines(cubic(1000), 0.01)),
        Program("cubic-rounded", "the same to 1 µm", lines(cubic(1000), 0.005, decimals=3)),
        Program("collinear", "5000 collinear lines", lines([(i / 100, 0) for i in range(1, 5001)], 0.01)),
        Program("square", "10 mm square", lines([(10, 0), (10, 10), (0, 10), (0, 0)], 0.01)),
        Program("circle", "circle, 2000 lines", lines(circle(10, 2000), 0.01), start=(10, 0)),
        Program("finishing", "05-finishing.ngc", (EXAMPLES / "05-finishing.ngc").read_text()),
        Program("corners", "94 corners", corners()),
        Program("zigzag", "zigzag", zigzag()),
        Program("engraving", "engraving", engraving()),
        Program("small-arcs", "200 small arcs", small_arcs()),
        Program("walk-bent", "random walk, bent", random_walk(0.3, 1)),
        Program("raster", "raster, turn-rounds", raster()),
        Program("laser-raster", "raster, S each line", laser_raster()),
        Program("pocket", "pocket with arcs", pocket()),
        Program("spiral", "spiral", spiral()),
        Program("slots", "slots", slots()),
        Program("walk-sharp", "random walk, sharp", random_walk(2.5, 2)),
    ]
