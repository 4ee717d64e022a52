"""Where the tree and the command are."""

import json
import os
import pathlib
import subprocess

TREE = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = TREE / "examples"
MACHINES = TREE / "machines"
COMMAND = os.environ.get("LEADSCREW_COMMAND", str(TREE / "build" / "release" / "leadscrew"))


def command_json(*arguments, status=0):
    """What the command prints with --json."""
    done = subprocess.run([COMMAND, *map(str, arguments), "--json"], capture_output=True, text=True, check=False)
    if done.returncode != status:
        raise AssertionError(f"leadscrew {' '.join(map(str, arguments))}: status {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)
