"""setup.py takes a module for the interpreter that runs it, and no other."""

import importlib.machinery
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from common import TREE

SUFFIX = importlib.machinery.EXTENSION_SUFFIXES[0]


class Setup(unittest.TestCase):
    def build(self, folder, *modules):
        """Runs it on a build folder that has these modules, by a cmake that does nothing."""
        package, tools = folder / "build" / "python" / "leadscrew", folder / "tools"
        for each in (package, tools):
            each.mkdir(parents=True)
        (folder / "build" / "CMakeCache.txt").touch()
        for name in modules:
            (package / name).write_text(name)
        (tools / "cmake").write_text("#!/bin/sh\n")
        (tools / "cmake").chmod(0o755)
        environment = {**os.environ, "LEADSCREW_BUILD": str(folder / "build"), "PATH": f"{tools}:{os.environ['PATH']}"}
        return subprocess.run([sys.executable, "-B", "setup.py", "-q", "build_ext", "-b", str(folder / "lib"), "-t", str(folder / "temp")],
                              cwd=TREE / "python", env=environment, capture_output=True, text=True, check=False)

    def test_takes_the_module_for_this_interpreter(self):
        with tempfile.TemporaryDirectory() as given:
            folder = pathlib.Path(given)
            done = self.build(folder, f"_core{SUFFIX}")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((folder / "lib" / "leadscrew" / f"_core{SUFFIX}").read_text(), f"_core{SUFFIX}")

    def test_refuses_a_module_for_another(self):
        with tempfile.TemporaryDirectory() as given:
            done = self.build(pathlib.Path(given), "_core.cpython-39-x86_64-linux-gnu.so")
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"expected _core{SUFFIX}", done.stderr)
            self.assertIn("found _core.cpython-39-x86_64-linux-gnu.so", done.stderr)
            self.assertIn("LEADSCREW_BUILD", done.stderr)


if __name__ == "__main__":
    unittest.main()
