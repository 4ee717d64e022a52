"""What Python adds to a run: instructions of leadscrew.run() on a program of a million words, all of them handed over as an
array, beside those of the command, which makes and judges the same words and keeps none. Counted by callgrind; what either
takes for a program of no motion is taken off, the interpreter's start with it.

    PYTHONPATH=build/release/python python3 bench/python_words.py build/release/leadscrew
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
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *map(str, command)],
                          capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1]), done.stdout


def main():
    command = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        programs = []
        for name, moves in (("nothing.ngc", 0), ("million.ngc", 50)):
            programs.append(pathlib.Path(folder) / name)
            programs[-1].write_text("G21 G90 G94 G61\n" + "G1 X100 F600\nX0\n" * moves + "M2\n")
        native = [instructions(command, "run", "--quiet", program)[0] for program in programs]
        (nothing, _), (million, told) = [instructions(sys.executable, "-B", "-c", SCRIPT, program) for program in programs]
    words, owns = told.split()
    python, command_alone = million - nothing, native[1] - native[0]
    print(f"{words} words, owndata {owns}")
    print(f"command  {command_alone / 1e6:10.1f} million instructions")
    print(f"Python   {python / 1e6:10.1f} million instructions, {100 * (python / command_alone - 1):+.2f} %")
    return 0 if int(words) > WORDS and owns == "False" and python < MOST * command_alone else 1


if __name__ == "__main__":
    sys.exit(main())
