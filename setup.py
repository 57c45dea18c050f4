# SPDX-License-Identifier: Apache-2.0
"""Has CMake build the compiled part of the wheel. Environment: TORQUEWRIGHT_BUILD, a folder that
CMake has configured already, whose module is taken (and brought up to date); without, a folder of
its own."""

import os
import pathlib
import re
import subprocess

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version():
    text = (ROOT / "CMakeLists.txt").read_text()
    return re.search(r"project\(\s*torquewright\s+VERSION\s+([\d.]+)", text, re.IGNORECASE)[1]


class BuiltByCMake(build_ext):
    def build_extension(self, extension):
        there = os.environ.get("TORQUEWRIGHT_BUILD")
        folder = pathlib.Path(there or pathlib.Path(self.build_temp, "cmake")).resolve()
        if not (folder / "CMakeCache.txt").exists():
            configure = ["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja"]
            subprocess.run([*configure, "-DCMAKE_BUILD_TYPE=Release"], check=True)
        build = ["cmake", "--build", str(folder), "--target", "torquewright_python"]
        subprocess.run([*build, "--parallel", str(os.cpu_count())], check=True)
        (module,) = (folder / "python" / "torquewright").glob("_core.*.so")
        place = pathlib.Path(self.get_ext_fullpath(extension.name))
        place.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(module), str(place))


setup(
    version=version(),
    ext_modules=[Extension("torquewright._core", sources=[])],
    cmdclass={"build_ext": BuiltByCMake},
)
