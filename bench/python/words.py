"""What Python adds to a run: instructions of leadscrew.run() on a program of a million words, all of them handed over as an
array, beside those of a program in C++ that does the same by the library (words.cpp), and of the command, which makes and
judges the same words and keeps none. Counted by callgrind; what each takes for a program of no motion is taken off, the
interpreter's start with it. Fails where Python takes more than a twentieth more than C++.

    PYTHONPATH=build/release/python python3 bench/python/words.py build/release/leadscrew build/release/bench/python/words_in_cpp
"""

import pathlib
import re
import subprocess
import sys
import tempfile

WORDS = 1_000_000
MOST = 1.05
SCRIPT = "import sys, leadscrew; words = leadscrew.run(sys.argv[1]).words; print(len(words), words.flags.owndata)"


def instructions(*command):
    """How many a command takes, and what it prints."""
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *map(str, command)],
                          capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1]), done.stdout


def main():
    command, in_cpp = map(pathlib.Path, sys.argv[1:])
    ways = {"command": (command, "run", "--quiet"), "C++": (in_cpp,), "Python": (sys.executable, "-B", "-c", SCRIPT)}
    counts, told = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        nothing, million = pathlib.Path(folder) / "nothing.ngc", pathlib.Path(folder) / "million.ngc"
        for program, moves in ((nothing, 0), (million, 50)):
            program.write_text("G21 G90 G94 G61\n" + "G1 X100 F600\nX0\n" * moves + "M2\n")
        for name, way in ways.items():
            count, told[name] = instructions(*way, million)
            counts[name] = count - instructions(*way, nothing)[0]
    (words, owns), (kept, verdict) = told["Python"].split(), told["C++"].split()
    print(f"{words} words by Python, owndata {owns}; {kept} by C++, every limit {verdict}")
    for name, count in counts.items():
        print(f"{name:8} {count / 1e6:10.1f} million instructions, {100 * (count / counts['C++'] - 1):+.2f} % beside C++")
    is_same = int(words) == int(kept) > WORDS and (owns, verdict) == ("False", "kept")
    return 0 if is_same and counts["Python"] < MOST * counts["C++"] else 1


if __name__ == "__main__":
    sys.exit(main())
