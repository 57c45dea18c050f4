# SPDX-License-Identifier: Apache-2.0
"""The notebooks of examples/, executed as a person runs them. Oracles: what the program prints of the
same questions; by hand the knee's line, 1536 (1 - 7 / 10.5) = 512 Nm at 7 rad/s, at 53.8 V
1536 53.8 / 67.2 - 1536 7 / 10.5 = 205.7 Nm."""

import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import program

FOLDER = program.ROOT / "examples/notebooks"
NEEDED = ("nbconvert", "ipykernel")
MISSING = [name for name in NEEDED if importlib.util.find_spec(name) is None]


def printed_by(name):
    """All that the cells of a notebook show, as one text."""
    with tempfile.TemporaryDirectory() as folder:
        words = ["-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", folder]
        done = subprocess.run(
            [sys.executable, *words, FOLDER / name], capture_output=True, text=True, check=False,
            cwd=program.ROOT, env={**os.environ, "HOME": folder, "IPYTHONDIR": folder,
                                   "JUPYTER_CONFIG_DIR": folder},
        )
        assert done.returncode == 0, done.stderr
        notebook = json.loads((pathlib.Path(folder) / name).read_text())
    outputs = [one for cell in notebook["cells"] for one in cell.get("outputs", [])]
    data = [one.get("data", {}) for one in outputs]
    shown = ["".join(one.get("text", "")) for one in outputs]
    return "\n".join(shown + ["".join(of.get(kind, "")) for of in data for kind in of if "text" in kind])


class Notebooks(unittest.TestCase):
    def test_are_both_there_without_outputs(self):
        names = sorted(one.name for one in FOLDER.iterdir())
        self.assertEqual(names, ["what_does_my_log_say.ipynb", "which_region_do_i_train_with.ipynb"])
        for name in names:
            cells = json.loads((FOLDER / name).read_text())["cells"]
            self.assertEqual([one["outputs"] for one in cells if "outputs" in one and one["outputs"]], [])

    @unittest.skipIf(MISSING, "python3-" + ", python3-".join(MISSING) + ": not installed")
    def test_say_which_region_to_train_with(self):
        text = printed_by("which_region_do_i_train_with.ipynb")
        self.assertIn("67.2 V, 298.15 K: reached True, margin 70.0 Nm", text)
        self.assertIn("53.8 V, 298.15 K: reached False, margin -44.3 Nm", text)
        self.assertIn("<th>reached</th><td>False</td>", text)

    @unittest.skipIf(MISSING, "python3-" + ", python3-".join(MISSING) + ": not installed")
    def test_say_what_a_log_says(self):
        text = printed_by("what_does_my_log_say.ipynb")
        log = [f"specs/log/{name}" for name in
               ("bench_as_built.csv", "bench_rig.json", "bench_actuator.json")]
        report = program.printed("identify", log[0], "--rig", log[1], "--actuator", log[2])
        self.assertIn(report["verdict"], text)
        for effect in report["effects_added"]:
            self.assertIn(effect["effect"], text)


if __name__ == "__main__":
    unittest.main()
