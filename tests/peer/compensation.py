"""Programs with cutter compensation, and what rs274 and `leadscrew canon` make of them.

    compensation.py COMMAND [--count N] [--seed S] [--keep DIR]

Contours are of lines and arcs that the tool fits into, with corners by 0.1 to 2.2 radians to either side. Motion must be
equal to 1e-4 of the unit. What differs by design, and is left out of the contours:

- corners by less than 0.05 radians: rs274 leads straight from one way to the next, here they are corners as others;
- at M0 rs274 ends the way beside the corner, here it ends where ways meet;
- corners at rapid: rs274 cuts them by a line, here they are gone round;
- a first move that is an arc, which rs274 makes another arc of, is refused here;
- tangent arcs within rounding, where either joins them by a move of its own, may differ by a few 1e-4;
- a contour that crosses one of its own neighbours is refused here, and not by rs274 unless a way turns round;
- #<_x> and its like tell the programmed place here, there the place beside it.

Without rs274 the status is 77: skipped.
"""
import argparse
import math
import pathlib
import random
import sys
import tempfile

import readers

SKIPPED = 77


class Contour:
    """Goes along lines and arcs that are much longer than the tool's radius, and says them as it goes."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.radius = self.random.choice([0.5, 1, 2, 3.3])
        self.plane = self.random.choice(["G17", "G17", "G18"])
        self.letters = "XYIJZ" if self.plane == "G17" else "ZXKIY"
        self.place, self.heads, self.incremental = [0.0, 0.0], self.random.uniform(-3, 3), False
        self.lines, self.was_arc = [], False

    def words(self, end):
        base = self.place if self.incremental else [0.0, 0.0]
        return " ".join(f"{letter}{value - start:.4f}" for letter, value, start in zip(self.letters, end, base))

    def line(self, code="G1"):
        length = self.radius * self.random.uniform(7, 20)
        end = [round(self.place[0] + length * math.cos(self.heads), 4), round(self.place[1] + length * math.sin(self.heads), 4)]
        self.say(f"{code} {self.words(end)}", end)

    def arc(self):
        radius, sweep, turn = self.radius * self.random.uniform(6, 15), self.random.uniform(0.6, 2), self.random.choice([1, -1])
        center = [self.place[0] - turn * radius * math.sin(self.heads), self.place[1] + turn * radius * math.cos(self.heads)]
        begins = math.atan2(self.place[1] - center[1], self.place[0] - center[0])
        end = [round(center[0] + radius * math.cos(begins + turn * sweep), 4), round(center[1] + radius * math.sin(begins + turn * sweep), 4)]
        by_radius = f"R{radius:.4f}"
        by_center = f"{self.letters[2]}{center[0] - self.place[0]:.4f} {self.letters[3]}{center[1] - self.place[1]:.4f}"
        self.say(f"{'G3' if turn > 0 else 'G2'} {self.words(end)} {self.random.choice([by_radius, by_center])}", end)
        self.heads += turn * sweep

    def say(self, block, end):
        if self.random.random() < 0.2:
            block += f" {self.letters[4]}{self.random.uniform(-3, 3):.3f}"
        self.lines.append(block)
        self.place = end

    def between(self):
        if self.random.random() < 0.15:
            self.lines.append(f"G1 {self.letters[4]}{self.random.uniform(-3, 3):.3f}")
        if self.random.random() < 0.15:
            self.lines.append(self.random.choice(["M3 S100", "M8", "G4 P0.5", "F300", "S200"]))
        if self.random.random() < 0.2:
            self.incremental = not self.incremental
            self.lines.append("G91" if self.incremental else "G90")

    def program(self):
        self.lines.append(f"{self.plane} F{self.random.randint(100, 900)}")
        if self.plane == "G17" and self.random.random() < 0.3:
            self.lines.append(f"G10 L2 P1 X{self.random.randint(-5, 5)} Y4 R{self.random.randint(-90, 90)}")
        orientation = f" L{self.random.randint(0, 9)}" if self.plane == "G18" and self.random.random() < 0.6 else ""
        self.lines.append(f"{self.random.choice(['G41.1', 'G42.1'])} D{2 * self.radius * self.random.choice([1, 1, -1]):.3f}{orientation}")
        self.line(self.random.choice(["G1", "G0"]))
        for _ in range(self.random.randint(1, 7)):
            self.between()
            is_arc = self.random.random() < 0.5
            if self.random.random() < 0.8 or is_arc and self.was_arc:
                self.heads += self.random.choice([-1, 1]) * self.random.uniform(0.1, 2.2)
            self.arc() if is_arc else self.line()
            self.was_arc = is_arc
        self.incremental = False
        self.lines += ["G90 G40", f"G1 {self.words([self.random.uniform(-30, 30) for _ in range(2)])}", "M2"]
        return "\n".join(self.lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", metavar="DIR", type=pathlib.Path, help="write programs that differ there")
    arguments = parser.parse_args()
    if not readers.rs274():
        print("SKIPPED: rs274 is not installed (script/install-packages peers)")
        sys.exit(SKIPPED)
    differing = accepted = 0
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "program.ngc"
        for seed in range(arguments.seed, arguments.seed + arguments.count):
            path.write_text(Contour(seed).program())
            theirs, ours = readers.of_peer(path), readers.of_leadscrew(arguments.command, path)
            found, _ = readers.difference(ours, theirs)
            accepted += ours.accepted
            if found is None:
                continue
            differing += 1
            print(f"seed {seed}: {found}")
            if arguments.keep:
                arguments.keep.mkdir(parents=True, exist_ok=True)
                (arguments.keep / f"compensation-{seed}.ngc").write_text(path.read_text())
    print(f"{arguments.count} programs, {accepted} accepted; {differing} differ")
    sys.exit(1 if differing or not accepted else 0)


if __name__ == "__main__":
    main()
