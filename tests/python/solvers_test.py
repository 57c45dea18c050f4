# SPDX-License-Identifier: Apache-2.0
"""Without Ipopt and MuJoCo the package is imported and answers what needs neither; what needs one
says so and what to install. Oracles: the libraries' own lists of what they need, read by binutils;
the dynamic linker, which is shown names that no machine has."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import program
import torquewright

BUILT = pathlib.Path(torquewright.__file__).parent
SOLVERS = ("ipopt", "mujoco", "mpi", "python")
HAS_MUJOCO = (BUILT / "_mujoco.so").exists()


def needed(library):
    said = subprocess.run(["readelf", "-d", BUILT / library], capture_output=True, text=True, check=True)
    return re.findall(r"NEEDED.*\[(.*)\]", said.stdout)


def without_solvers(folder):
    """A copy whose libraries name solvers that are not there."""
    copy = pathlib.Path(folder) / "torquewright"
    shutil.copytree(BUILT, copy, ignore=shutil.ignore_patterns("__pycache__"))
    for library, solver in (("_ipopt.so", "ipopt"), ("_mujoco.so", "mujoco")):
        if not (copy / library).exists():
            continue
        names = [name for name in needed(library) if solver in name]
        assert len(names) == 1, names
        name, bytes_ = names[0].encode(), (copy / library).read_bytes()
        (copy / library).chmod(0o644)
        (copy / library).write_bytes(bytes_.replace(name + b"\0", name.replace(b"lib", b"bil") + b"\0"))


SCRIPT = """
import json
import torquewright as tw
knee, robot = "specs/actuator/d151_knee.json", "specs/robot/hopper.json"
motion, log = "specs/trajectory/hopper_squat.csv", "specs/log/bench_"
answers = {
    "region": tw.actuator(knee).region([9.1]).torque_max_Nm[0],
    "clip": round(float(tw.actuator(knee).clip(500.0, 0.0)), 9),
    "need": tw.actuator(knee).need(200.0, 9.1).reached,
    "lint": tw.lint(knee).kind,
    "check": tw.check("specs/trajectory/knee_extension.csv", {"knee": knee}).verdict,
    "hopper_check": tw.hopper_check(robot, motion).verdict,
    "identify": tw.identify(log + "as_built.csv", log + "rig.json", log + "actuator.json").verdict,
    "optimize": tw.optimize("specs/gearbox/d151_knee.json").status,
    "strength": tw.strength("specs/gearbox/d151_strength.json", torque_Nm=[21.0]).kind,
}
refused = {}
for name, ask in {
    "flip": lambda: tw.flip(robot, task="jump"),
    "replay": lambda: tw.replay(robot, motion, engine="mujoco"),
}.items():
    try:
        ask()
    except tw.Refusal as refusal:
        refused[name] = str(refusal)
print(json.dumps([answers, refused]))
"""


class Solvers(unittest.TestCase):
    def test_are_linked_by_their_own_libraries_alone(self):
        for word in SOLVERS:
            self.assertEqual([name for name in needed("_library.so") if word in name], [], word)
        self.assertTrue(any("ipopt" in name for name in needed("_ipopt.so")))
        if HAS_MUJOCO:
            self.assertTrue(any("mujoco" in name for name in needed("_mujoco.so")))
            self.assertFalse(any("ipopt" in name for name in needed("_mujoco.so")))

    def test_are_asked_for_by_name_where_they_are_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            without_solvers(folder)
            done = subprocess.run(
                [sys.executable, "-B", "-c", SCRIPT], capture_output=True, text=True, check=False,
                cwd=program.ROOT, env={**os.environ, "PYTHONPATH": folder},
            )
        self.assertEqual(done.stderr, "")
        answers, refused = json.loads(done.stdout)
        expected = {"clip": 320.0, "need": True, "lint": "lint_report", "check": "pass",
                    "hopper_check": "pass", "identify": "explained", "optimize": "optimal",
                    "strength": "strength_report"}
        self.assertAlmostEqual(answers.pop("region"), 204.8, places=6)
        self.assertEqual(answers, expected)
        self.assertRegex(refused["flip"], r"^Ipopt: cannot be loaded \(bilipopt\S+: cannot open")
        self.assertIn("install coinor-libipopt1v5", refused["flip"])
        if HAS_MUJOCO:
            self.assertRegex(refused["replay"], r"MuJoCo cannot be loaded \(bilmujoco")
            self.assertIn("install libmujoco", refused["replay"])


if __name__ == "__main__":
    unittest.main()
