# SPDX-License-Identifier: Apache-2.0
"""`pip install .` without the network, from the source tree into a fresh virtual environment, with
Debian's setuptools. The compiled part is that of the build that is tested: how CMake builds it from
nothing is the build's own test. Oracle: the interpreter of that environment."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import program

NEEDED = ("setuptools", "wheel", "pip", "venv")
MISSING = [name for name in NEEDED if importlib.util.find_spec(name) is None]


def run(*words, **named):
    return subprocess.run(
        [str(word) for word in words], capture_output=True, text=True, check=False, **named
    )


@unittest.skipIf(MISSING, "python3-" + ", python3-".join(MISSING) + ": not installed")
class Wheel(unittest.TestCase):
    def test_is_installed_by_one_line_and_answers(self):
        with tempfile.TemporaryDirectory() as folder:
            tree = self._tree(pathlib.Path(folder) / "tree")
            place = pathlib.Path(folder) / "fresh"
            made = run(sys.executable, "-m", "venv", "--system-site-packages", place)
            self.assertEqual(made.returncode, 0, made.stderr)
            python = place / "bin/python"
            words = [python, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps"]
            free = {name: of for name, of in os.environ.items() if name != "PYTHONPATH"}
            done = run(*words, ".", cwd=tree, env=free)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            knee = program.ROOT / program.KNEE
            script = (
                "import torquewright as tw, importlib.metadata as m;"
                f"knee = tw.actuator({str(knee)!r});"
                "print(tw.__file__, m.version('torquewright'), knee.need(200.0, 9.1).reached)"
            )
            said = run(python, "-c", script, cwd=folder, env=free)
            self.assertEqual(said.stderr, "")
            file, version, reached = said.stdout.split()
            self.assertTrue(file.startswith(str(place)), file)
            self.assertEqual((version, reached), (program.run("--version")[1].split()[-1], "True"))
            typed = pathlib.Path(file).parent
            self.assertTrue((typed / "py.typed").exists())
            about = next(typed.parent.glob("torquewright-*.dist-info")) / "WHEEL"
            self.assertIn("Tag: py3-none-linux_", about.read_text())  # of no version of Python
            left = run("git", "status", "--porcelain", cwd=program.ROOT).stdout
            self.assertNotIn("egg-info", left)

    def _tree(self, tree):
        """What a source tree has that pip looks at: setuptools leaves things where it works."""
        tree.mkdir()
        for name in ("pyproject.toml", "setup.py", "setup.cfg", "CMakeLists.txt", "README.md"):
            shutil.copy(program.ROOT / name, tree)
        shutil.copytree(program.ROOT / "python", tree / "python")
        return tree


if __name__ == "__main__":
    unittest.main()
