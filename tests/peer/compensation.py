"""Programs with cutter compensation, and what rs274 and `leadscrew canon` make of them.

    compensation.py COMMAND [--count N] [--seed S] [--keep DIR]

Motion must be equal to 1e-4 of the unit. Both accept, or leadscrew refuses a gouge that rs274 does not see: then the path
that rs274 makes must come nearer to the contour than the radius, found by samples, or there is no path. What differs by
design, and is left out of the contours:

- corners by less than 0.05 radians: rs274 leads straight from one way to the next, here they are corners as others;
- a first move that is an arc of an oriented lathe tool: rs274 goes straight by the radius before it;
- at M0 rs274 ends the way beside the corner, here it ends where ways meet;
- corners at rapid: rs274 cuts them by a line, here they are gone round;
- arcs whose centres are not as far from both ends: rs274 takes the radius from one of them, here the centre is moved to their
  bisector. An error of 1e-4 in a centre moves where ways meet by 1e-4 over the sine of the angle between them;
- #<_x> and its like tell the programmed place here, there the place beside it.

Without rs274 the status is 77: skipped.
"""
import argparse
import os
import pathlib
import random
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import readers
from contours import Contour, Piece, nearest

SKIPPED = 77
DEPTH = 2e-4  # of a gouge in a path that is printed to 1e-4
# From the middle of a lathe tool to the place that is programmed, along Z and X, by its orientation (LinuxCNC manual).
ORIGINS = ((0, 0), (1, -1), (-1, -1), (-1, 1), (1, 1), (1, 0), (0, -1), (-1, 0), (0, 1), (0, 0))


class Program:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.radius = self.random.choice([0.5, 1, 2, 3.3])
        self.in_xy = self.random.random() < 0.67
        self.orientation = 0
        self.contour = Contour(self.random, [0.0, 0.0], self.radius, "XYIJZ" if self.in_xy else "ZXKIY", strict=self.random.random() < 0.5)
        self.text = self.written()

    def written(self):
        lines = [f"{'G17' if self.in_xy else 'G18'} F{self.random.randint(100, 900)}"]
        if self.in_xy and self.random.random() < 0.3:
            lines += [f"G10 L2 P1 X{self.random.randint(-5, 5)} Y4 R{self.random.randint(-90, 90)}", "G0 X0 Y0 Z0"]
        sides = (["G41", "G42"], self.random.choice([1, 1, -1]))
        if self.random.random() < 0.4:
            self.orientation = 0 if self.in_xy else self.random.randint(0, 9)
            lines.append(f"G10 L1 P1 R{sides[1] * self.radius:.3f} Q{self.orientation}")
            lines.append(f"{self.random.choice(sides[0])} D1")
        else:
            self.orientation = self.random.randint(0, 9) if not self.in_xy and self.random.random() < 0.6 else 0
            word = f" L{self.orientation}" if self.orientation else ""
            lines.append(f"{self.random.choice(sides[0])}.1 D{2 * self.radius * sides[1]:.3f}{word}")
        self.contour.arc_first = self.orientation in (0, 9)
        self.contour.go()
        end = [self.random.uniform(-30, 30) for _ in range(2)]
        return "\n".join([*lines, *self.contour.lines, "G40", f"G1 {self.contour.words(end)}", "M2"]) + "\n"

    def path(self, motions):
        """Of the tool's middle, from calls: what is between the way in and the way out."""
        origin = [self.radius * value for value in ORIGINS[self.orientation]]
        path, place, level, run = [], [-value for value in origin], 0.0, -1 if "G10 L2" in self.text else 0
        for motion in motions:
            numbers = motion.numbers
            if motion.name == "ARC_FEED":
                end, center, turn, height = numbers[0:2], [a - b for a, b in zip(numbers[2:4], origin)], numbers[4], numbers[5]
            elif motion.name in ("STRAIGHT_FEED", "STRAIGHT_TRAVERSE"):
                end, center, turn, height = (numbers[0:2], None, 0, numbers[2]) if self.in_xy else ([numbers[2], numbers[0]], None, 0, numbers[1])
            else:
                continue
            end = [a - b for a, b in zip(end, origin)]
            if end == place:
                run += 1
            else:
                path.append(Piece(place, end, center, 1 if turn > 0 else -1 if turn else 0, (level, height), run))
            place, level = end, height
        return path[1:-1]

    def is_gouged(self, theirs):
        """Whether the path of rs274 comes nearer to the contour than the radius."""
        return nearest(self.path(theirs.motions), self.contour.pieces[1:], self.radius / 50) < self.radius - DEPTH


def compare(command, folder, seed):
    program = Program(seed)
    path = pathlib.Path(folder) / f"{seed}.ngc"
    path.write_text(program.text)
    table = pathlib.Path(folder) / f"{seed}.tbl"
    table.write_text("T1 P1 D1\n")
    theirs, ours = readers.of_peer(path, tools=table), readers.of_leadscrew(command, path, options=["--tools", table])
    found, _ = readers.difference(ours, theirs)
    is_gouge = not ours.accepted and "[cutter-gouge]" in ours.reason and (not theirs.accepted or program.is_gouged(theirs))
    return seed, None if is_gouge else found, ours.accepted, is_gouge, program.text


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
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        seeds = range(arguments.seed, arguments.seed + arguments.count)
        results = list(pool.map(lambda seed: compare(arguments.command, folder, seed), seeds))
    differing = [result for result in results if result[1]]
    for seed, found, _, _, text in differing:
        print(f"seed {seed}: {found}")
        if arguments.keep:
            arguments.keep.mkdir(parents=True, exist_ok=True)
            (arguments.keep / f"compensation-{seed}.ngc").write_text(text)
    accepted, gouged = (sum(result[i] for result in results) for i in (2, 3))
    print(f"{len(results)} programs, {accepted} accepted, {gouged} gouged; {len(differing)} differ")
    sys.exit(1 if differing or not accepted else 0)


if __name__ == "__main__":
    main()
