"""pip install --no-build-isolation . : in this folder of the source tree, offline.

The compiled module is a target of the project's own build, LEADSCREW_PYTHON. It is built in build/release of the tree, where
what is there is not compiled again, or in the folder that LEADSCREW_BUILD names.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
TREE = HERE.parent
BUILD = pathlib.Path(os.environ.get("LEADSCREW_BUILD", TREE / "build" / "release"))


class CMakeBuild(build_ext):
    """Has CMake build the module, and takes it from there."""

    def build_extension(self, extension):
        if not (BUILD / "CMakeCache.txt").exists():
            subprocess.check_call(["cmake", "-S", TREE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                                   "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DLEADSCREW_PYTHON=ON"])
        elif not (BUILD / "python" / "leadscrew").exists():
            subprocess.check_call(["cmake", "-S", TREE, "-B", BUILD, "-DLEADSCREW_PYTHON=ON"])
        subprocess.check_call(["cmake", "--build", BUILD, "--target", "leadscrew_python"])
        made = sorted((BUILD / "python" / "leadscrew").glob("_core.*.so"))
        if len(made) != 1:
            raise RuntimeError(f"expected one module _core in {BUILD}/python/leadscrew, found {len(made)}")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        if made[0].name != target.name:
            raise RuntimeError(f"expected {target.name}, a module for {sys.executable}, found {made[0].name} in {BUILD}: name another "
                               "folder by LEADSCREW_BUILD, configured with -DPython3_EXECUTABLE= for this interpreter")
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(made[0], target)


def version():
    found = re.search(r"project\(leadscrew VERSION ([0-9.]+)", (TREE / "CMakeLists.txt").read_text(encoding="utf-8"))
    if found is None:
        raise RuntimeError("expected project(leadscrew VERSION …) in CMakeLists.txt, found none")
    return found[1]


(TREE / "build" / "pip").mkdir(parents=True, exist_ok=True)
setup(version=version(), ext_modules=[Extension("leadscrew._core", [])], cmdclass={"build_ext": CMakeBuild})
