"""setup.py takes a module for the interpreter that runs it, and no other; in a release's tree that of an installed leadscrew."""

import importlib.machinery
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from common import TREE

BUILD = pathlib.Path(os.environ["PYTHONPATH"].split(":")[0]).parent
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
        return self.run_setup(folder, LEADSCREW_BUILD=str(folder / "build"), PATH=f"{tools}:{os.environ['PATH']}")

    def run_setup(self, folder, tree=TREE, **environment):
        return subprocess.run([sys.executable, "-B", "setup.py", "-q", "build_ext", "-b", str(folder / "lib"), "-t", str(folder / "temp")],
                              cwd=tree / "python", env={**os.environ, **environment}, capture_output=True, text=True, check=False)

    def install(self, folder, version=None):
        """The project's own files for find_package, with a module that is text; in a prefix of `folder`."""
        config = (BUILD / "leadscrew-config.cmake").read_text(encoding="utf-8")
        ups = re.search(r'CMAKE_CURRENT_LIST_DIR\}/((?:\.\./)+)"', config)[1].count("../")
        files = folder.joinpath("prefix", *["files"] * ups)
        files.mkdir(parents=True)
        (files / "leadscrew-config.cmake").write_text(config, encoding="utf-8")
        (files / "leadscrew-targets.cmake").touch()
        known = (BUILD / "leadscrew-config-version.cmake").read_text(encoding="utf-8")
        if version:
            known = re.sub(r'PACKAGE_VERSION "[0-9.]+"', f'PACKAGE_VERSION "{version}"', known, count=1)
        (files / "leadscrew-config-version.cmake").write_text(known, encoding="utf-8")
        package = folder / "prefix" / "lib" / "python3" / "dist-packages" / "leadscrew"
        package.mkdir(parents=True)
        (package / f"_core{SUFFIX}").write_text("installed")
        return files

    def released(self, folder):
        """What setup.py reads of a release's tree."""
        tree = folder / "tree"
        shutil.copytree(TREE / "python", tree / "python")
        shutil.copy(TREE / "CMakeLists.txt", tree)
        return tree

    def module_of_installed(self, folder, tree, **environment):
        done = self.run_setup(folder, tree, leadscrew_ROOT=str(self.install(folder)), **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (folder / "lib" / "leadscrew" / f"_core{SUFFIX}").read_text()

    def test_takes_the_module_of_an_installed_leadscrew_of_this_version(self):
        with tempfile.TemporaryDirectory() as given:
            folder = pathlib.Path(given)
            self.assertEqual(self.module_of_installed(folder, self.released(folder)), "installed")

    def test_takes_its_own_in_a_clone_whatever_is_installed(self):
        with tempfile.TemporaryDirectory() as given:
            folder = pathlib.Path(given)
            tree = self.released(folder)
            (tree / ".git").mkdir()
            made, tools = tree / "build" / "release" / "python" / "leadscrew" / f"_core{SUFFIX}", folder / "tools"
            for each in (made.parent, tools):
                each.mkdir(parents=True)
            made.write_text("of this clone")
            (tree / "build" / "release" / "CMakeCache.txt").touch()
            (tools / "cmake").write_text("#!/bin/sh\n")
            (tools / "cmake").chmod(0o755)
            self.assertEqual(self.module_of_installed(folder, tree, PATH=f"{tools}:{os.environ['PATH']}"), "of this clone")

    def test_knows_no_installed_leadscrew_of_another_version(self):
        with tempfile.TemporaryDirectory() as given:
            folder = pathlib.Path(given)
            files, found = self.install(folder, "0.1.99"), folder / "found"
            subprocess.run(["cmake", "-S", TREE / "python" / "installed", "-B", folder / "scratch", "-DVERSION=0.1.0",
                            f"-DMODULE=_core{SUFFIX}", f"-DFOUND={found}"], env={**os.environ, "leadscrew_ROOT": str(files)}, stdout=subprocess.DEVNULL, check=True)
            self.assertFalse(found.exists())

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
