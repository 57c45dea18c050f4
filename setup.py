# SPDX-License-Identifier: Apache-2.0
"""Has CMake build the compiled part of the wheel. It is called by ctypes and knows no Python: one
wheel serves every version of it. Environment: TORQUEWRIGHT_BUILD, a folder that CMake has
configured already, whose libraries are taken (and brought up to date); without, a folder of its
own."""

import os
import pathlib
import re
import shutil
import subprocess

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # setuptools before 70.1
    from wheel.bdist_wheel import bdist_wheel

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
            subprocess.run(
                [*configure, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF"], check=True
            )
        build = ["cmake", "--build", str(folder), "--target", "torquewright_python_package"]
        subprocess.run([*build, "--parallel", str(os.cpu_count())], check=True)
        place = pathlib.Path(self.get_ext_fullpath(extension.name)).parent
        place.mkdir(parents=True, exist_ok=True)
        for library in (folder / "python" / "torquewright").glob("*.so"):
            shutil.copy(library, place)
            subprocess.run(["strip", "--strip-unneeded", str(place / library.name)], check=True)


class ForEveryPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(
    version=version(),
    ext_modules=[Extension("torquewright._library", sources=[])],
    cmdclass={"build_ext": BuiltByCMake, "bdist_wheel": ForEveryPython},
)
