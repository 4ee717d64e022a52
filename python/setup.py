"""pip install --no-build-isolation . : in this folder of the source tree, offline.

Where the tree is a release's, the compiled module is that of an installed leadscrew of the same version, if CMake's find_package
knows one that has a module for this interpreter. Otherwise, in a clone (whose version says nothing of its commit), and where
LEADSCREW_BUILD names a folder, it is a target of the project's own build, LEADSCREW_PYTHON: built in that folder or in build/release
of the tree, where what is there is not compiled again.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
TREE = HERE.parent
BUILD = pathlib.Path(os.environ.get("LEADSCREW_BUILD", TREE / "build" / "release"))


class CMakeBuild(build_ext):
    """Has CMake find or build the module, and takes it from there."""

    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        builds = "LEADSCREW_BUILD" in os.environ or (TREE / ".git").exists()
        made = None if builds else installed(target.name)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(made or built(target.name), target)


def installed(name):
    """The module of this name of an installed leadscrew of this version; None where there is none."""
    with tempfile.TemporaryDirectory() as scratch:
        found = pathlib.Path(scratch) / "found"
        subprocess.run(["cmake", "-S", HERE / "installed", "-B", scratch, f"-DVERSION={version()}", f"-DMODULE={name}", f"-DFOUND={found}"],
                       stdout=subprocess.DEVNULL, check=True)
        return pathlib.Path(found.read_text(encoding="utf-8")) if found.exists() else None


def built(name):
    """The module of this name, made by the project's own build."""
    if not (BUILD / "CMakeCache.txt").exists():
        subprocess.check_call(["cmake", "-S", TREE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                               "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DLEADSCREW_PYTHON=ON"])
    elif not (BUILD / "python" / "leadscrew").exists():
        subprocess.check_call(["cmake", "-S", TREE, "-B", BUILD, "-DLEADSCREW_PYTHON=ON"])
    subprocess.check_call(["cmake", "--build", BUILD, "--target", "leadscrew_python"])
    made = sorted((BUILD / "python" / "leadscrew").glob("_core.*.so"))
    if len(made) != 1:
        raise RuntimeError(f"expected one module _core in {BUILD}/python/leadscrew, found {len(made)}")
    if made[0].name != name:
        raise RuntimeError(f"expected {name}, a module for {sys.executable}, found {made[0].name} in {BUILD}: name another "
                           "folder by LEADSCREW_BUILD, configured with -DPython3_EXECUTABLE= for this interpreter")
    return made[0]


def version():
    found = re.search(r"project\(leadscrew VERSION ([0-9.]+)", (TREE / "CMakeLists.txt").read_text(encoding="utf-8"))
    if found is None:
        raise RuntimeError("expected project(leadscrew VERSION …) in CMakeLists.txt, found none")
    return found[1]


(TREE / "build" / "pip").mkdir(parents=True, exist_ok=True)
setup(version=version(), ext_modules=[Extension("leadscrew._core", [])], cmdclass={"build_ext": CMakeBuild})
