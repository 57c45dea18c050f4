# SPDX-License-Identifier: Apache-2.0
"""The package as it is installed works by itself, and holds all that was built. Oracle: the
interpreter, which is shown no other package."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import program
import torquewright


class Installed(unittest.TestCase):
    def test_is_complete(self):
        with tempfile.TemporaryDirectory() as prefix:
            cmake = [os.environ["TORQUEWRIGHT_CMAKE"], "--install", os.environ["TORQUEWRIGHT_BUILD"]]
            done = subprocess.run(
                [*cmake, "--component", "python", "--prefix", prefix], capture_output=True,
                text=True, check=False,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            place = pathlib.Path(prefix) / "lib/python3/dist-packages"
            self.assertEqual([one.name for one in place.iterdir()], ["torquewright"])
            built = pathlib.Path(torquewright.__file__).parent
            for folder in (built, place / "torquewright"):
                names = sorted(one.name for one in folder.iterdir() if one.name != "__pycache__")
                self.assertIn("py.typed", names)
                libraries = [name for name in names if name.endswith(".so")]
                self.assertLessEqual({"_ipopt.so", "_library.so"}, set(libraries))
                sources = program.ROOT / "python/torquewright"
                for source in sources.glob("*.py"):
                    self.assertEqual((folder / source.name).read_text(), source.read_text())
                self.assertEqual(len(names), len(list(sources.glob("*.py"))) + 1 + len(libraries))
            words = "import torquewright; print(torquewright.__file__, torquewright.__version__)"
            done = subprocess.run(
                [sys.executable, "-B", "-c", words], capture_output=True, text=True, check=False,
                cwd=prefix, env={"PYTHONPATH": str(place)},
            )
            self.assertEqual(done.stderr, "")
            file, version = done.stdout.split()
            self.assertEqual(pathlib.Path(file), place / "torquewright/__init__.py")
            self.assertEqual(version, torquewright.__version__)


if __name__ == "__main__":
    unittest.main()
