#!/usr/bin/env python3
"""Time from the start of `leadscrew drive` to its first word, of a five-axis surface of about two hundred passes.

script/bench --first-motion [COMMAND …]: commands by turns, build/release/leadscrew if none is given; median of seven each."""

import os
import re
import select
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
RUNS = 7


def program_of(pattern):
    """Example 17 with ridges of 0.5 µm: some two hundred passes of a ball that leans, by a pattern of G6.5."""
    with open(os.path.join(ROOT, "examples/17-patch-leaning.ngc"), encoding="utf-8") as file:
        text, count = re.subn(r"^(G6\.5 .*)H0\.1(.*)$", rf"\1H0.0005\2 S{pattern}", file.read(), flags=re.MULTILINE)
    if count != 1:
        sys.exit("examples/17-patch-leaning.ngc has no block G6.5 with H0.1")
    return text


def seconds_to_first_word(command, program, folder):
    """A word is a row of the sink, below its heading."""
    fifo = os.path.join(folder, "words")
    os.mkfifo(fifo)
    options = ["--machine", os.path.join(ROOT, "machines/table-table-ac.toml"), "--tools", os.path.join(ROOT, "examples/tools.tbl")]
    begin = time.perf_counter()
    process = subprocess.Popen([command, "drive", program, *options, "--sink", fifo], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    # Opened for both, so that a command which fails before it opens the sink leaves nobody waiting.
    words = os.open(fifo, os.O_RDWR | os.O_NONBLOCK)
    rows, seconds = b"", 0
    while rows.count(b"\n") < 2 and process.poll() is None:
        if select.select([words], [], [], 0.1)[0]:
            rows += os.read(words, 1 << 16)
            seconds = time.perf_counter() - begin
    moves = rows.count(b"\n") >= 2
    process.kill()
    os.close(words)
    said = process.stderr.read().decode()
    process.wait()
    os.unlink(fifo)
    if not moves:
        sys.exit(f"{command}: nothing moved: {said}")
    return seconds


def main():
    commands = sys.argv[1:] or [os.path.join(ROOT, "build/release/leadscrew")]
    with tempfile.TemporaryDirectory() as folder:
        for name, pattern in {"zigzag": 2, "iso-scallop": 4}.items():
            program = os.path.join(folder, "surface.ngc")
            with open(program, "w", encoding="utf-8") as file:
                file.write(program_of(pattern))
            seconds = {command: [] for command in commands}
            for _ in range(RUNS):
                for command in commands:
                    seconds[command].append(seconds_to_first_word(command, program, folder))
            for command in commands:
                print(f"{name:12} {statistics.median(seconds[command]):6.3f} s  {os.path.relpath(command)}")


if __name__ == "__main__":
    main()
