#!/usr/bin/env python3
"""record_to_trace.py RECORD TRACE: makes of record.py's record a trace that the referee can read.

It begins with the last word before motion and ends with the first at rest where the program leaves the machine; at
rest is within a nanometre.
"""
import csv
import sys

PERIOD = 0.001  # seconds
REST = 1.0  # nanometres, or millionths of a degree
LETTERS = {3: "XYZ", 5: "XYZAC"}  # by how many columns there are


def words(record):
    """The recorded positions, nanometres; every servo period has to be there."""
    # halsampler says "overrun" where its numbering does not go on, also when it only begins late: trust the numbers.
    with open(record) as file:
        rows = [line.split() for line in file if line.strip() != "overrun"]
    numbers = [int(row[0]) for row in rows]
    for last, number in zip(numbers, numbers[1:]):
        if number != last + 1:
            raise ValueError(f"{record}: {number - last - 1} periods are missing after number {last}")
    return [tuple(map(float, row[1:])) for row in rows]


def apart(a, b):
    return max(abs(p - q) for p, q in zip(a, b)) > REST


def motion(positions):
    """The part of them in which the machine moves, with rest at both ends."""
    moved = [i for i, word in enumerate(positions) if apart(word, positions[0])]
    if not moved:
        raise ValueError("nothing moved")
    unsettled = [i for i, word in enumerate(positions) if apart(word, positions[-1])]
    return positions[moved[0] - 1 : max(moved[0], unsettled[-1] + 1 if unsettled else 0) + 1]


def write_trace(record, trace, letters=None):
    """`letters`: of the columns, where there are others than LETTERS has."""
    with open(trace, "w", newline="") as file:
        rows = csv.writer(file)
        moving = motion(words(record))
        rows.writerow(["t", *(letters or LETTERS[len(moving[0])])])
        for i, word in enumerate(moving):
            rows.writerow([f"{i * PERIOD:.3f}", *(f"{q * 1e-6:.15g}" for q in word)])


if __name__ == "__main__":
    write_trace(*sys.argv[1:3])
