"""Compares leadscrew with LinuxCNC's rs274 over programs of a grammar, or over files.

    peer.py COMMAND [--count N] [--seed S] [--keep DIR] [--no-flow] [--cycles G81,G82]
    peer.py COMMAND [--shrink] PROGRAM…

Both must accept or refuse a program alike, and the calls that move must be equal to 1e-4 of the program's unit. The seed
of each program that differs is printed; --keep writes such programs there. Without rs274 the status is 77: skipped.
"""
import argparse
import os
import pathlib
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import generator
import readers
from further import DIAMETERS

SKIPPED = 77
TOOLS = "T1 P1 Z{0:.4f} D{4:.4f}\nT2 P2 Z{1:.4f} X{2:.4f} D{5:.4f}\nT3 P3 Z{3:.4f} D{6:.4f} I93 J-20.5 Q2\n"
LENGTHS = (1.0, 2.5, 0.25, -0.5, *DIAMETERS)  # inches, in which rs274 reads a table without an INI


def compare(arguments, tables, program, name):
    theirs = readers.of_peer(program, tools=tables[1])
    ours = readers.of_leadscrew(arguments.command, program, options=["--tools", tables[0], *arguments.option])
    found, ways = readers.difference(ours, theirs)
    return name, found, ours.accepted, len(ours.motions), ways


def of_seed(arguments, tables, folder, seed):
    text = generator.program(seed, not arguments.no_flow, arguments.cycles.split(","))
    path = pathlib.Path(folder) / f"seed-{seed}.ngc"
    path.write_text(text)
    result = compare(arguments, tables, path, f"seed {seed}")
    if result[1] and arguments.keep:
        pathlib.Path(arguments.keep).mkdir(parents=True, exist_ok=True)
        (pathlib.Path(arguments.keep) / path.name).write_text(text)
    path.unlink()
    return result


def kind_of(found):
    """What differs, without numbers."""
    return re.sub(r"[-+\d.]+", "", found.split("[")[0].split("ours  ")[0])[:60] if found else None


def shrunk(arguments, tables, path):
    """Takes out lines as long as the same differs."""
    lines = path.read_text().splitlines()
    found = compare(arguments, tables, path, "")[1]
    wanted, piece = kind_of(found), max(len(lines) // 2, 1)
    while True:
        begin = 0
        while begin < len(lines):
            fewer = lines[:begin] + lines[begin + piece:]
            path.write_text("\n".join(fewer) + "\n")
            less = compare(arguments, tables, path, "")[1]
            if kind_of(less) == wanted:
                lines, found = fewer, less
            else:
                begin += piece
        if piece == 1:
            break
        piece = max(piece // 2, 1)
    path.write_text("\n".join(lines) + "\n")
    return f"{path.name}:\n" + "\n".join(lines) + f"\n=> {found}\n"


def parsed():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("programs", nargs="*", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", metavar="DIR", help="write programs that differ there")
    parser.add_argument("--shrink", action="store_true", help="make the PROGRAMs as short as they can be and still differ")
    parser.add_argument("--no-flow", action="store_true")
    parser.add_argument("--cycles", default=",".join(generator.Program.CYCLES))
    parser.add_argument("--option", action="append", default=[], help="for leadscrew canon")
    return parser.parse_intermixed_args()


def main():
    arguments = parsed()
    if not readers.rs274():
        print("SKIPPED: rs274 is not installed (script/install-packages peers)")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        tables = pathlib.Path(folder) / "mm.tbl", pathlib.Path(folder) / "inches.tbl"
        tables[0].write_text(TOOLS.format(*(25.4 * length for length in LENGTHS)))
        tables[1].write_text(TOOLS.format(*LENGTHS))
        if arguments.shrink:
            for text in pool.map(lambda path: shrunk(arguments, tables, path), arguments.programs):
                print(text)
            return
        if arguments.programs:
            work = [pool.submit(compare, arguments, tables, path, path.name) for path in arguments.programs]
        else:
            seeds = range(arguments.seed, arguments.seed + arguments.count)
            work = [pool.submit(of_seed, arguments, tables, folder, seed) for seed in seeds]
        results = [each.result() for each in work]
    differing = [result for result in results if result[1]]
    for name, found, *_ in differing:
        print(f"{name}: {found}")
    accepted = sum(result[2] for result in results)
    motions, ways = (sum(result[i] for result in results) for i in (3, 4))
    print(f"{len(results)} programs, {accepted} accepted, {motions} motions, {ways} holes reached another way; "
          f"{len(differing)} differ")
    sys.exit(1 if differing else 0)


if __name__ == "__main__":
    main()
